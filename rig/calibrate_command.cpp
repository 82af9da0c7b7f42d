#include "rig/calibrate_command.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "devices/gaze/calibration_targets.h"
#include "rig/calibrate_tracker.h"
#include "rig/calibration_text.h"
#include "rig/interrupt.h"
#include "rig/live/target_window.h"
#include "rig/session/calibration_file.h"

namespace foverig {
namespace {

using gaze::CalibrationProcedure;
using Task = CalibrationProcedure::Task;
using State = CalibrationProcedure::State;

// Between the points of a calibration, where it has to interpolate.
constexpr int kValidationPoints = 9;
constexpr double kValidationShare = 0.75;  // of the reach

std::string text_of(const CalibrationProcedure& procedure, Task task) {
    const auto shown = procedure.shown();
    const std::size_t count = procedure.targets().size();
    return fmt::format("{} {} of {}", task == Task::calibrate ? "calibration" : "validation",
                       shown ? *shown + 1 : count, count);
}

CalibrationProcedure run(CalibratedTracker& tracker, Task task, const std::vector<dvec2>& targets,
                         TargetWindow* window, const Interrupt& interrupt) {
    CalibrationProcedure procedure(task, targets, tracker.now());
    const auto step = [&](const CalibrationProcedure& now) {
        if (window == nullptr) return;
        const auto shown = now.shown();
        window->show(
            {.target_deg = shown ? std::optional(now.targets()[*shown].at_deg) : std::nullopt,
             .watched = now.collecting(),
             .text = "look at the dot: " + text_of(now, task) + ". Escape ends it"});
    };
    const auto stop = [&] {
        return interrupt.requested() || (window != nullptr && window->closed());
    };
    tracker.run(procedure, {.step = step, .stop_requested = stop});
    return procedure;
}

/// The code of a procedure that did not come to its end, and one sentence.
std::optional<ExitCode> ended_badly(const CalibrationProcedure& procedure) {
    if (procedure.state() == State::done) return std::nullopt;
    if (procedure.state() == State::aborted) {
        fmt::print(stderr, "ended: nothing was written\n");
        return ExitCode::interrupted;
    }
    fmt::print(stderr, "gaze: {}; nothing was written\n", procedure.failure());
    return ExitCode::check_failed;
}

void write(const std::filesystem::path& file, const CalibrationRecord& record) {
    std::ofstream stream(file, std::ios::binary);
    stream << calibration_json(record).dump(2) << "\n";
    stream.close();
    if (!stream) {
        throw UsageError(
            fmt::format("--out {}: cannot be written; expected a file in a folder "
                        "that is there",
                        file.string()));
    }
}

}  // namespace

ExitCode calibrate_command(const CalibrateRequest& request) {
    const Scenario& scenario = request.scenario;
    CalibratedTracker tracker(scenario);
    const auto window = TargetWindow::open(scenario);
    if (window) fmt::print(stderr, "{}: look at the dots; Escape ends it\n", window->shown_on());
    if (tracker.simulated() && scenario.faults.gaze.user == 0.0) {
        fmt::print(
            stderr,
            "the simulated eyes are those that the tracker expects, so that there is nothing "
            "to correct; --set faults.gaze.user=1 makes a person of them\n");
    }
    const Interrupt interrupt;
    const auto calibration =
        run(tracker, Task::calibrate, gaze::targets_deg(request.points, request.reach_deg),
            window.get(), interrupt);
    if (const auto code = ended_badly(calibration)) return *code;
    std::optional<CalibrationProcedure> validation;
    if (request.validate) {
        validation = run(tracker, Task::validate,
                         gaze::targets_deg(kValidationPoints, kValidationShare * request.reach_deg),
                         window.get(), interrupt);
        if (const auto code = ended_badly(*validation)) return *code;
    }
    const CalibrationRecord record{.tracker = tracker.info(),
                                   .status = tracker.status(),
                                   .outcome = calibration.outcome(),
                                   .points = calibration.targets(),
                                   .validation = validation
                                                     ? validation->targets()
                                                     : std::vector<CalibrationProcedure::Target>{},
                                   .blob = tracker.calibration()};
    write(request.out, record);
    fmt::print("{}", calibration_text(record));
    fmt::print("calibration: {}\n",
               std::filesystem::absolute(request.out).lexically_normal().string());
    return ExitCode::good;
}

}  // namespace foverig
