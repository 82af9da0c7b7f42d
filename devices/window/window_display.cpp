#include "devices/window/window_display.h"

#include <vector>

namespace foverig::window {
namespace {

constexpr int kTrialSwaps = 24;

double nominal_hz(const Window& window, double rate_hz) {
    return window.refresh_hz() > 0 ? window.refresh_hz() : rate_hz;
}

/// Directions in the axes of `from` to those of `to`; both are in the world.
dmat3 turn_between(const dquat& from, const dquat& to) {
    return glm::mat3_cast(glm::conjugate(to) * from);
}

/// The grey of the corner as the panel's memory gets it: no sRGB on the way.
void paint_latency_pixel(const PanelView::Rectangle& at, std::uint8_t level) {
    const float grey = static_cast<float>(level) / 255.0F;
    glEnable(GL_SCISSOR_TEST);
    glScissor(at.x_px, at.y_px, at.width_px, at.height_px);
    glClearColor(grey, grey, grey, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

WindowDisplay::WindowDisplay(Window& window, LensPainter& painter, const Clock& clock,
                             Overlay overlay, const Settings& settings)
    : window_(window),
      painter_(painter),
      clock_(clock),
      overlay_(std::move(overlay)),
      vsyncs_(nominal_hz(window, settings.rate_hz), clock.now()) {
    std::vector<HostTime> returns;
    for (int i = 0; settings.wait_vsync && i < kTrialSwaps; ++i) {
        glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        window_.swap();
        returns.push_back(clock_.now());
    }
    // Whose rate is not told could be any that a slow driver happens to keep.
    if (window_.refresh_hz() > 0) vsyncs_.judge(returns);
    timing_ = PanelTiming::at(vsyncs_.rate_hz());
}

VsyncKnowledge WindowDisplay::vsync_knowledge() const {
    using Source = VsyncKnowledge::Source;
    return {vsyncs_.measured() ? Source::display : Source::own_clock, vsyncs_.error()};
}

DrawTimes WindowDisplay::draw(const FramePictures& frame) {
    const HostTime begin = stopwatch_.now();
    for (std::size_t i = 0; i < frame.eyes; ++i)
        painter_.fill(i == 0 ? Eye::left : Eye::right, frame.pictures[i]);
    if (frame.behind) painter_.fill(*frame.behind);
    glFinish();  // so that the pose is asked for when nothing but the drawing is left
    const HostTime uploaded = stopwatch_.now();
    const std::array<dquat, 2> newest = frame.newest ? frame.newest() : frame.world_from_head;
    std::array<dmat3, 2> rendered_from_newest{dmat3(1.0), dmat3(1.0)};
    if (frame.newest) {
        for (std::size_t i = 0; i < frame.eyes; ++i)
            rendered_from_newest[i] = turn_between(newest[i], frame.world_from_head[i]);
    }
    std::optional<std::array<dmat3, 2>> camera_from_newest;
    if (frame.behind) {
        const dquat& camera = frame.behind->world_from_camera;
        camera_from_newest = {turn_between(newest[0], camera), turn_between(newest[1], camera)};
    }
    const PanelView on = window_.view();
    painter_.paint(on, frame.eyes, rendered_from_newest, camera_from_newest);
    if (overlay_) overlay_(on);
    glFinish();
    return {uploaded - begin, stopwatch_.now() - uploaded};
}

Presentation WindowDisplay::present(const FrameOnPanel& frame, HostTime) {
    paint_latency_pixel(window_.view().latency_pixel(), frame.latency_level);
    window_.swap();
    const std::uint64_t number = vsyncs_.swapped(clock_.now());
    const bool replaced = last_vsync_ == number;
    last_vsync_ = number;
    return {frame.frame_id, number, vsyncs_.vsync(number), replaced};
}

}  // namespace foverig::window
