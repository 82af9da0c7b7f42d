// Which VSync shows a frame, and which it was for.
#include <gtest/gtest.h>

#include "rig/records/vsync_count.h"
#include "simulators/panel/virtual_panel.h"
#include "tests/rig/session/small_session.h"

namespace foverig {
namespace {

using test::kPeriod_ms;
using test::run;
using test::scenario_of;
using test::small_scene;

/// Of a still head, at a cost that the frame's number says.
RunRecord run_at(const std::function<double(std::size_t)>& cost_ms, std::int64_t frames) {
    FakeRenderer renderer;
    SessionHooks hooks;
    std::size_t frame = 0;
    hooks.fixed_ms = [&] { return cost_ms(frame++); };
    return run(scenario_of(10.0, frames), renderer, hooks);
}

// A pose is predicted for as many VSyncs as the median of the last five frames took: of a single
// slow frame it is wrong, of a slow stretch until three of five were slow, and then of the first
// fast ones.
TEST(Session, TellsFramesThatAreLateFromThoseThatCameAtAnotherVsyncThanPredicted) {
    const RunRecord r =
        run_at([](std::size_t i) { return i == 6              ? 20.0
                                          : i >= 13 && i < 21 ? 30.0
                                                              : 10.0; }, 27);
    for (std::size_t i = 0; i < r.frames.size(); ++i) {
        const FrameRecord& f = r.frames[i];
        const bool slow = i == 6 || (i >= 13 && i < 21);
        const bool not_foreseen = i == 6 || (i >= 13 && i < 16) || (i >= 21 && i < 24);
        EXPECT_EQ(f.late(), slow) << i;
        EXPECT_EQ(f.mis_presented, not_foreseen) << i;
        EXPECT_EQ(f.mis_presented, f.predicted_photon != *f.photon) << i;
    }
    const VsyncCount c = count_vsyncs(r.frames);
    EXPECT_EQ(c.mis_presented, 7U);
    EXPECT_EQ(c.late, 9U);
}

/// A panel that draws as a window does: it asks for the newest pose when the frame is rendered.
class DrawingPanel final : public Display {
  public:
    const PanelTiming& timing() const override { return panel_.timing(); }
    HostTime next_vsync(HostTime at) const override { return panel_.next_vsync(at); }
    bool draws_pictures() const override { return true; }
    DrawTimes draw(const FramePictures& frame) override {
        if (frame.newest) frame.newest();
        return {};
    }
    Presentation present(const FrameOnPanel& frame, HostTime submit) override {
        return panel_.present(frame, submit);
    }

  private:
    VirtualPanel panel_;
};

// Once a frame is rendered, the warp sees which VSync it will make: a late frame's picture is of
// that one. A frame that comes sooner than predicted is still of the later one.
TEST(Session, JudgesALateWarpedFrameByTheVsyncThatItWasWarpedTo) {
    LiveParts live;
    live.make_display = [](const Clock&) { return std::make_unique<DrawingPanel>(); };
    for (const bool late_warp : {true, false}) {
        Scenario s = scenario_of(10.0, 27);
        s.window.late_warp = late_warp;
        FakeRenderer renderer;
        SessionHooks hooks;
        std::size_t next = 0;
        hooks.fixed_ms = [&] {
            const std::size_t i = next++;
            return i == 6 ? 20.0 : i >= 13 && i < 21 ? 30.0 : 10.0;
        };
        const Scene scene = small_scene();
        const RunRecord r = Session(s, scene, renderer, nullptr, nullptr, &live).run(hooks);
        ASSERT_EQ(r.frames.size(), 27U);
        for (std::size_t i = 0; i < r.frames.size(); ++i) {
            const FrameRecord& f = r.frames[i];
            const bool later_than_predicted = i == 6 || (i >= 13 && i < 16);
            const bool sooner = i >= 21 && i < 24;
            EXPECT_EQ(f.warp.has_value(), late_warp) << i;
            EXPECT_EQ(f.mis_presented, sooner || (!late_warp && later_than_predicted)) << i;
        }
    }
}

TEST(Session, ShowsEveryVsyncOfItsDurationOnce) {
    Scenario hasty = scenario_of(5.0, 60);
    hasty.display.pacing = "free";
    const auto uneven = [](std::size_t i) { return 3.0 + static_cast<double>(7 * i % 41); };
    for (const RunRecord& r : {run_at(uneven, 80), run(hasty)}) {
        const FrameRecord* first = nullptr;
        const FrameRecord* last = nullptr;
        std::uint64_t vsyncs = 0;
        for (const FrameRecord& f : r.frames) {
            if (f.dropped()) continue;
            if (first == nullptr) first = &f;
            last = &f;
            vsyncs += 1U + f.missed_vsyncs;
        }
        const VsyncCount c = count_vsyncs(r.frames);
        EXPECT_EQ(vsyncs, c.total) << "repeats and new frames, frame by frame";
        EXPECT_NEAR(to_ms(*last->vsync - *first->vsync),
                    kPeriod_ms * static_cast<double>(c.total - 1), 1e-3);
        EXPECT_GT(c.missed + c.dropped, 10U) << "it is no smooth run";
    }
}

}  // namespace
}  // namespace foverig
