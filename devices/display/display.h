#pragma once
// What shows a frame: a headset, a window or a simulated panel.
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "devices/camera/any_lens.h"
#include "devices/display/panel_timing.h"
#include "devices/math.h"
#include "devices/time.h"

namespace foverig {

/// What is shown with a frame beside its pixels.
struct FrameOnPanel {
    std::uint64_t frame_id = 0;
    std::uint8_t latency_level = 16;  ///< grey of the corner pixel (LatencyTester); 16 is idle
};

/// An eye's undistorted picture, which spans its frustum (Dk2Optics): rows from the top, four
/// halves a pixel, linear red, green and blue, the fourth unused.
struct EyePicture {
    int width_px = 0, height_px = 0;
    /// Called at most once, and only where the graphics card could not do by itself.
    std::function<std::span<const std::byte>()> half_rgba;
    /// Copies it into a 2D texture of the current OpenGL context (RGBA16F, of its size) without the
    /// host; false: it cannot. Empty: there is no such way.
    std::function<bool(unsigned int texture)> copy_to_texture{};
};

/// The colour of an eye's pixels that met nothing, where a camera's picture is to be seen there:
/// black to any eye, exact in halves, and no surface's.
inline constexpr std::array<float, 3> kNothingMet{0x1p-13F, 0x1p-12F, 0x1p-13F};

/// What a camera on the headset sees, to be shown where an eye's picture met nothing. It looks as
/// the head does; what it sees lies far away.
struct BehindPicture {
    int width_px = 0, height_px = 0;
    std::span<const std::uint8_t> srgb;  ///< rows from the top without padding, three bytes a pixel
    bool changed = true;                 ///< it is another one than at the last draw
    camera::AnyLens lens;                ///< in pixels of this picture
    dquat world_from_camera{1, 0, 0, 0};  ///< when it was exposed; a head's axes
};

/// What it takes to draw a frame. Arrays: left, right.
struct FramePictures {
    std::size_t eyes = 0;  ///< 1: the left one only
    std::array<EyePicture, 2> pictures;
    std::array<dquat, 2> world_from_head{};  ///< what the pictures were rendered for
    /// The newest of that, for the light of each eye; asked for as late as possible, at most once.
    std::function<std::array<dquat, 2>()> newest;
    std::optional<BehindPicture> behind{};  ///< absent: black is black
};

/// Where the time of drawing went.
struct DrawTimes {
    Nanoseconds upload{};  ///< pictures to where they are drawn from
    Nanoseconds lens{};    ///< late warp, lens distortion and whatever lies on top
};

/// Which scan-out a frame made.
struct Presentation {
    std::uint64_t frame_id = 0;
    std::uint64_t vsync_number = 0;  ///< counts from the display's first
    HostTime vsync{};                ///< start of the scan-out that shows it
    bool replaced = false;           ///< an earlier frame of the same vsync was never seen
};

/// How far the vsyncs can be trusted.
struct VsyncKnowledge {
    enum class Source {
        simulation,  ///< exact
        display,     ///< when the display took a frame
        own_clock    ///< a grid of the display's rate that nothing ties to the light
    };
    Source source = Source::simulation;
    Nanoseconds error{};  ///< of a vsync, one way; a delay that never changes is not in it
};

class Display {
  public:
    virtual ~Display() = default;
    virtual const PanelTiming& timing() const = 0;
    virtual VsyncKnowledge vsync_knowledge() const { return {}; }
    /// The first vsync at or after `at`.
    virtual HostTime next_vsync(HostTime at) const = 0;
    /// False: only times are simulated; draw() need not be called.
    virtual bool draws_pictures() const { return false; }
    /// Draws what the next present() shows, on the frame's time.
    virtual DrawTimes draw(const FramePictures&) { return {}; }
    /// Hands over a finished frame at `submit`; submits do not go back in time. It is scanned out
    /// from the first vsync that its submit time makes.
    virtual Presentation present(const FrameOnPanel& frame, HostTime submit) = 0;
};

}  // namespace foverig
