#include "renderer/pipelines/reference.h"

#include <algorithm>
#include <cmath>

#include "renderer/pipelines/frame/eye_image.h"

namespace foverig {
namespace {

constexpr int kMostSamples = 1 << 17;  // two halves of 2^16 indices

bool same_view(const EyeView& a, const EyeView& b) {
    return a.width_px == b.width_px && a.height_px == b.height_px && a.tan_left == b.tan_left &&
           a.tan_right == b.tan_right && a.tan_down == b.tan_down && a.tan_up == b.tan_up &&
           a.position_m == b.position_m && a.world_from_eye == b.world_from_eye;
}

/// Gaze and frame number do not change what there is to see.
bool same_sight(const FrameInput& a, const FrameInput& b) {
    return a.time_s == b.time_s &&
           std::equal(
               a.eyes.begin(), a.eyes.end(), b.eyes.begin(), b.eyes.end(),
               [](const EyeInput& x, const EyeInput& y) { return same_view(x.view, y.view); });
}

int queue_tile(TileScratch& s, const TileRect& rect) {
    int n = 0;
    for (const std::uint16_t at : kCoherentOrder) {
        const int x = at % kTile;
        const int y = at / kTile;
        if (x < rect.width && y < rect.height)
            s.pixels[static_cast<std::size_t>(n++)] = pack_pixel(
                static_cast<std::uint32_t>(rect.x0 + x), static_cast<std::uint32_t>(rect.y0 + y));
    }
    return n;
}

}  // namespace

ReferenceRenderer::ReferenceRenderer(std::shared_ptr<const Scene> scene,
                                     const RenderSettings& settings)
    : core_(std::move(scene), settings) {
    for (int i = 0; i < core_.backend().threads(); ++i)
        scratches_.emplace_back(core_.memory().base());
}

void ReferenceRenderer::start_again(const FrameInput& input) {
    shown_ = input;
    samples_ = 0;
    error_ = -1.0;
    eyes_.resize(input.eyes.size());
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        Eye& eye = eyes_[i];
        const EyeView& view = input.eyes[i].view;
        eye.grid = {view.width_px, view.height_px};
        for (auto& half : eye.halves)
            half = Buffer<dvec3>(core_.memory().base(), pixel_count(view));
        eye.squares =
            Buffer<dvec2>(core_.memory().base(), static_cast<std::size_t>(eye.grid.count()));
        eye.shown = Buffer<Half4>(core_.memory().base(), pixel_count(view));
    }
}

bool ReferenceRenderer::done() const {
    const ReferenceSettings& s = core_.settings().reference;
    const bool precise = s.target_error > 0.0 && error_ >= 0.0 && error_ <= s.target_error;
    return precise || samples_ >= std::clamp(s.samples, 1, kMostSamples);
}

void ReferenceRenderer::add_samples(Eye& eye, const EyeView& view, int count) {
    const ShadingFrame frame = core_.shading_frame(view);
    core_.backend().for_tiles(eye.grid.count(), [&](Lane& lane, int thread, int tile) {
        TileScratch& scratch = core_.scratch(thread);
        const int n = queue_tile(scratch, eye.grid.rect(tile));
        for (int k = samples_; k < samples_ + count; ++k) {
            const auto half = static_cast<std::uint32_t>(k & 1);
            const PathSampler sampler{hash32(core_.settings().seed, half),
                                      static_cast<std::uint32_t>(k >> 1)};
            trace_paths(lane, scratch, scratches_[static_cast<std::size_t>(thread)], frame, n,
                        sampler, std::max(0, core_.settings().reference.max_bounces),
                        {eye.halves[half].view(), view.width_px});
        }
        scratch.sampled_pixels += static_cast<std::uint64_t>(n);
    });
}

void ReferenceRenderer::measure(Eye& eye) {
    const int odd_samples = samples_ / 2;
    const double odd_count = odd_samples;
    const double even_count = samples_ - odd_samples;
    core_.backend().for_tiles(eye.grid.count(), [&](Lane& lane, int, int tile) {
        lane.launch("estimate_error", 1, [&](int) {
            const TileRect r = eye.grid.rect(tile);
            dvec2 sum(0.0);
            for (int y = r.y0; y < r.y0 + r.height; ++y) {
                for (int x = r.x0; x < r.x0 + r.width; ++x) {
                    const std::size_t at =
                        static_cast<std::size_t>(y) * static_cast<std::size_t>(eye.grid.width_px) +
                        static_cast<std::size_t>(x);
                    const dvec3 a = eye.halves[0][at] / even_count;
                    const dvec3 b = eye.halves[1][at] / odd_count;
                    const dvec3 off = 0.5 * (a - b);
                    const dvec3 mean = 0.5 * (a + b);
                    sum += dvec2(glm::dot(off, off), glm::dot(mean, mean));
                }
            }
            eye.squares[static_cast<std::size_t>(tile)] = sum;
        });
    });
}

vec3 ReferenceRenderer::mean(const Eye& eye, std::size_t pixel) const {
    return vec3((eye.halves[0][pixel] + eye.halves[1][pixel]) / std::max(1.0, 1.0 * samples_));
}

void ReferenceRenderer::show(Eye& eye) {
    core_.backend().launch("show_mean", eye.grid.height_px, [&](int y) {
        const auto width = static_cast<std::size_t>(eye.grid.width_px);
        const std::size_t first = static_cast<std::size_t>(y) * width;
        for (std::size_t i = first; i < first + width; ++i)
            eye.shown[i] = pack_half4(vec4(representable(mean(eye, i)), 0.0F));
    });
}

FrameStats ReferenceRenderer::render(const FrameInput& input) {
    core_.begin_frame(input);
    if (eyes_.empty() || !same_sight(input, shown_)) start_again(input);
    std::uint64_t all_pixels = 0;
    for (const EyeInput& eye : input.eyes) all_pixels += pixel_count(eye.view);
    if (done()) return core_.end_frame(all_pixels);
    const int count =
        std::min(kSamplesPerCall,
                 std::clamp(core_.settings().reference.samples, 1, kMostSamples) - samples_);
    for (std::size_t i = 0; i < eyes_.size(); ++i) add_samples(eyes_[i], input.eyes[i].view, count);
    samples_ += count;
    for (Eye& eye : eyes_) show(eye);
    if (samples_ < 2) return core_.end_frame(all_pixels);
    dvec2 sum(0.0);
    for (Eye& eye : eyes_) {
        measure(eye);
        for (const dvec2& square : eye.squares.view())
            sum += square;  // in the tiles' order, whoever measured them
    }
    error_ = sum.y > 0.0 ? std::sqrt(sum.x / sum.y) : 0.0;
    return core_.end_frame(all_pixels);
}

Image ReferenceRenderer::image(int eye) const {
    const Eye& e = eyes_.at(static_cast<std::size_t>(eye));
    Image image{e.grid.width_px, e.grid.height_px, {}};
    image.pixels.resize(e.halves[0].size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = mean(e, i);
    return image;
}

View<const Half4> ReferenceRenderer::pixels(int eye) const {
    return eyes_.at(static_cast<std::size_t>(eye)).shown.view();
}

}  // namespace foverig
