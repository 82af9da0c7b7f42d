#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "rig/check_keys.h"
#include "rig/commands.h"
#include "rig/governor/governed_renderer.h"
#include "rig/identity/build_info.h"
#include "rig/identity/host_info.h"
#include "rig/identity/processor_use.h"
#include "rig/interrupt.h"
#include "rig/live/live_window.h"
#include "rig/open_scene.h"
#include "rig/output/kept_images.h"
#include "rig/output/run_folder.h"
#include "rig/progress.h"
#include "rig/records/columns.h"
#include "rig/records/frames_csv.h"
#include "rig/records/summary.h"
#include "rig/report/page.h"
#include "rig/require_devices.h"
#include "rig/scenario/cost.h"
#include "rig/scenario/write.h"
#include "rig/session/session.h"
#include "rig/summary_text.h"

namespace foverig {
namespace {

constexpr const char* kRecordingFile = "session.mcap";

/// Of a window that shows the frames, or null.
void attach(LiveWindow* live, const Interrupt& interrupt, SessionHooks& hooks) {
    hooks.stop_requested = [&interrupt, live] {
        return interrupt.requested() || (live != nullptr && live->closed());
    };
    if (live != nullptr) hooks.frame_begins = [live](HostTime begin) { live->frame_begins(begin); };
}

std::unique_ptr<governor::GovernedRenderer> open_governed(
    const Scenario& scenario, const std::shared_ptr<const Scene>& scene) {
    auto ladder = governor::read_ladder(scenario);
    if (!ladder) return nullptr;
    return std::make_unique<governor::GovernedRenderer>(
        std::move(*ladder), governor::limits_of(scenario),
        [&](const RenderSettings& settings) { return open_renderer(scene, settings); });
}

/// What a governor did, in the records.
void take_choices(const governor::GovernedRenderer& governed, RunRecord& run) {
    for (std::size_t i = 0; i < std::min(run.frames.size(), governed.chosen().size()); ++i)
        run.frames[i].governor_setting = governed.chosen()[i];
    run.governor = governed.record();
}

/// A recording may be shorter than what is asked of it. Throws InputError where no frame was due.
void tell_of_early_end(const Scenario& scenario, const RunRecord& run) {
    const std::string recording = replayed_file(scenario);
    if (recording.empty()) return;
    if (run.frames.empty()) {
        throw InputError(
            fmt::format("{}: ends before the first frame, within settle_s = {}; "
                        "expected a longer recording, or a smaller settle_s",
                        recording, scenario.settle_s));
    }
    if (scenario.seconds <= 0.0 && std::ssize(run.frames) < scenario.frames) {
        fmt::print(stderr, "{}: ends after {} of {} frames\n", recording, run.frames.size(),
                   scenario.frames);
    }
}

/// With a window the lenses are its work; `governed` is the renderer where there is a governor,
/// else null.
RunRecord run_session(const Scenario& scenario, const Scene& scene, Renderer& renderer,
                      governor::GovernedRenderer* governed, LensPass* lens, LiveWindow* live,
                      KeptImages& images, SessionRecording* recording, const Interrupt& interrupt) {
    Session session(scenario, scene, renderer, live == nullptr ? lens : nullptr, recording,
                    live == nullptr ? nullptr : &live->parts());
    Progress progress;
    std::optional<FrameInput> last;
    SessionHooks hooks;
    attach(live, interrupt, hooks);
    hooks.notice = [&](const std::string& text) { progress.say(text); };
    hooks.progress = [&](const SessionProgress& done) { progress.show(done); };
    hooks.frame_done = [&](const FrameRecord& frame, const FrameInput& input, double share) {
        last = input;
        if (live != nullptr) live->frame_done(frame);
        if (governed != nullptr) governed->frame_took(frame_time_ms(frame));
        return images.frame_done(input, renderer, share);
    };
    if (const auto cost = parse_cost(scenario.cost); governed != nullptr && cost && cost->fixed_ms)
        hooks.fixed_ms = [=] { return governed->fixed_ms(*cost->fixed_ms); };
    const auto before = processor_times();
    RunRecord run = session.run(hooks);
    if (const auto after = processor_times(); before && after)
        run.processor_use = use_between(*before, *after);
    if (governed != nullptr) take_choices(*governed, run);
    if (live != nullptr && run.display) live->complete(*run.display);
    progress.done();
    if (!run.interrupted && !hooks.stop_requested()) tell_of_early_end(scenario, run);
    if (last) images.run_done(*last, renderer);
    if (const auto missed = images.missed(); !missed.empty())
        fmt::print(stderr, "images.frames: the run of {} frames never came to {}\n",
                   run.frames.size(), fmt::join(missed, ", "));
    return run;
}

void compare_with_full(const Scenario& scenario, const std::shared_ptr<const Scene>& scene,
                       KeptImages& images, const Interrupt& interrupt) {
    if (!scenario.images.error || scenario.render.pipeline == "full" || images.empty() ||
        interrupt.requested())
        return;
    fmt::print(stderr, "rendering the kept frames in full, to compare; Ctrl-C leaves that out\n");
    RenderSettings settings = scenario.render;
    settings.pipeline = "full";
    images.compare_with(*open_renderer(scene, settings), [&] { return interrupt.requested(); });
}

void write_records(const RunFolder& folder, const Scenario& scenario, const RunRecord& run,
                   const nlohmann::json& summary) {
    folder.write("scenario.toml", scenario_toml(scenario));
    folder.write("frames.csv",
                 frames_csv(run.frames, run.fixed_cost ? WallTimes::omit : WallTimes::keep));
    folder.write("plan.json", plan_json(run.plan).dump(2) + "\n");
    folder.write("summary.json", summary.dump(2) + "\n");
}

/// The checks that failed, said on stderr.
ExitCode judged(const std::vector<FailIf>& checks, const nlohmann::json& summary) {
    ExitCode code = ExitCode::good;
    for (const FailIf& check : checks) {
        if (const auto why = failure(check, summary)) {
            fmt::print(stderr, "check failed: {}\n", *why);
            code = ExitCode::check_failed;
        }
    }
    const auto nan = summary["numerics"]["nan"].get<std::uint64_t>();
    if (nan > 0) {
        fmt::print(stderr, "not valid: kernels met NaN {} times; please report this scenario\n",
                   nan);
        code = ExitCode::internal;
    }
    return code;
}

/// What the devices sent cannot be made again: it outlives a run that fails.
class RecordingRescue {
  public:
    RecordingRescue(const RunFolder& folder, std::optional<SessionRecording>& recording)
        : folder_(folder), recording_(recording) {}
    ~RecordingRescue() {
        if (!recording_ || std::uncaught_exceptions() == exceptions_) return;
        if (!recording_->has_samples()) return;
        recording_.reset();
        if (const auto kept = folder_.rescue(kRecordingFile)) {
            const std::string text = fmt::format(
                "the run failed; what its devices sent is kept in {0} (foverig recover {0} mends "
                "it where it is torn)\n",
                kept->string());
            std::fputs(text.c_str(), stderr);  // which may be full too: nothing may throw here
        }
    }
    RecordingRescue(const RecordingRescue&) = delete;
    RecordingRescue& operator=(const RecordingRescue&) = delete;

