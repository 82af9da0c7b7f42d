#include "rig/calibrate_tracker.h"

#include <fmt/format.h>

#include <utility>

#include "devices/hardware/open_devices.h"
#include "rig/failure.h"
#include "rig/session/open_device.h"
#include "rig/session/panel_settings.h"

namespace foverig {
namespace {

constexpr Nanoseconds kStep{10'000'000};  // between two looks at the clock
constexpr const char* kPlugIn = "plug it in and run foverig calibrate again";

std::unique_ptr<hardware::LiveTransport> open_on_desk(const Scenario& scenario,
                                                      const Clock& clock) {
    if (scenario.devices != "hardware" || scenario.hardware.gaze == "sim") return nullptr;
    const auto id = hardware::usb_id_of(scenario.hardware.gaze_usb_id);
    auto opened = hardware::open_gaze_tracker(clock, id.value_or(hardware::kGazeTracker),
                                              scenario.hardware.gaze_serial);
    if (opened) return std::move(opened).value();
    if (scenario.hardware.gaze == "auto" && opened.error().code == ErrorCode::not_found) {
        return nullptr;
    }
    throw DeviceError("devices = hardware: " + opened.error().text);
}

void check(const Scenario& scenario) {
    if (!replayed_file(scenario).empty()) {
        throw UsageError(fmt::format(
            "calibrate and devices = {}: nobody looks at targets any more; use sim or hardware",
            scenario.devices));
    }
    if (scenario.devices == "hardware" && scenario.clock != "wall") {
        throw UsageError("devices = hardware and clock = " + scenario.clock +
                         ": devices on a desk run in real time; add --clock wall");
    }
}

const Scenario& checked(const Scenario& scenario) {
    check(scenario);
    return scenario;
}

}  // namespace

CalibratedTracker::CalibratedTracker(const Scenario& scenario)
    : clock_(checked(scenario).clock, Cost{}),
      eyes_(seed_of(scenario, SeedStream::eyes)),
      on_desk_(open_on_desk(scenario, clock_.clock())) {
    if (!on_desk_) {
        simulated_ = std::make_unique<SimulatedGaze>(
            clock_.clock(), eyes_,
            SimulatedGaze::Settings{.faults = scenario.faults.gaze,
                                    .seed = seed_of(scenario, SeedStream::gaze)});
    }
    source_ = opened("gaze",
                     gaze::GazeSource::open(
                         transport(), clock_.clock(),
                         {.rate_hz = static_cast<std::uint16_t>(scenario.tracking.gaze_rate_hz)}));
}

Transport& CalibratedTracker::transport() {
    return on_desk_ ? static_cast<Transport&>(*on_desk_) : *simulated_;
}

void CalibratedTracker::run(gaze::CalibrationProcedure& procedure, const Hooks& hooks) {
    looked_at_.reset();
    while (true) {
        if (hooks.stop_requested()) procedure.abort();
        obey(procedure);
        if (procedure.state() != gaze::CalibrationProcedure::State::running) return;
        look(procedure);
        hooks.step(procedure);
        const auto next = source_->next(now() + kStep);
        for (const auto& frame : source_->take_calibrations()) procedure.take(frame, now());
        if (const auto* sample = std::get_if<GazeSample>(&next)) procedure.take(*sample);
        if (const auto* fault = std::get_if<Fault>(&next)) {
            const auto shown = procedure.shown();
            throw DeviceError(fmt::format(
                "gaze: {}{}: nothing was calibrated; {}", fault->error.text,
                shown ? fmt::format(", at target {} of {}", *shown + 1, procedure.targets().size())
                      : "",
                kPlugIn));
        }
    }
}

void CalibratedTracker::obey(gaze::CalibrationProcedure& procedure) {
    while (const auto order = procedure.next_order(now())) {
        const auto status = transport().control_set(order->request, order->value, order->data);
        if (status) continue;
        if (status.error().code == ErrorCode::closed) {
            throw DeviceError(
                fmt::format("gaze: {}: nothing was calibrated; {}", status.error().text, kPlugIn));
        }
        procedure.refused(status.error().text);
    }
}

/// Whoever is simulated looks at what is shown; they notice it late, as people do.
void CalibratedTracker::look(const gaze::CalibrationProcedure& procedure) {
    const auto shown = procedure.shown();
    if (shown == looked_at_) return;
    looked_at_ = shown;
    if (shown) {
        eyes_.show(to_seconds(now().time_since_epoch()), procedure.targets()[*shown].at_deg);
    }
}

std::vector<std::byte> CalibratedTracker::asked(std::uint8_t request, std::size_t size) {
    return opened("gaze", transport().control_get(request, 0, size));
}

gaze::DeviceStatus CalibratedTracker::status() {
    return opened("gaze", gaze::DeviceStatus::decode(
                              asked(gaze::request::get_status, gaze::DeviceStatus::kSize)));
}

std::vector<std::byte> CalibratedTracker::calibration() {
    if ((info().capabilities & gaze::capability::save_calibration) == 0) return {};
    return asked(gaze::request::cal_blob, gaze::CalibrationBlob::kSize);
}

}  // namespace foverig
