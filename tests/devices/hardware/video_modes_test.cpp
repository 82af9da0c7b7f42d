// What is chosen of a camera's lists, against a kernel that is played.
#include "devices/hardware/video_modes.h"

#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <cerrno>

namespace foverig::hardware {
namespace {

struct Size {
    std::uint32_t format, width_px, height_px;
    std::vector<std::uint32_t> rates_hz;
};

class ListingKernel final : public VideoCalls {
  public:
    std::vector<Size> sizes;
    bool stepwise = false;  ///< 32 to 2048 by 16, 1 to 90 Hz
    bool lists_rates = true;

    int ioctl(int, unsigned long request, void* argument) override {
        switch (request) {
            case VIDIOC_ENUM_FMT:
                return format(*static_cast<v4l2_fmtdesc*>(argument));
            case VIDIOC_ENUM_FRAMESIZES:
                return size(*static_cast<v4l2_frmsizeenum*>(argument));
            case VIDIOC_ENUM_FRAMEINTERVALS:
                return interval(*static_cast<v4l2_frmivalenum*>(argument));
            default:
                return refused();
        }
    }
    int open(const char*) override { return 7; }
    int close(int) override { return 0; }
    void* map(std::size_t, int, std::int64_t) override { return nullptr; }
    int unmap(void*, std::size_t) override { return 0; }
    int wait(int, int) override { return 0; }
    void pause(int) override {}
    std::int64_t monotonic_ns() override { return 0; }

  private:
    static int refused() {
        errno = EINVAL;
        return -1;
    }
    int format(v4l2_fmtdesc& entry) const {
        std::vector<std::uint32_t> formats;
        for (const Size& s : sizes) {
            if (formats.empty() || formats.back() != s.format) formats.push_back(s.format);
        }
        if (entry.index >= formats.size()) return refused();
        entry.pixelformat = formats[entry.index];
        return 0;
    }
    int size(v4l2_frmsizeenum& entry) const {
        if (stepwise) {
            if (entry.index > 0) return refused();
            entry.type = V4L2_FRMSIZE_TYPE_STEPWISE;
            entry.stepwise = {32, 2048, 16, 32, 2048, 16};
            return 0;
        }
        std::uint32_t index = entry.index;
        for (const Size& s : sizes) {
            if (s.format != entry.pixel_format || index-- > 0) continue;
            entry.type = V4L2_FRMSIZE_TYPE_DISCRETE;
            entry.discrete = {s.width_px, s.height_px};
            return 0;
        }
        return refused();
    }
    int interval(v4l2_frmivalenum& entry) const {
        if (!lists_rates) return refused();
        if (stepwise) {
            entry.type = V4L2_FRMIVAL_TYPE_STEPWISE;
            entry.stepwise = {{1, 90}, {1, 1}, {1, 90}};
            return 0;
        }
        for (const Size& s : sizes) {
            if (s.format != entry.pixel_format || s.width_px != entry.width ||
                s.height_px != entry.height || entry.index >= s.rates_hz.size())
                continue;
            entry.type = V4L2_FRMIVAL_TYPE_DISCRETE;
            entry.discrete = {1001, s.rates_hz[entry.index] * 1001};
            return 0;
        }
        return refused();
    }
};

/// As many webcams: fast only where compressed, and a format that nobody here reads.
ListingKernel webcam() {
    ListingKernel kernel;
    kernel.sizes = {
        {V4L2_PIX_FMT_MJPEG, 1280, 720, {30}},   {V4L2_PIX_FMT_MJPEG, 640, 480, {60, 30}},
        {V4L2_PIX_FMT_H264, 640, 480, {120}},    {V4L2_PIX_FMT_YUYV, 1280, 720, {10}},
        {V4L2_PIX_FMT_YUYV, 640, 480, {30, 15}}, {V4L2_PIX_FMT_YUYV, 320, 240, {60}}};
    return kernel;
}

VideoMode chosen(ListingKernel kernel, const VideoWish& wish) {
    const auto modes = nearest_first(offered_modes(kernel, 7, wish), wish);
    return modes.empty() ? VideoMode{} : modes.front();
}

TEST(VideoModes, TheNearestSizeThenTheRateThenWithoutCompression) {
    EXPECT_EQ(chosen(webcam(), {640, 480, 30}), (VideoMode{V4L2_PIX_FMT_YUYV, 640, 480, 30}));
    EXPECT_EQ(chosen(webcam(), {640, 480, 60}), (VideoMode{V4L2_PIX_FMT_MJPEG, 640, 480, 60}));
    EXPECT_EQ(chosen(webcam(), {1280, 720, 30}), (VideoMode{V4L2_PIX_FMT_MJPEG, 1280, 720, 30}));
    EXPECT_EQ(chosen(webcam(), {1920, 1080, 5}), (VideoMode{V4L2_PIX_FMT_YUYV, 1280, 720, 10}));
    EXPECT_EQ(chosen(webcam(), {300, 200, 30}), (VideoMode{V4L2_PIX_FMT_YUYV, 320, 240, 60}));
}

TEST(VideoModes, ColourBeforeGrey) {
    ListingKernel kernel;
    kernel.sizes = {{V4L2_PIX_FMT_GREY, 640, 480, {30}}, {V4L2_PIX_FMT_MJPEG, 640, 480, {30}}};
    EXPECT_EQ(chosen(kernel, {}).format, V4L2_PIX_FMT_MJPEG);
    kernel.sizes.pop_back();
    EXPECT_EQ(chosen(kernel, {}).format, V4L2_PIX_FMT_GREY);
}

TEST(VideoModes, SizesAndRatesWithoutSteps) {
    ListingKernel kernel;
    kernel.sizes = {{V4L2_PIX_FMT_YUYV, 0, 0, {}}};
    kernel.stepwise = true;
    EXPECT_EQ(chosen(kernel, {650, 4000, 120}), (VideoMode{V4L2_PIX_FMT_YUYV, 640, 2048, 90}));
}

TEST(VideoModes, ACameraThatListsNoRatesIsAskedForTheWish) {
    ListingKernel kernel = webcam();
    kernel.lists_rates = false;
    EXPECT_EQ(chosen(kernel, {640, 480, 50}), (VideoMode{V4L2_PIX_FMT_YUYV, 640, 480, 50}));
}

TEST(VideoModes, NothingOfACameraThatOffersNothingKnown) {
    ListingKernel kernel;
    kernel.sizes = {{V4L2_PIX_FMT_H264, 640, 480, {30}}};
    EXPECT_TRUE(offered_modes(kernel, 7, {}).empty());
}

}  // namespace
}  // namespace foverig::hardware
