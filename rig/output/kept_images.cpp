#include "rig/output/kept_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace foverig {
namespace {

constexpr float kErrorGain = 8.0F;
constexpr std::array<const char*, 2> kEyeNames{"left", "right"};

float as_seen(float linear) {
    return srgb_from_linear(std::clamp(linear, 0.0F, 1.0F));
}

/// Where the eye looks, from the top left corner of its image.
dvec2 gaze_px_of(const EyeInput& eye) {
    const EyeView& v = eye.view;
    const dvec3 gaze(eye.gaze);
    const double x = double{v.tan_left} - gaze.x / gaze.z;
    const double y = double{v.tan_up} + gaze.y / gaze.z;
    return {x * v.width_px / (double{v.tan_left} + double{v.tan_right}),
            y * v.height_px / (double{v.tan_up} + double{v.tan_down})};
}

}  // namespace

KeptImages::KeptImages(const Scenario& scenario)
    : settings_(scenario.images), on_wall_clock_(scenario.clock == "wall") {}

bool KeptImages::wanted(const FrameInput& input, double share) const {
    if (!settings_.frames.empty()) {
        const auto& frames = settings_.frames;
        return std::find(frames.begin(), frames.end(), std::int64_t{input.frame}) != frames.end();
    }
    const auto kept = static_cast<double>(frames_.size());
    if (kept >= settings_.count) return false;
    // Copying takes time that a wall clock does not forgive: there, only the last frame is kept.
    if (on_wall_clock_) return share >= 1.0;
    return share >= (kept + 1.0) / settings_.count;
}

bool KeptImages::frame_done(const FrameInput& input, const Renderer& renderer, double share) {
    if (!wanted(input, share)) return false;
    keep(input, renderer);
    return true;
}

void KeptImages::run_done(const FrameInput& last, const Renderer& renderer) {
    if (frames_.empty() && settings_.frames.empty() && settings_.count > 0) keep(last, renderer);
}

void KeptImages::keep(const FrameInput& input, const Renderer& renderer) {
    Frame frame{input, {}};
    for (int eye = 0; eye < static_cast<int>(input.eyes.size()); ++eye) {
        frame.eyes.push_back({.final = renderer.image(eye),
                              .sampling = renderer.sampling_mask(eye),
                              .resampling = renderer.resampling_mask(eye),
                              .full = {},
                              .error = {}});
    }
    frames_.push_back(std::move(frame));
}

void KeptImages::compare_with(Renderer& full, const std::function<bool()>& stop_requested) {
    for (Frame& frame : frames_) {
        if (stop_requested()) return;
        full.render(frame.input);
        for (std::size_t eye = 0; eye < frame.eyes.size(); ++eye) {
            EyeImages& images = frame.eyes[eye];
            images.full = full.image(static_cast<int>(eye));
            images.error = difference(images.final, images.full, kErrorGain);
            images.mean_absolute_error = mean_absolute_error(images.final, images.full);
        }
    }
}

std::vector<std::int64_t> KeptImages::missed() const {
    std::vector<std::int64_t> missed = settings_.frames;
    for (const Frame& frame : frames_) std::erase(missed, std::int64_t{frame.input.frame});
    return missed;
}

nlohmann::json KeptImages::write(const std::filesystem::path& folder, const LensPass* lens) const {
    nlohmann::json list = nlohmann::json::array();
    std::filesystem::create_directories(folder / "images");
    for (const Frame& frame : frames_) {
        const auto add = [&](const char* eye, const char* kind, const auto& image) {
            if (image.pixels.empty()) return;
            const std::string name = fmt::format("images/frame_{:06}{}{}_{}.png", frame.input.frame,
                                                 *eye == '\0' ? "" : "_", eye, kind);
            write_png(folder / name, image);
            list.push_back(
                {{"frame", frame.input.frame}, {"eye", eye}, {"kind", kind}, {"file", name}});
        };
        for (std::size_t eye = 0; eye < frame.eyes.size(); ++eye) {
            const EyeImages& images = frame.eyes[eye];
            add(kEyeNames[eye], "final", images.final);
            if (const auto gaze_px = gaze_px_of(frame.input.eyes[eye]);
                !images.final.pixels.empty())
                list.back()["gaze_px"] = {gaze_px.x, gaze_px.y};
            add(kEyeNames[eye], "full", images.full);
            add(kEyeNames[eye], "sampling", images.sampling);
            add(kEyeNames[eye], "resampling", images.resampling);
            add(kEyeNames[eye], "error", images.error);
            if (images.mean_absolute_error >= 0.0) {
                list.back()["mean_absolute_error"] = images.mean_absolute_error;
            }
        }
        if (lens == nullptr) continue;
        std::vector<Image> finals;
        for (const EyeImages& images : frame.eyes) finals.push_back(images.final);
        add("", "panel", lens->picture(finals));
    }
    return list;
}

Image difference(const Image& a, const Image& b, float gain) {
    Image out{a.width_px, a.height_px, {}};
    out.pixels.reserve(a.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        vec3 seen(0.0F);
        for (int c = 0; c < 3; ++c) {
            const float apart = std::abs(as_seen(a.pixels[i][c]) - as_seen(b.pixels[i][c]));
            seen[c] = linear_from_srgb(std::min(1.0F, gain * apart));
        }
        out.pixels.push_back(seen);
    }
    return out;
}

}  // namespace foverig
