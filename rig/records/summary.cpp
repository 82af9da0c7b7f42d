#include "rig/records/summary.h"

#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "rig/identity/gpu_info.h"
#include "rig/records/columns.h"
#include "rig/records/distribution.h"
#include "rig/records/governor_json.h"
#include "rig/records/motion_phase.h"
#include "rig/records/panel_record.h"
#include "rig/records/steady_times.h"
#include "rig/records/vsync_count.h"

namespace foverig {
namespace {

using nlohmann::json;

template <class T>
json or_null(const std::optional<T>& value) {
    return value ? json(*value) : json(nullptr);
}

/// Distribution over the frames that have the value.
json spread(const std::vector<FrameRecord>& frames,
            const std::function<std::optional<double>(const FrameRecord&)>& value) {
    std::vector<double> values;
    for (const FrameRecord& frame : frames) {
        if (const auto v = value(frame)) values.push_back(*v);
    }
    return to_json(distribution_of(std::move(values)));
}

/// Null where frames cost what the scenario says: there is nothing to estimate.
json steady_json(const RunRecord& run) {
    if (run.fixed_cost || run.frames.empty()) return nullptr;
    std::vector<double> times_ms;
    for (const FrameRecord& frame : run.frames) times_ms.push_back(frame_time_ms(frame));
    return to_json(steady_times(times_ms));
}

/// Over the frames where the pass ran.
json pass_times(const std::vector<FrameRecord>& frames) {
    std::map<std::string, std::vector<double>> values;
    for (const FrameRecord& frame : frames) {
        for (const PassTime& pass : frame.passes) values[pass.name].push_back(pass.ms);
    }
    json passes = json::object();
    for (auto& [name, ms] : values) passes[name] = to_json(distribution_of(std::move(ms)));
    return passes;
}

std::uint64_t sum(const std::vector<FrameRecord>& frames,
                  const std::function<std::uint64_t(const FrameRecord&)>& count) {
    std::uint64_t total = 0;
    for (const FrameRecord& frame : frames) total += count(frame);
    return total;
}

json ray_means(const std::vector<FrameRecord>& frames) {
    const auto mean = [&](auto count) -> json {
        if (frames.empty()) return nullptr;
        return static_cast<double>(sum(frames, count)) / static_cast<double>(frames.size());
    };
    using F = const FrameRecord&;
    return {{"primary", mean([](F f) { return f.rays.primary; })},
            {"shadow", mean([](F f) { return f.rays.shadow; })},
            {"ao", mean([](F f) { return f.rays.ao; })},
            {"reflection", mean([](F f) { return f.rays.reflection; })},
            {"probe", mean([](F f) { return f.rays.probe; })},
            {"vpl", mean([](F f) { return f.rays.vpl; })},
            {"total", mean([](F f) { return f.rays.total(); })}};
}

json sampled_ratio(const std::vector<FrameRecord>& frames) {
    const auto all = sum(frames, [](const FrameRecord& f) { return f.all_pixels; });
    const auto sampled = sum(frames, [](const FrameRecord& f) { return f.sampled_pixels; });
    if (all == 0) return nullptr;
    return static_cast<double>(sampled) / static_cast<double>(all);
}

json vsync_json(const RunRecord& run, const VsyncCount& count) {
    const double budget_ms = 1000.0 / run.rate_hz;
    double busy_ms = 0.0;
    for (const FrameRecord& frame : run.frames) busy_ms += frame_time_ms(frame);
    json vsync = {{"rate_hz", run.rate_hz}, {"budget_ms", budget_ms},  {"total", count.total},
                  {"missed", count.missed}, {"missed_ratio", nullptr}, {"utilisation", nullptr}};
    if (count.total > 0) {
        vsync["missed_ratio"] =
            static_cast<double>(count.missed) / static_cast<double>(count.total);
    }
    if (!run.frames.empty()) {
        vsync["utilisation"] = busy_ms / static_cast<double>(run.frames.size()) / budget_ms;
    }
    return vsync;
}

json latencies(const std::vector<FrameRecord>& frames) {
    return {
        {"motion_to_photon", spread(frames, motion_to_photon_ms)},
        {"gaze_to_photon", spread(frames, gaze_to_photon_ms)},
        {"warp_to_photon", spread(frames, warp_to_photon_ms)},
        {"see_through_to_photon", spread(frames, see_through_to_photon_ms)},
        {"imu_transport", spread(frames, imu_transport_ms)},
        {"gaze_transport", spread(frames, gaze_transport_ms)},
        {"motion_to_photon_readback", spread(frames, readback_ms)},
        {"prediction_error_deg",
         spread(frames, [](const FrameRecord& f) { return f.prediction_error_deg; })},
        {"gaze_error_deg", spread(frames, [](const FrameRecord& f) { return f.gaze_error_deg; })},
        {"head_lag", spread(frames, [](const FrameRecord& f) { return f.head_lag_ms; })}};
}

/// Times as in frames.csv, of the host's clock.
json outages_json(const std::vector<Outage>& outages) {
    json all = json::array();
    for (const Outage& outage : outages) {
        const auto seconds = [](HostTime time) { return to_seconds(time.time_since_epoch()); };
        all.push_back({{"lost_s", seconds(outage.lost)},
                       {"back_s", outage.back ? json(seconds(*outage.back)) : json(nullptr)},
                       {"why", outage.why}});
    }
    return all;
}

/// A window on an ordinary screen is no panel, simulated or real: its light is not known.
const char* panel_origin(const std::optional<DisplayRecord>& display) {
    if (!display) return name_of(Origin::simulated);
    return display->on_headset ? name_of(Origin::hardware) : "window";
}

json devices_json(const RunRecord& run) {
    json all = json::object();
    for (const DeviceRecord& device : run.devices) {
        all[device.name] = {{"samples", device.counts.samples},
                            {"lost", device.counts.lost},
                            {"rejected", device.counts.rejected},
                            {"reconnects", device.counts.reconnects},
                            {"outages", outages_json(device.outages)},
                            {"rate_hz", or_null(device.rate_hz)},
                            {"troubles", device.troubles},
                            {"origin", name_of(device.origin)}};
        if (device.origin == Origin::recorded)
            all[device.name]["recorded_from"] =
                device.recorded_from ? json(name_of(*device.recorded_from)) : json(nullptr);
    }
    // It sends nothing of its own that could be lost or malformed: read-backs ride in the headset's
    // reports, and are counted there.
    const PanelRecord panel = panel_record(run.frames);
    all["panel"] = {{"samples", panel.samples},
                    {"lost", nullptr},
                    {"rejected", nullptr},
                    {"reconnects", nullptr},
                    {"outages", nullptr},
                    {"rate_hz", or_null(panel.rate_hz)},
                    {"origin", panel_origin(run.display)}};
    return all;
}

/// What no effect of the plan asked for: the scene, the queues, the image.
std::uint64_t base_bytes(const RunRecord& run) {
    std::uint64_t bytes = run.backend_bytes;
    for (const PlannedEffect& effect : run.plan) bytes -= effect.bytes.value_or(0);
    return bytes;
}

json recording_json(const std::optional<RecordingRecord>& recording) {
    if (!recording) return nullptr;
    return {{"file", "session.mcap"},
            {"messages", recording->messages},
            {"dropped", recording->dropped},
            {"dropped_of", recording->dropped_of},
            {"bytes", recording->bytes}};
}

json display_json(const std::optional<DisplayRecord>& display) {
    if (!display) return nullptr;
    return {{"shown_on", display->shown_on},
            {"vsync_from", display->vsync_measured ? "display" : "own clock"},
            {"vsync_error_ms", display->vsync_error_ms},
            {"hud_frames", display->hud_frames}};
}

json processor_use_json(const std::optional<ProcessorUse>& use) {
    if (!use) return nullptr;
    return {{"processors", use->processors},
            {"own", use->own},
            {"others", use->others},
            {"stolen", use->stolen}};
}

json numerics_json(const std::vector<FrameRecord>& frames) {
    using F = const FrameRecord&;
    return {{"nan", sum(frames, [](F f) { return f.numerics.nan; })},
            {"inf", sum(frames, [](F f) { return f.numerics.inf; })},
            {"clamped", sum(frames, [](F f) { return f.numerics.clamped; })}};
}

}  // namespace

json plan_json(const std::vector<PlannedEffect>& plan) {
    json effects = json::array();
    for (const PlannedEffect& effect : plan) {
        effects.push_back(
            {{"effect", effect.name},
             {"on", effect.on},
             {"because", effect.because},
             {"passes", effect.passes},
             {"bytes", or_null(effect.bytes)},
             {"measured_ms", effect.measured_ms < 0.0 ? json(nullptr) : json(effect.measured_ms)}});
    }
    return effects;
}

json summary_json(const RunRecord& run, const json& scenario, const BuildInfo& build,
                  const HostInfo& host, std::uint64_t peak_rss) {
    const auto& frames = run.frames;
    const VsyncCount count = count_vsyncs(frames);
    json summary = {{"schema", "foverig.summary/1"}};
    summary["build"] = {{"version", build.version},   {"git", or_null(build.git)},
                        {"compiler", build.compiler}, {"flags", build.flags},
                        {"type", build.build_type},   {"fp_mode", build.fp_mode},
                        {"backend", run.backend},     {"device", or_null(host.cpu)}};
    summary["host"] = {
        {"cpu", or_null(host.cpu)},
        {"cores", host.cores},
        {"gpu", run.backend.starts_with("cuda") ? json(gpu_text(find_gpus())) : json()},
        {"os", or_null(host.os)}};
    summary["processor_use"] = run.fixed_cost ? json() : processor_use_json(run.processor_use);
    summary["scenario"] = scenario;
    summary["pipeline"] = run.pipeline;
    summary["interrupted"] = run.interrupted;
    summary["fixed_cost"] = run.fixed_cost;
    summary["plan"] = plan_json(run.plan);
    summary["frames"] = {{"rendered", count.rendered},
                         {"presented", count.presented},
                         {"dropped", count.dropped},
                         {"late", count.late},
                         {"mis_presented", count.mis_presented}};
    using F = const FrameRecord&;
    summary["tracking"] = {
        {"pose_stale_frames", sum(frames, [](F f) { return f.pose_stale ? 1U : 0U; })},
        {"gaze_held_frames", sum(frames, [](F f) { return f.gaze_held ? 1U : 0U; })},
        {"gaze_stale_frames", sum(frames, [](F f) { return f.gaze_stale ? 1U : 0U; })}};
    summary["frame_time_ms"] = spread(frames, frame_time_ms);
    summary["steady_frame_time_ms"] = steady_json(run);
    summary["render_time_ms"] = spread(frames, [](const FrameRecord& f) { return f.render_ms; });
    summary["cpu_time_ms"] = run.fixed_cost ? json() : spread(frames, [](F f) { return f.cpu_ms; });
    summary["pass_time_ms"] = pass_times(frames);
    summary["rays"] = ray_means(frames);
    summary["sampled_pixel_ratio"] = sampled_ratio(frames);
    summary["vsync"] = vsync_json(run, count);
    summary["latency_ms"] = latencies(frames);
    summary["latency_by_phase"] = latency_by_phase_json(frames);
    summary["devices"] = devices_json(run);
    summary["display"] = display_json(run.display);
    summary["recording"] = recording_json(run.recording);
    summary["memory"] = {{"backend_bytes", run.backend_bytes},
                         {"base_bytes", base_bytes(run)},
                         {"peak_rss_bytes", peak_rss}};
    if (run.governor) summary["governor"] = governor_json(run);
    summary["numerics"] = numerics_json(frames);
    return summary;
}

}  // namespace foverig
