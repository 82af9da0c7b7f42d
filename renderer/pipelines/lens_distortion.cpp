#include "renderer/pipelines/lens_distortion.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "renderer/check.h"
#include "renderer/kernels/lens_distortion.h"
#include "renderer/task_order.h"

namespace foverig {
namespace {

std::vector<float> planes_of(const std::vector<ColourSources>& table) {
    std::vector<float> planes(6 * table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            planes[(2 * c) * table.size() + i] = table[i][c].x;
            planes[(2 * c + 1) * table.size() + i] = table[i][c].y;
        }
    }
    return planes;
}

}  // namespace

LensDistortion::LensDistortion(int width_px, int height_px,
                               std::span<const std::vector<ColourSources>> tables, int threads)
    : width_px_(width_px),
      height_px_(height_px),
      arena_(std::make_unique<tbb::task_arena>(threads > 0 ? threads
                                                           : tbb::info::default_concurrency())) {
    const std::size_t pixels =
        static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
    for (const auto& table : tables) {
        RIG_CHECK(table.size() == pixels, "a table has an entry for each of its {} pixels", pixels);
        sources_px_.push_back(planes_of(table));
    }
}

void LensDistortion::apply(std::span<const Image> eyes, Image& panel) const {
    RIG_CHECK(eyes.size() == sources_px_.size(), "there is a table for each of {} eyes",
              eyes.size());
    panel.width_px = width_px_ * static_cast<int>(eyes.size());
    panel.height_px = height_px_;
    panel.pixels.resize(static_cast<std::size_t>(panel.width_px) *
                        static_cast<std::size_t>(panel.height_px));
    const std::size_t plane =
        static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_);
    const auto draw = [&](std::size_t eye, int y) {
        const Image& image = eyes[eye];
        vec3* const share = panel.pixels.data() + eye * static_cast<std::size_t>(width_px_);
        if (image.pixels.empty()) {
            std::fill_n(
                share + static_cast<std::size_t>(y) * static_cast<std::size_t>(panel.width_px),
                width_px_, vec3(0.0F));
            return;
        }
        const DistortRow row{
            sources_px_[eye].data(), plane,           width_px_, image.pixels.data(),
            image.width_px,          image.height_px, share,     panel.width_px};
        row(y);
    };
    constexpr int kRowsATask = 16;
    task_order::before_loop();
    arena_->execute([&] {
        tbb::parallel_for(tbb::blocked_range<int>(0, height_px_, kRowsATask),
                          [&](const tbb::blocked_range<int>& rows) {
                              task_order::task_begins();
                              for (std::size_t eye = 0; eye < eyes.size(); ++eye)
                                  for (int y = rows.begin(); y < rows.end(); ++y) draw(eye, y);
                              task_order::task_ends();
                          });
    });
    task_order::after_loop();
}

Image LensDistortion::apply(std::span<const Image> eyes) const {
    Image panel;
    apply(eyes, panel);
    return panel;
}

}  // namespace foverig
