#include <fmt/format.h>

#include <map>

#include "rig/commands.h"
#include "rig/failure.h"
#include "rig/interrupt.h"
#include "rig/open_scene.h"
#include "rig/output/run_folder.h"
#include "rig/require_devices.h"
#include "rig/scenario/cost.h"
#include "rig/scenario/write.h"
#include "rig/sweep/grid_walk.h"
#include "rig/sweep/header.h"
#include "rig/sweep/point_result.h"
#include "rig/sweep/read.h"
#include "rig/sweep/time_left.h"
#include "rig/sweep_folder.h"
#include "rig/sweep_runs.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Measures points as they are asked for, each but once; what a killed search measured is there.
class Measurer {
  public:
    Measurer(const sweep::Sweep& sweep, sweep::Journal& journal, SweepRuns& runs)
        : sweep_(sweep), journal_(journal), runs_(runs) {
        for (const sweep::Accuracy& accuracy : journal.content().accuracies)
            accuracies_[accuracy.point] = accuracy;
        for (const sweep::Times& times : journal.content().times)
            times_[times.point].push_back(times);
    }

    /// Throws SweepRuns::Stopped.
    sweep::Place place_of(std::size_t point, double budget_ms) {
        if (!accuracies_.contains(point)) {
            accuracies_[point] = runs_.accuracy(point);
            journal_.append(to_json(accuracies_[point]));
        }
        auto& times = times_[point];
        while (!sweep_.fixed_cost() && static_cast<int>(times.size()) < sweep_.repetitions) {
            times.push_back(runs_.times(point, static_cast<int>(times.size())));
            journal_.append(to_json(times.back()));
        }
        const auto cost = parse_cost(sweep_.base.cost);
        const double ms = sweep_.fixed_cost()
                              ? cost->fixed_ms.value()
                              : sweep::times_of(times, sweep_.warm_up_frames, budget_ms).ms.value;
        const auto errors = sweep::errors_of(accuracies_[point], sweep_.warm_up_frames);
        return {ms, errors.at(sweep_.error).mean.value};
    }

  private:
    const sweep::Sweep& sweep_;
    sweep::Journal& journal_;
    SweepRuns& runs_;
    std::map<std::size_t, sweep::Accuracy> accuracies_;
    std::map<std::size_t, std::vector<sweep::Times>> times_;
};

Json step_json(const sweep::Sweep& sweep, const sweep::GridWalk& grid,
               const sweep::SearchStep& step, double budget_ms) {
    Json settings = Json::object();
    for (const auto& [name, value] : sweep.points[grid.point_at(step.place)].settings)
        settings[name] = sweep::value_json(value);
    return {{"settings", std::move(settings)},
            {"time_ms", step.found.ms},
            {"error", step.found.error},
            {"within_budget", step.found.ms <= budget_ms},
            {"better", step.better}};
}

Json tuned_json(const sweep::Sweep& sweep, const sweep::GridWalk& grid,
                const sweep::SearchResult& found, double budget_ms) {
    Json all = Json::array();
    for (const sweep::SearchStep& step : found.steps)
        all.push_back(step_json(sweep, grid, step, budget_ms));
    return {{"schema", "foverig.tuned/1"},
            {"sweep", sweep.name},
            {"error", sweep.error},
            {"budget_ms", budget_ms},
            {"modelled", sweep.fixed_cost()},
            {"grid_points", grid.count()},
            {"best", step_json(sweep, grid, found.steps[found.best], budget_ms)},
            {"steps", std::move(all)}};
}

std::string tuned_toml(const sweep::Point& best, const Json& tuned) {
    const Json& found = tuned.at("best");
    return fmt::format(
               "# Found by `foverig tune`{}: {} ms of {} ms, {} {:.4g}; of {} settings it tried "
               "{}.\n# {}\n",
               found.at("within_budget").get<bool>() ? "" : ", as nothing that it tried fits",
               fmt::format("{:.4g}", found.at("time_ms").get<double>()),
               fmt::format("{:.4g}", tuned.at("budget_ms").get<double>()),
               tuned.at("error").get<std::string>(), found.at("error").get<double>(),
               tuned.at("grid_points").dump(), tuned.at("steps").size(),
               sweep::text_of(best.settings)) +
           scenario_toml(best.scenario);
}

}  // namespace

ExitCode tune_command(const TuneRequest& request) {
    const sweep::Sweep sweep = sweep::read_sweep(request.file);
    if (!sweep.cases.empty())
        throw UsageError(
            fmt::format("{}: has cases; expected [knobs] to turn, as `foverig sweep` "
                        "alone takes cases",
                        request.file.string()));
    require_devices(sweep.base);
    for (const sweep::Point& point : sweep.points) require_scene(point.scenario);
    const sweep::GridWalk grid(sweep);
    const double budget_ms = request.budget_ms.value_or(1000.0 / sweep.base.display.rate_hz);
    const fs::path folder = request.out.value_or(fs::path("runs") / (sweep.name + "-tuned"));
    make_folder(folder);
    const std::string program = program_digest();
    sweep::Journal journal(folder / "tune.jsonl");
    begin_or_go_on(journal, folder / "tune.jsonl",
                   sweep::header_json(sweep, build_info(), host_info(), program));
    const Interrupt interrupt;
    sweep::TimeLeft progress({});
    SweepRuns runs(sweep, folder, program,
                   {.stop_requested = [&] { return interrupt.requested(); },
                    .note = [&](const std::string& what) { progress.note(what); }});
    Measurer measurer(sweep, journal, runs);
    sweep::SearchResult found;
    try {
        found = sweep::search(grid.sizes(), grid.start(), budget_ms, [&](const auto& place) {
            const std::size_t point = grid.point_at(place);
            const sweep::Place there = measurer.place_of(point, budget_ms);
            progress.tell(fmt::format("{}: {:.4g} ms, {} {:.4g}",
                                      sweep::text_of(sweep.points[point].settings), there.ms,
                                      sweep.error, there.error));
            return there;
        });
    } catch (const SweepRuns::Stopped&) {
        fmt::print("ended early; the same command goes on where it was\n");
        return ExitCode::good;
    }
    const Json tuned = tuned_json(sweep, grid, found, budget_ms);
    const sweep::Point& best = sweep.points[grid.point_at(found.steps[found.best].place)];
    replace_text(folder / "tuned.json", tuned.dump(2) + "\n");
    replace_text(folder / "tuned.toml", tuned_toml(best, tuned));
    const bool fits = tuned.at("best").at("within_budget").get<bool>();
    fmt::print("{}: {} ({} of {} settings tried)\n",
               fits ? "best within the budget" : "nothing fits the budget; the cheapest",
               sweep::text_of(best.settings), found.steps.size(), grid.count());
    fmt::print("scenario: {}\n", fs::absolute(folder / "tuned.toml").lexically_normal().string());
    if (request.json) fmt::print("{}\n", tuned.dump());
    return fits ? ExitCode::good : ExitCode::check_failed;
}

}  // namespace foverig
