#include "rig/calibration_text.h"

#include <fmt/format.h>

#include <cmath>

namespace foverig {
namespace {

using Target = gaze::CalibrationProcedure::Target;

std::string deg(double value) {
    return std::isfinite(value) ? fmt::format("{:7.2f}", value) : "      -";
}

std::string row(const std::string& name, const gaze::DataQuality& left,
                const gaze::DataQuality& right, const gaze::DataQuality& both) {
    std::string text = fmt::format("{:<14}{:>8}", name, both.samples);
    for (const auto figure : {&gaze::DataQuality::accuracy_deg, &gaze::DataQuality::rms_s2s_deg,
                              &gaze::DataQuality::sd_deg}) {
        text += "   " + deg(left.*figure) + deg(right.*figure) + deg(both.*figure);
    }
    return text + "\n";
}

std::string table(const std::vector<Target>& targets) {
    std::string text = fmt::format(
        "{:<14}{:>8}   {:<21}   {:<21}   {}\n{:<14}{:>8}   {:>7}{:>7}{:>7}   {:>7}{:>7}{:>7}   "
        "{:>7}{:>7}{:>7}\n",
        "target (deg)", "samples", "    accuracy (deg)", "    RMS-S2S (deg)", "    SD (deg)", "",
        "", "left", "right", "both", "left", "right", "both", "left", "right", "both");
    std::vector<gaze::DataQuality> left, right, both;
    for (const Target& target : targets) {
        text += row(fmt::format("{:+.1f} {:+.1f}", target.at_deg.x, target.at_deg.y), target.left,
                    target.right, target.combined);
        left.push_back(target.left);
        right.push_back(target.right);
        both.push_back(target.combined);
    }
    return text + row("mean", mean_of(left), mean_of(right), mean_of(both));
}

}  // namespace

std::string calibration_text(const CalibrationRecord& record) {
    const auto& status = record.status;
    std::string text = fmt::format("gaze tracker {}: ", record.tracker.serial);
    if (status.calibration_points == 0) {
        text += "not calibrated";
    } else {
        text += fmt::format("calibration {} with {} points", status.calibration_id,
                            status.calibration_points);
    }
    if (status.calibration_quality != 255) {
        text +=
            fmt::format(", quality {} of 100, off by {:.2f} (left) and {:.2f} deg (right) at them",
                        status.calibration_quality, record.outcome.accuracy_deg[0],
                        record.outcome.accuracy_deg[1]);
    }
    text += "\n";
    if (!record.validation.empty()) text += table(record.validation);
    return text;
}

}  // namespace foverig
