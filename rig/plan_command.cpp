#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "rig/commands.h"
#include "rig/open_scene.h"
#include "rig/records/summary.h"
#include "rig/require_devices.h"
#include "rig/session/session.h"
#include "rig/summary_text.h"

namespace foverig {
namespace {

constexpr std::int64_t kMeasuredFrames = 5;  // the first finds no history, so one is not enough

}  // namespace

ExitCode plan_command(const PlanRequest& request) {
    Scenario scenario = request.scenario;
    scenario.frames = kMeasuredFrames;
    scenario.seconds = 0.0;
    scenario.clock = "lockstep";
    if (request.measure) require_devices(scenario);
    fmt::print(stderr, "loading {}\n", scenario.scene);
    const auto scene = open_scene(scenario);
    const auto renderer = open_renderer(scene, scenario.render);
    if (request.measure)
        Session(scenario, *scene, *renderer, open_lens(scenario).get()).run(SessionHooks{});
    const auto plan = plan_json(renderer->plan().effects());
    fmt::print("{}", request.json ? plan.dump() + "\n" : plan_text(plan));
    if (request.measure && !request.json)
        fmt::print("memory of the backend  {:.4g} MB: the effects' and what every plan needs\n",
                   static_cast<double>(renderer->backend_bytes()) * 1e-6);
    return ExitCode::good;
}

}  // namespace foverig
