#include "rig/exports/perfetto.h"

#include <algorithm>
#include <cmath>

#include "rig/exports/track_events.h"

namespace foverig::exports {
namespace {

using Cells = std::vector<std::optional<double>>;

constexpr const char* kInstants[] = {"wake_up_ns", "begin_ns",  "sample_ns", "sample_arrival_ns",
                                     "gaze_ns",    "submit_ns", "vsync_ns",  "gaze_arrival_ns",
                                     "present_ns", "photon_ns"};

/// The frames of a run, an instant each.
class Instants {
  public:
    explicit Instants(const FrameTable& frames) {
        for (const char* id : kInstants) {
            const Cells& cells = columns_[id] = frames.column(id);
            for (const auto& cell : cells)
                if (cell) first_ns_ = std::min(first_ns_, static_cast<std::int64_t>(*cell));
        }
    }

    /// From the first instant of all, if that is below 0.
    std::optional<std::int64_t> at(const char* id, std::size_t frame) const {
        const auto& cell = columns_.at(id)[frame];
        return cell ? std::optional(static_cast<std::int64_t>(*cell) - first_ns_) : std::nullopt;
    }

  private:
    std::map<std::string, Cells> columns_;
    std::int64_t first_ns_ = 0;
};

struct Tracks {
    Track imu, gaze, frame, wait, scan_out, photon, frame_ms, missed, governor;

    explicit Tracks(TrackEvents& trace)
        : imu(trace.add_track("imu sample to arrival")),
          gaze(trace.add_track("gaze sample to arrival")),
          frame(trace.add_track("frame")),
          wait(trace.add_track("present to VSync")),
          scan_out(trace.add_track("VSync to photon")),
          photon(trace.add_track("photon")),
          frame_ms(trace.add_counter("frame time", "ms")),
          missed(trace.add_counter("VSyncs missed so far", "")),
          governor(trace.add_counter("governor's setting", "")) {}
};

/// Arrows of a frame: from its motion sample and from its gaze sample.
std::vector<std::uint64_t> flows_of(std::size_t frame) {
    return {2 * frame + 1, 2 * frame + 2};
}

/// Frames that share a sample, and the sample once, with an arrow to each of them.
void add_samples(TrackEvents& trace, Track track, const Instants& instants, const char* taken,
                 const char* arrived, std::size_t frames, std::size_t flow) {
    Slice slice{.track = track, .name = "sample"};
    const auto flush = [&] {
        if (!slice.flows.empty()) trace.add(slice);
        slice.flows.clear();
    };
    for (std::size_t i = 0; i < frames; ++i) {
        const auto begin = instants.at(taken, i);
        const auto end = instants.at(arrived, i);
        if (!begin || !end) continue;
        if (*begin != slice.begin_ns) flush();
        if (slice.flows.empty()) {
            slice.begin_ns = *begin;
            slice.end_ns = std::max(*begin, *end);
            slice.frame = i;
        }
        slice.flows.push_back(flows_of(i)[flow]);
    }
    flush();
}

std::vector<Annotation> told_of(const FrameTable& frames, std::size_t frame) {
    std::vector<Annotation> told;
    for (const std::string& id : frames.order) {
        const bool wanted = id.starts_with("pass.") || id.starts_with("rays_") || id == "late" ||
                            id == "mis_presented" || id == "prediction_error_deg" ||
                            id == "gaze_error_deg";
        if (!wanted) continue;
        if (const auto value = frames.columns.at(id)[frame]) told.push_back({id, *value});
    }
    return told;
}

void add_frame(TrackEvents& trace, const Tracks& tracks, const Instants& instants,
               const report::RunData& run, std::size_t i) {
    const auto at = [&](const char* id) { return instants.at(id, i); };
    const auto begin = at("begin_ns"), submit = at("submit_ns"), present = at("present_ns");
    const auto vsync = at("vsync_ns"), photon = at("photon_ns");
    const auto flows = flows_of(i);
    if (begin && submit && *submit > *begin)
        trace.add({tracks.frame, "render", *begin, *submit, i, flows, {}, told_of(run.frames, i)});
    if (submit && present && *present > *submit)
        trace.add({tracks.frame, "lens", *submit, *present, i, flows, {}});
    if (present && vsync && *vsync > *present)
        trace.add({tracks.wait, "waiting", *present, *vsync, i, flows, {}});
    if (present && !vsync) trace.add({tracks.wait, "dropped", *present, *present, i, {}, flows});
    if (vsync && photon && *photon > *vsync)
        trace.add({tracks.scan_out, "scan-out", *vsync, *photon, i, flows, {}});
    if (photon) trace.add({tracks.photon, "photon", *photon, *photon, i, {}, flows});
}

void add_counters(TrackEvents& trace, const Tracks& tracks, const Instants& instants,
                  const FrameTable& frames) {
    const Cells frame_ms = frames.column("frame_time_ms");
    const Cells missed = frames.column("missed_vsyncs");
    const Cells governor = frames.column("governor_setting");
    double missed_so_far = 0.0;
    for (std::size_t i = 0; i < frames.frames; ++i) {
        const auto present = instants.at("present_ns", i);
        if (!present) continue;
        if (frame_ms[i]) trace.count(tracks.frame_ms, *present, *frame_ms[i]);
        missed_so_far += missed[i].value_or(0.0);
        trace.count(tracks.missed, *present, missed_so_far);
        if (governor[i]) trace.count(tracks.governor, *present, *governor[i]);
    }
}

}  // namespace

std::string perfetto_trace(const report::RunData& run) {
    const Instants instants(run.frames);
    TrackEvents trace("foverig " + run.text({"scenario", "scene"}));
    const Tracks tracks(trace);
    add_samples(trace, tracks.imu, instants, "sample_ns", "sample_arrival_ns", run.frames.frames,
                0);
    add_samples(trace, tracks.gaze, instants, "gaze_ns", "gaze_arrival_ns", run.frames.frames, 1);
    for (std::size_t i = 0; i < run.frames.frames; ++i) add_frame(trace, tracks, instants, run, i);
    add_counters(trace, tracks, instants, run.frames);
    return trace.bytes();
}

}  // namespace foverig::exports
