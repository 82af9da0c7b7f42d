#include "renderer/pipelines/reprojected_eye.h"

#include <algorithm>

namespace foverig {
namespace {

constexpr auto kCopy = [](auto& to, auto from) { std::copy(from.begin(), from.end(), to.data()); };

}  // namespace

ReprojectedEye::ReprojectedEye(EffectMemory& effect_memory, const EffectPlan& plan,
                               const ReprojectionSettings& settings, const EyeView& first_view)
    : EyeImages(effect_memory, plan, settings, first_view, kCopy) {
    MemoryCount& memory = effect_memory.of(Effect::reprojection);
    const bool light = plan.on(Effect::light_buffer);
    const auto block_count = static_cast<std::size_t>((coarse_grid.width_px - 1 + kBlockCells - 1) /
                                                      kBlockCells * (coarse_grid.height_px - 1));
    block_boxes_ = {memory, 4 * ((block_count + 7) / 8 * 8)};
    // First columns past all tiles: the blocks that pad the last eight are met by none.
    std::fill_n(block_boxes_.data(), block_boxes_.size() / 4, std::uint8_t{255});
    const std::size_t capacity = static_cast<std::size_t>(grid.count()) * kTilePixels;
    sample_counts = {memory, static_cast<std::size_t>(grid.count())};
    sample_pixels_ = {memory, capacity + 16};
    sample_flags_ = {memory, capacity};
    sample_colour_ = {memory, capacity};
    sample_light_ = {effect_memory.of(Effect::light_buffer), light ? 3 * capacity : 0};
}

CellBlocks ReprojectedEye::blocks() {
    const std::size_t side = block_boxes_.size() / 4;
    std::uint8_t* const p = block_boxes_.data();
    return {p,
            p + side,
            p + 2 * side,
            p + 3 * side,
            (coarse_grid.width_px - 1 + kBlockCells - 1) / kBlockCells,
            static_cast<int>(side)};
}

Samples ReprojectedEye::samples(int tile) {
    const std::size_t first = static_cast<std::size_t>(tile) * kTilePixels;
    const std::size_t capacity = sample_flags_.size();
    Samples s{sample_pixels_.data() + first,
              sample_flags_.data() + first,
              sample_colour_.data() + first,
              nullptr,
              nullptr,
              nullptr};
    if (!sample_light_.empty()) {
        s.base = sample_light_.data() + first;
        s.diffuse = s.base + capacity;
        s.light = s.diffuse + capacity;
    }
    return s;
}

}  // namespace foverig
