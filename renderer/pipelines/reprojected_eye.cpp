#include "renderer/pipelines/reprojected_eye.h"

#include <algorithm>
#include <cmath>

#include "renderer/pipelines/eye_image.h"

namespace foverig {
namespace {

/// The paper's 256x318 at 1182x1464, in proportion; at least a 2x2 grid.
int support_size(int setting_px, int size_px, double paper_support_px, double paper_px) {
    const int wanted = setting_px > 0
                           ? setting_px
                           : static_cast<int>(std::lround(size_px * paper_support_px / paper_px));
    return std::clamp(wanted, 2, std::max(2, size_px));
}

/// Pixel of support sample i: the grid's corners are the image's corner pixels.
int support_pixel(int i, int count, int size_px) {
    return static_cast<int>(std::lround(static_cast<double>(i) * (size_px - 1) / (count - 1)));
}

void fill_axis(int count, int size_px, Buffer<std::int16_t>& index_of,
               Buffer<std::int16_t>& cell_of, Buffer<std::int16_t>& cell_from_px,
               Buffer<float>& source_px) {
    std::fill_n(index_of.data(), index_of.size(), std::int16_t{-1});
    for (int i = 0; i < count; ++i) {
        const int pixel = support_pixel(i, count, size_px);
        index_of[static_cast<std::size_t>(pixel)] = static_cast<std::int16_t>(i);
        source_px[static_cast<std::size_t>(i)] = static_cast<float>(pixel) + 0.5F;
    }
    // The outermost vertices move out to the image's edge, so that a still eye covers every pixel.
    source_px[0] = 0.0F;
    source_px[static_cast<std::size_t>(count - 1)] = static_cast<float>(size_px);
    cell_from_px[static_cast<std::size_t>(count)] = static_cast<std::int16_t>(size_px);
    for (int p = size_px - 1; p >= 0; --p) {
        const int cell = p * count / size_px;
        cell_of[static_cast<std::size_t>(p)] = static_cast<std::int16_t>(cell);
        cell_from_px[static_cast<std::size_t>(cell)] = static_cast<std::int16_t>(p);
    }
}

}  // namespace

ReprojectedEye::ReprojectedEye(EffectMemory& effect_memory, const EffectPlan& plan,
                               const ReprojectionSettings& settings, const EyeView& first_view)
    : grid{first_view.width_px, first_view.height_px},
      coarse_grid{support_size(settings.support_width_px, first_view.width_px, 256.0, 1182.0),
                  support_size(settings.support_height_px, first_view.height_px, 318.0, 1464.0)},
      view(first_view),
      last_view(first_view) {
    const auto width = static_cast<std::size_t>(grid.width_px);
    const auto height = static_cast<std::size_t>(grid.height_px);
    const auto columns = static_cast<std::size_t>(coarse_grid.width_px);
    const auto rows = static_cast<std::size_t>(coarse_grid.height_px);
    const std::size_t pixels = pixel_count(first_view);
    const std::size_t cells = columns * rows;
    const bool light = plan.on(Effect::light_buffer);
    MemoryCount& memory = effect_memory.of(Effect::reprojection);
    MemoryCount& light_memory = effect_memory.of(Effect::light_buffer);
    support_column = {memory, width};
    support_row = {memory, height};
    coarse_column = {memory, width};
    coarse_row = {memory, height};
    coarse_column_from_px = {memory, columns + 1};
    coarse_row_from_px = {memory, rows + 1};
    source_x_px = {memory, columns + kBlockCells};
    source_y_px = {memory, rows};
    fill_axis(coarse_grid.width_px, grid.width_px, support_column, coarse_column,
              coarse_column_from_px, source_x_px);
    fill_axis(coarse_grid.height_px, grid.height_px, support_row, coarse_row, coarse_row_from_px,
              source_y_px);
    const std::size_t vertices = cells + kBlockCells;  // the last vector reads past the last row
    vertex_x_px = {memory, vertices};
    vertex_y_px = {memory, vertices};
    vertex_inverse_depth = {memory, vertices};
    cell_facing = {memory, cells};
    for (std::size_t g = 0; g < 2; ++g) {
        colour_[g] = {g == 0 ? effect_memory.base() : memory, pixels};  // any pipeline has one
        info_[g] = {memory, pixels};
        light_[g] = {light_memory, light ? pixels : 0};
        support_colour_[g] = {memory, cells};
        support_light_[g] = {light_memory, light ? cells : 0};
        support_depth_m_[g] = {memory, cells};
    }
    const auto block_count = static_cast<std::size_t>((coarse_grid.width_px - 1 + kBlockCells - 1) /
                                                      kBlockCells * (coarse_grid.height_px - 1));
    block_boxes_ = {memory, 4 * ((block_count + 7) / 8 * 8)};
    // First columns past all tiles: the blocks that pad the last eight are met by none.
    std::fill_n(block_boxes_.data(), block_boxes_.size() / 4, std::uint8_t{255});
    coarse_values_ = {memory, 3 * cells};
    coarse_marked_ = {memory, cells};
    const std::size_t capacity = static_cast<std::size_t>(grid.count()) * kTilePixels;
    sample_counts = {memory, static_cast<std::size_t>(grid.count())};
    sample_pixels_ = {memory, capacity + 16};
    sample_flags_ = {memory, capacity};
    sample_colour_ = {memory, capacity};
    sample_light_ = {light_memory, light ? 3 * capacity : 0};
}

HistoryImages ReprojectedEye::history(int generation) {
    const auto g = static_cast<std::size_t>(generation);
    return {colour_[g].data(), info_[g].data(), light_[g].data()};
}

SupportImages ReprojectedEye::support_images(int generation) {
    const auto g = static_cast<std::size_t>(generation);
    return {support_colour_[g].data(), support_light_[g].data(), support_depth_m_[g].data(),
            coarse_grid.width_px, coarse_grid.height_px};
}

DepthMesh ReprojectedEye::mesh() const {
    return {vertex_x_px.data(),   vertex_y_px.data(), vertex_inverse_depth.data(),
            source_x_px.data(),   source_y_px.data(), coarse_grid.width_px,
            coarse_grid.height_px};
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

CoarseView ReprojectedEye::coarse() {
    const std::size_t cells = coarse_marked_.size();
    float* const p = coarse_values_.data();
    return {p,
            p + cells,
            p + 2 * cells,
            coarse_marked_.data(),
            coarse_grid.width_px,
            coarse_grid.height_px};
}

CoarseLookup ReprojectedEye::resampled() const {
    return {has_history ? coarse_marked_.data() : nullptr,
            coarse_column.data(),
            coarse_row.data(),
            coarse_column_from_px.data(),
            coarse_row_from_px.data(),
            coarse_grid.width_px,
            coarse_grid.height_px};
}

SupportLookup ReprojectedEye::support_lookup() {
    return {support(),
            static_cast<float>(coarse_grid.width_px - 1) /
                static_cast<float>(std::max(1, grid.width_px - 1)),
            static_cast<float>(coarse_grid.height_px - 1) /
                static_cast<float>(std::max(1, grid.height_px - 1))};
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
