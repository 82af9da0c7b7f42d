#include "rig/calibrate_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "devices/gaze/requests.h"
#include "rig/number_in.h"

namespace foverig {

void CalibrateOptions::add_to(CLI::App& app) {
    CLI::App& calibrate =
        *app.add_subcommand("calibrate", "calibrates the gaze tracker to whoever looks");
    scenario_.add_to(calibrate);
    calibrate.add_option("--points", points_, "how many targets: 1, 3, 5, 9, 13; 0: forget it")
        ->type_name("N")
        ->capture_default_str();
    calibrate
        .add_option("--reach", reach_deg_, "how far out the outermost targets lie on each axis")
        ->type_name("DEG")
        ->check(number_in(1.0, 30.0))
        ->capture_default_str();
    calibrate.add_flag("--validate", validate_,
                       "nine more targets after it, to tell accuracy and precision");
    calibrate.add_option("--out", out_, "file to write")->type_name("FILE")->capture_default_str();
    calibrate.footer(
        "Examples:\n"
        "  foverig calibrate --set faults.gaze.user=1 --points 9 --validate     a simulated "
        "person\n"
        "  foverig calibrate --devices hardware --display headset --points 5    you\n"
        "  foverig run --set tracking.gaze_calibration=calibration.json         with what it "
        "wrote\n"
        "Exit codes: 0 calibrated, 1 refused (the former calibration stands), 2 usage, 4 device,\n"
        "130 ended by Ctrl-C or Escape.");
}

CalibrateRequest CalibrateOptions::request() const {
    const auto& known = gaze::kCalibrationPoints;
    if (std::find(known.begin(), known.end(), points_) == known.end()) {
        throw UsageError(fmt::format("--points {}: expected 0, 1, 3, 5, 9 or 13", points_));
    }
    return {.scenario = scenario_.scenario(),
            .points = points_,
            .reach_deg = reach_deg_,
            .validate = validate_,
            .out = out_};
}

}  // namespace foverig
