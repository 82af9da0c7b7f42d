#include <fmt/format.h>

#include <algorithm>

#include "devices/recording/file_sink.h"
#include "rig/commands.h"
#include "rig/interrupt.h"
#include "rig/progress.h"
#include "rig/records/words.h"
#include "rig/require_devices.h"
#include "rig/scenario/parse.h"
#include "rig/session/device_streams.h"
#include "rig/session/run_clock.h"
#include "simulators/replay/recording.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

constexpr Nanoseconds kStep{100'000'000};  // between two looks at Ctrl-C

fs::path next_free() {
    for (int i = 1;; ++i) {
        fs::path file = fs::path("recordings") / fmt::format("{:03}.mcap", i);
        if (!fs::exists(file)) return file;
    }
}

/// A recording is not made again: an older one is never written over.
fs::path place_of(const RecordRequest& request) {
    fs::path file = request.out.value_or(next_free());
    if (fs::exists(file)) {
        throw UsageError(fmt::format("--out {}: is there already; expected the name of a new file",
                                     file.string()));
    }
    std::error_code error;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
    return file;
}

/// What a replay settles on is part of so many seconds, and comes on top of so many frames.
Nanoseconds duration_of(const Scenario& scenario) {
    if (scenario.seconds <= 0.0) {
        return from_seconds(scenario.settle_s +
                            static_cast<double>(scenario.frames) / scenario.display.rate_hz);
    }
    if (scenario.seconds <= scenario.settle_s) {
        throw UsageError(
            fmt::format("--seconds {}: a replay takes the first {} s (settle_s) before "
                        "its first frame; expected more than that",
                        scenario.seconds, scenario.settle_s));
    }
    return from_seconds(scenario.seconds);
}

void print(const fs::path& file, const std::vector<DeviceRecord>& devices,
           const RecordingRecord& recording) {
    for (const DeviceRecord& device : devices) {
        fmt::print("{:<10} {} samples, {} lost, {} rejected, {} reconnects, {}\n", device.name,
                   device.counts.samples, device.counts.lost, device.counts.rejected,
                   device.counts.reconnects,
                   device.rate_hz ? fmt::format("{:.4g} Hz", *device.rate_hz) : "no rate");
        if (const std::string what = counted(device.troubles); !what.empty()) {
            fmt::print("{:<10} {}\n", "", what);
        }
    }
    for (const auto& [topic, dropped] : recording.dropped_of) {
        fmt::print("dropped    {} messages of {}: the disk was too slow\n", dropped, topic);
    }
    fmt::print("recording  {} messages, {} dropped, {:.1f} MB: {}\n", recording.messages,
               recording.dropped, static_cast<double>(recording.bytes) * 1e-6,
               fs::absolute(file).lexically_normal().string());
}

/// Of devices that cannot be opened there is nothing to keep.
template <class Open>
auto opened_or_removed(const fs::path& file, Open open) {
    try {
        return open();
    } catch (...) {
        std::error_code ignored;  // the devices' error is the one to tell
        fs::remove(file, ignored);
        throw;
    }
}

}  // namespace

ExitCode record_command(const RecordRequest& request) {
    const Scenario& scenario = request.scenario;
    require_devices(scenario);
    require_see_through(scenario);
    const Nanoseconds duration = duration_of(scenario);
    const fs::path file = place_of(request);
    RunClock clock(scenario.clock, Cost{}, replay_speed(scenario));
    const auto world = make_world(scenario, clock.clock());
    auto sink = FileSink::create(file);
    if (!sink) throw UsageError("--out " + sink.error().text);
    SessionRecording recording(std::make_unique<FileSink>(std::move(sink).value()), scenario);
    const auto opened = opened_or_removed(file, [&] {
        return std::make_unique<DeviceStreams>(scenario, *world, clock.clock(), &recording,
                                               DeviceStreams::SeesThrough::where_asked);
    });
    DeviceStreams& devices = *opened;
    devices.tell([](const std::string& text) { fmt::print(stderr, "{}\n", text); });
    const Interrupt interrupt;
    Progress progress;
    const HostTime end = clock.now() + duration;
    while (clock.now() < end && !interrupt.requested() && !world->at_end()) {
        devices.run_for(std::min(kStep, end - clock.now()));
        progress.show(clock.now(), recording.counts());
    }
    progress.done();
    print(file, devices.records(), recording.end());
    return ExitCode::good;
}

Scenario recorded_scenario(const fs::path& file) {
    const auto recording = Recording::open(file);
    if (!recording) throw InputError(recording.error().text);
    const auto text = recording->attachment(kScenarioAttachment);
    if (!text) throw InputError(text.error().text);
    Scenario scenario;
    try {
        apply_toml(scenario, *text, file.string() + ": " + kScenarioAttachment);
    } catch (const UsageError& error) {
        throw InputError(error.what());  // nobody typed it
    }
    scenario.devices = "replay:" + file.string();
    scenario.recording.enabled = false;
    return scenario;
}

}  // namespace foverig