  private:
    const RunFolder& folder_;
    std::optional<SessionRecording>& recording_;
    int exceptions_ = std::uncaught_exceptions();
};

}  // namespace

ExitCode run_command(const RunRequest& request) {
    const Scenario& scenario = request.scenario;
    refuse_unknown_keys(request.checks, scenario);
    require_devices(scenario);
    require_see_through(scenario);
    const Interrupt interrupt;
    const auto live = LiveWindow::open(scenario);
    if (live) fmt::print(stderr, "{}: Escape ends the run, H shows the HUD\n", live->shown_on());
    RunFolder folder(request.out);
    fmt::print(stderr, "loading {}\n", scenario.scene);
    const auto scene = open_scene(scenario, !scenario.see_through.camera.empty());
    auto governed = open_governed(scenario, scene);
    auto* const governor = governed.get();
    std::unique_ptr<Renderer> renderer = std::move(governed);
    if (!renderer) renderer = open_renderer(scene, scenario.render);
    fmt::print(stderr, "tracing with {}\n", backend_text(*renderer, scenario.render));
    const auto lens = open_lens(scenario);
    KeptImages images(scenario);
    std::optional<SessionRecording> recording;
    if (scenario.recording.enabled) recording.emplace(folder.draft() / kRecordingFile, scenario);
    if (interrupt.requested()) {
        fmt::print(stderr, "interrupted while loading: nothing was measured\n");
        return ExitCode::interrupted;
    }
    const RecordingRescue rescue(folder, recording);
    const RunRecord run = run_session(scenario, *scene, *renderer, governor, lens.get(), live.get(),
                                      images, recording ? &*recording : nullptr, interrupt);
    const std::uint64_t rss_bytes = peak_rss_bytes();
    renderer.reset();  // the comparison needs the memory
    compare_with_full(scenario, scene, images, interrupt);

    nlohmann::json summary =
        summary_json(run, scenario_json(scenario), build_info(), host_info(), rss_bytes);
    summary["images"] = images.write(folder.draft(), lens.get());
    write_records(folder, scenario, run, summary);
    folder.write("report.html", report::page(report::read_run(folder.draft())));
    folder.publish();

    fmt::print("{}", summary_text(summary));
    fmt::print("report: {}\n", std::filesystem::absolute(folder.place() / "report.html").string());
    if (request.json) fmt::print("{}\n", summary.dump());
    return judged(request.checks, summary);
}

}  // namespace foverig
