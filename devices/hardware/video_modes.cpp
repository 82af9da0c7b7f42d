#include "devices/hardware/video_modes.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foverig::hardware {
namespace {

constexpr std::uint32_t kMostEntries = 256;  // of a list: a driver that never ends one is broken

constexpr std::array kFormats{V4L2_PIX_FMT_YUYV, V4L2_PIX_FMT_MJPEG,
                              V4L2_PIX_FMT_GREY};  // dearest to the eye first

std::uint32_t clamped(std::uint32_t value, std::uint32_t least, std::uint32_t most,
                      std::uint32_t step) {
    const std::uint32_t inside = std::clamp(value, least, std::max(least, most));
    return step > 1 ? inside - (inside - least) % step : inside;
}

std::uint32_t rate_of(const v4l2_fract& interval) {
    if (interval.numerator == 0) return 0;
    return (interval.denominator + interval.numerator / 2) / interval.numerator;
}

void append_rates(VideoCalls& calls, int file, VideoMode mode, const VideoWish& wish,
                  std::vector<VideoMode>& modes) {
    v4l2_frmivalenum entry{};
    entry.pixel_format = mode.format;
    entry.width = mode.width_px;
    entry.height = mode.height_px;
    for (; entry.index < kMostEntries; ++entry.index) {
        if (calls.ioctl(file, VIDIOC_ENUM_FRAMEINTERVALS, &entry) < 0) break;
        if (entry.type != V4L2_FRMIVAL_TYPE_DISCRETE) {
            const std::uint32_t slowest = rate_of(entry.stepwise.max);
            mode.rate_hz = clamped(wish.rate_hz, slowest, rate_of(entry.stepwise.min), 1);
            modes.push_back(mode);
            return;
        }
        mode.rate_hz = rate_of(entry.discrete);
        if (mode.rate_hz > 0) modes.push_back(mode);
    }
    if (entry.index > 0) return;
    mode.rate_hz = wish.rate_hz;
    modes.push_back(mode);
}

void append_sizes(VideoCalls& calls, int file, std::uint32_t format, const VideoWish& wish,
                  std::vector<VideoMode>& modes) {
    v4l2_frmsizeenum entry{};
    entry.pixel_format = format;
    for (; entry.index < kMostEntries; ++entry.index) {
        if (calls.ioctl(file, VIDIOC_ENUM_FRAMESIZES, &entry) < 0) return;
        VideoMode mode{.format = format};
        if (entry.type != V4L2_FRMSIZE_TYPE_DISCRETE) {
            const v4l2_frmsize_stepwise& s = entry.stepwise;
            mode.width_px = clamped(wish.width_px, s.min_width, s.max_width, s.step_width);
            mode.height_px = clamped(wish.height_px, s.min_height, s.max_height, s.step_height);
            append_rates(calls, file, mode, wish, modes);
            return;
        }
        mode.width_px = entry.discrete.width;
        mode.height_px = entry.discrete.height;
        append_rates(calls, file, mode, wish, modes);
    }
}

double apart(std::uint32_t a, std::uint32_t b) {
    return std::abs(std::log(static_cast<double>(a) / static_cast<double>(b)));
}

/// Sizes in octaves; a tenth of one is worth a rate of half.
double distance(const VideoMode& mode, const VideoWish& wish) {
    constexpr double kSlower = 0.1, kFaster = 0.01, kWorseFormat = 1e-4;
    const double size = apart(mode.width_px, wish.width_px) + apart(mode.height_px, wish.height_px);
    const double rate =
        (mode.rate_hz < wish.rate_hz ? kSlower : kFaster) * apart(mode.rate_hz, wish.rate_hz);
    const auto place = std::find(kFormats.begin(), kFormats.end(), mode.format) - kFormats.begin();
    return size + rate + kWorseFormat * static_cast<double>(place);
}

}  // namespace

std::vector<VideoMode> tracker_modes() {
    return {{.format = V4L2_PIX_FMT_GREY, .width_px = 752, .height_px = 480},
            {.format = V4L2_PIX_FMT_YUYV, .width_px = 376, .height_px = 480}};
}

std::vector<VideoMode> offered_modes(VideoCalls& calls, int file, const VideoWish& wish) {
    std::vector<VideoMode> modes;
    v4l2_fmtdesc entry{};
    entry.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    for (; entry.index < kMostEntries; ++entry.index) {
        if (calls.ioctl(file, VIDIOC_ENUM_FMT, &entry) < 0) break;
        if (std::find(kFormats.begin(), kFormats.end(), entry.pixelformat) != kFormats.end()) {
            append_sizes(calls, file, entry.pixelformat, wish, modes);
        }
    }
    return modes;
}

std::vector<VideoMode> nearest_first(std::vector<VideoMode> modes, const VideoWish& wish) {
    std::erase_if(modes, [](const VideoMode& mode) {
        return mode.width_px == 0 || mode.height_px == 0 || mode.rate_hz == 0;
    });
    std::stable_sort(modes.begin(), modes.end(), [&](const VideoMode& a, const VideoMode& b) {
        return distance(a, wish) < distance(b, wish);
    });
    return modes;
}

}  // namespace foverig::hardware
