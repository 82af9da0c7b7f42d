#include "devices/dk2/about.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>

#include "devices/dk2/calibration_reports.h"
#include "devices/dk2/detail/get_report.h"

namespace foverig::dk2 {
namespace {

using detail::get_report;

/// The device walks through its stages from wherever it was left.
Result<std::vector<ManufacturingReport>> read_stages(Transport& transport) {
    std::vector<ManufacturingReport> recorded;
    int stages = 1;
    for (int i = 0; i < stages; ++i) {
        const auto report = get_report<ManufacturingReport>(transport);
        if (!report) return report.error();
        stages = report->stages;
        if (report->unix_time_s != 0) recorded.push_back(*report);
    }
    std::sort(recorded.begin(), recorded.end(),
              [](const auto& a, const auto& b) { return a.stage < b.stage; });
    return recorded;
}

std::string production_text(const std::vector<ManufacturingReport>& stages) {
    if (stages.empty()) return "no factory tests stored";
    std::string failed;
    std::uint32_t newest_s = 0;
    for (const ManufacturingReport& stage : stages) {
        newest_s = std::max(newest_s, stage.unix_time_s);
        if (stage.result == ManufacturingReport::kPassed) continue;
        failed += fmt::format(", stage {} ended with {}", stage.stage, stage.result);
    }
    return fmt::format("made {:%Y-%m-%d}, {} factory tests stored{}", fmt::gmtime(newest_s),
                       stages.size(), failed.empty() ? ", all passed" : failed);
}

std::string range_text(const RangeReport& range) {
    const RangeReport usual{};
    if (range.accel_g == usual.accel_g && range.gyro_deg_s == usual.gyro_deg_s) return "";
    return fmt::format("; ranges of {} g and {} deg/s, which a run sets to {} g and {} deg/s",
                       range.accel_g, range.gyro_deg_s, usual.accel_g, usual.gyro_deg_s);
}

std::string written_text(const RegisterReport& written) {
    if (written.chip == RegisterReport::Chip::none) return "";
    return fmt::format(
        "; a program wrote {:#04x} to register {:#04x} of chip {}: plug the headset in again to "
        "undo that",
        written.payload, written.address, static_cast<int>(written.chip));
}

}  // namespace

Result<About> read_about(Transport& transport) {
    const auto serial = get_report<SerialReport>(transport);
    if (!serial) return serial.error();
    const auto uuid = get_report<UuidReport>(transport);
    if (!uuid) return uuid.error();
    auto stages = read_stages(transport);
    if (!stages) return stages.error();
    const auto mag = get_report<MagCalibrationReport>(transport);
    if (!mag) return mag.error();
    const auto range = get_report<RangeReport>(transport);
    if (!range) return range.error();
    const auto written = get_report<RegisterReport>(transport);
    if (!written) return written.error();
    return About{.serial = serial->serial,
                 .uuid = uuid->uuid,
                 .stages = std::move(stages).value(),
                 .mag_calibration = mag->version,
                 .range = *range,
                 .written = *written};
}

std::string text_of(const About& about) {
    return fmt::format("factory number {}, UUID {}; {}; magnetometer {}{}{}", about.serial,
                       about.uuid, production_text(about.stages),
                       about.mag_calibration == 0
                           ? "not calibrated"
                           : fmt::format("calibrated (version {})", about.mag_calibration),
                       range_text(about.range), written_text(about.written));
}

}  // namespace foverig::dk2
