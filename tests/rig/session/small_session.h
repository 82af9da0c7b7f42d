#pragma once
// A session of a still head before an empty scene.
#include <fmt/format.h>

#include "rig/session/session.h"
#include "tests/rig/session/fake_renderer.h"

namespace foverig::test {

inline Scene small_scene() {
    Scene scene;
    scene.camera_path = {{vec3(0.0F, 1.6F, 4.0F), vec3(0.0F, 1.6F, 0.0F)}};
    return scene;
}

inline Scenario scenario_of(double cost_ms, std::int64_t frames) {
    Scenario s;
    s.cost = fmt::format("fixed:{}", cost_ms);
    s.frames = frames;
    s.motion.head = "still";
    s.motion.gaze = "still";
    return s;
}

inline RunRecord run(const Scenario& scenario, FakeRenderer& renderer, SessionHooks hooks = {}) {
    const Scene scene = small_scene();
    return Session(scenario, scene, renderer, nullptr).run(hooks);
}

inline RunRecord run(const Scenario& scenario) {
    FakeRenderer renderer;
    return run(scenario, renderer);
}

inline constexpr double kPeriod_ms = 1000.0 / 75.0;

}  // namespace foverig::test
