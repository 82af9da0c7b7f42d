#include "renderer/pipelines/lens_distortion.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "renderer/check.h"
#include "renderer/task_order.h"

namespace foverig {
namespace {

/// Texel and share of the next one; the image's very edge is inside and held.
void split(float at_px, int size_px, int& texel, std::uint16_t& share) {
    const float centre = clamp_to(at_px - 0.5F, 0.0F, static_cast<float>(size_px - 1));
    texel = std::min(static_cast<int>(centre), size_px - 2);
    share =
        static_cast<std::uint16_t>(std::lround((centre - static_cast<float>(texel)) * kLensShare));
}

LensSource source_at(const vec2& at_px, const PixelSize& eye) {
    const bool inside = at_px.x >= 0.0F && at_px.x <= static_cast<float>(eye.width_px) &&
                        at_px.y >= 0.0F && at_px.y <= static_cast<float>(eye.height_px);
    LensSource source;
    if (!inside) return source;  // so is NaN
    int x = 0;
    int y = 0;
    split(at_px.x, eye.width_px, x, source.right);
    split(at_px.y, eye.height_px, y, source.lower);
    source.texel = y * eye.width_px + x;
    return source;
}

}  // namespace

LensDistortion::LensDistortion(const PixelSize& share, const PixelSize& eye,
                               std::span<const std::vector<ColourSources>> tables, int threads)
    : share_(share),
      eye_(eye),
      arena_(std::make_unique<tbb::task_arena>(threads > 0 ? threads
                                                           : tbb::info::default_concurrency())) {
    RIG_CHECK(eye.width_px >= 2 && eye.height_px >= 2, "an eye's image of {}x{} has four texels",
              eye.width_px, eye.height_px);
    for (const auto& table : tables) {
        RIG_CHECK(table.size() == share.count(), "a table has an entry for each of its {} pixels",
                  share.count());
        auto& sources = sources_.emplace_back();
        sources.reserve(3 * table.size());
        for (const ColourSources& colours : table)
            for (const vec2& at_px : colours) sources.push_back(source_at(at_px, eye));
    }
}

void LensDistortion::apply(std::span<const View<const Half4>> eyes, Image& panel) const {
    RIG_CHECK(eyes.size() == sources_.size(), "there is a table for each of {} eyes", eyes.size());
    for (const View<const Half4>& eye : eyes)
        RIG_CHECK(eye.empty() || eye.size == eye_.count(), "an eye's image has {} pixels",
                  eye_.count());
    panel.width_px = share_.width_px * static_cast<int>(eyes.size());
    panel.height_px = share_.height_px;
    panel.pixels.resize(share_.count() * eyes.size());
    const auto draw = [&](std::size_t eye, int y) {
        vec3* const share = panel.pixels.data() + eye * static_cast<std::size_t>(share_.width_px);
        if (eyes[eye].empty()) {
            std::fill_n(
                share + static_cast<std::size_t>(y) * static_cast<std::size_t>(panel.width_px),
                share_.width_px, vec3(0.0F));
            return;
        }
        const DistortRow row{sources_[eye].data(), share_.width_px, eyes[eye].data,
                             eye_.width_px,        share,           panel.width_px};
        row(y);
    };
    constexpr int kRowsATask = 16;
    task_order::before_loop();
    arena_->execute([&] {
        tbb::parallel_for(tbb::blocked_range<int>(0, share_.height_px, kRowsATask),
                          [&](const tbb::blocked_range<int>& rows) {
                              task_order::task_begins();
                              for (std::size_t eye = 0; eye < eyes.size(); ++eye)
                                  for (int y = rows.begin(); y < rows.end(); ++y) draw(eye, y);
                              task_order::task_ends();
                          });
    });
    task_order::after_loop();
}

}  // namespace foverig
