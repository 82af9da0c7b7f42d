#include "rig/sweep_runs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "devices/time.h"
#include "rig/failure.h"
#include "rig/identity/processor_use.h"
#include "rig/open_scene.h"
#include "rig/scenario/write.h"
#include "rig/sweep/flight.h"
#include "rig/sweep/frame_errors.h"
#include "rig/text/digest.h"

namespace foverig {
namespace {

void add_rays(const RayCounts& rays, double share, std::map<std::string, double>& means) {
    const auto add = [&](const char* kind, std::uint64_t count) {
        means[kind] += share * static_cast<double>(count);
    };
    add("primary", rays.primary);
    add("shadow", rays.shadow);
    add("ao", rays.ao);
    add("reflection", rays.reflection);
    add("probe", rays.probe);
    add("vpl", rays.vpl);
    add("total", rays.total());
}

/// As if its eyes looked where they did. What no frame of a blink says is left as the tracker has
/// it.
FrameInput at_truth(const sweep::FlownFrame& flown) {
    FrameInput input = flown.input;
    for (std::size_t eye = 0; eye < flown.true_gaze.size(); ++eye)
        input.eyes[eye].gaze = flown.true_gaze[eye];
    return input;
}

void require_truth(const std::vector<sweep::FlownFrame>& flight) {
    for (const sweep::FlownFrame& frame : flight)
        if (!frame.true_gaze.empty()) return;
    throw UsageError(
        "errors_at = truth: nobody knows where the eyes look; expected a simulated gaze or a "
        "recording that holds one");
}

/// Of the next frame, means of the eyes. `of_eyes` has seen those before it.
std::map<std::string, double> next_errors(const Renderer& renderer,
                                          const sweep::ReferenceImages& references,
                                          const FrameInput& input,
                                          std::vector<sweep::FrameErrors>& of_eyes) {
    std::map<std::string, double> errors;
    const double share = 1.0 / static_cast<double>(input.eyes.size());
    for (std::size_t eye = 0; eye < input.eyes.size(); ++eye) {
        const Image test = renderer.image(static_cast<int>(eye));
        const auto of_eye = of_eyes[eye].add(references.image(input, eye), test, input.eyes[eye]);
        for (const auto& [name, error] : of_eye) errors[name] += share * error;
    }
    return errors;
}

/// What no errors are asked of, but those of the frames after it are seen through.
void see_next(const Renderer& renderer, const sweep::ReferenceImages& references,
              const FrameInput& input, std::vector<sweep::FrameErrors>& of_eyes) {
    for (std::size_t eye = 0; eye < input.eyes.size(); ++eye)
        of_eyes[eye].see(references.image(input, eye), renderer.image(static_cast<int>(eye)));
}

}  // namespace

SweepRuns::SweepRuns(const sweep::Sweep& sweep, const std::filesystem::path& folder,
                     std::string program, Hooks hooks)
    : sweep_(sweep), folder_(folder), program_(std::move(program)), hooks_(std::move(hooks)) {}

const SweepRuns::Stage& SweepRuns::stage_of(const Scenario& scenario) {
    Scenario shown = scenario;
    shown.render = sweep_.base.render;
    std::string key = scenario_json(shown).dump();
    if (key == stage_.key) return stage_;
    auto scene = open_scene(shown);
    auto flight = sweep::stretches_of(sweep::fly(shown, *scene), sweep_.stretches);
    stage_ = {std::move(key), std::move(scene), std::move(flight)};
    return stage_;
}

sweep::ReferenceImages SweepRuns::references_of(const Stage& stage,
                                                const RenderSettings& reference) {
    Scenario settings;
    settings.render = reference;
    settings.render.threads = sweep_.base.render.threads;
    const std::string key = Digest()
                                .add(program_)
                                .add(scenario_json(settings).dump())
                                .add(sweep::digest_of(*stage.scene))
                                .add(sweep::digest_of(stage.flight))
                                .hex();
    sweep::ReferenceImages references(folder_ / "reference", key);
    if (references.exist()) return references;
    const auto renderer = open_renderer(stage.scene, reference);
    references.render(*renderer, stage.flight, [&](std::size_t done) {
        hooks_.note(fmt::format("reference: frame {} of {}", done, stage.flight.size()));
        check_stop();
    });
    return references;
}

bool SweepRuns::begins_stretch(std::size_t frame) const {
    const std::size_t each = sweep_.stretches.frames;
    return frame == 0 || (each > 0 && frame % each == 0);
}

bool SweepRuns::is_warm(std::size_t frame) const {
    const std::size_t each = sweep_.stretches.frames;
    return (each > 0 ? frame % each : frame) >= sweep_.warm_up_frames;
}

bool SweepRuns::is_kept(std::size_t frame) const {
    return frame < sweep_.warm_up_frames || is_warm(frame);
}

double SweepRuns::warm_frames(const Stage& stage) const {
    double frames = 0.0;
    for (std::size_t i = 0; i < stage.flight.size(); ++i) frames += is_warm(i) ? 1.0 : 0.0;
    return frames;
}

void SweepRuns::check_stop() const {
    if (hooks_.stop_requested()) throw Stopped{};
}

sweep::Accuracy SweepRuns::accuracy(std::size_t point) {
    const Scenario& scenario = sweep_.points[point].scenario;
    const Stage& stage = stage_of(scenario);
    const auto references = references_of(stage, sweep_.reference_of(sweep_.points[point]));
    if (sweep_.errors_at_truth) require_truth(stage.flight);
    const auto renderer = open_renderer(stage.scene, scenario.render);
    sweep::Accuracy accuracy;
    accuracy.point = point;
    std::uint64_t sampled = 0;
    std::uint64_t all = 0;
    std::vector<sweep::FrameErrors> of_eyes;
    for (std::size_t i = 0; i < stage.flight.size(); ++i) {
        check_stop();
        const sweep::FlownFrame& flown = stage.flight[i];
        if (begins_stretch(i))
            of_eyes.assign(flown.input.eyes.size(),
                           {scenario.display.rate_hz, sweep_.error == "fvvdp"});
        const FrameStats stats = renderer->render(flown.input);
        accuracy.nan += stats.numerics.nan;
        if (!is_kept(i)) {
            see_next(*renderer, references, flown.input, of_eyes);
            continue;
        }
        const auto errors = next_errors(
            *renderer, references, sweep_.errors_at_truth ? at_truth(flown) : flown.input, of_eyes);
        for (const auto& [name, error] : errors) accuracy.errors[name].push_back(error);
        if (!is_warm(i)) continue;
        add_rays(stats.rays, 1.0 / warm_frames(stage), accuracy.rays);
        sampled += stats.sampled_pixels;
        all += stats.all_pixels;
    }
    accuracy.sampled_pixel_ratio = static_cast<double>(sampled) / static_cast<double>(all);
    if (!sweep_.fixed_cost()) accuracy.backend_bytes = renderer->backend_bytes();
    return accuracy;
}

sweep::Times SweepRuns::times(std::size_t point, int repetition) {
    const Scenario& scenario = sweep_.points[point].scenario;
    const Stage& stage = stage_of(scenario);
    const auto renderer = open_renderer(stage.scene, scenario.render);
    const auto lens = open_lens(scenario);
    const WallClock stopwatch;
    const auto before = processor_times();
    sweep::Times times;
    times.point = point;
    times.repetition = repetition;
    for (std::size_t i = 0; i < stage.flight.size(); ++i) {
        check_stop();
        const HostTime begin = stopwatch.now();
        FrameStats stats = renderer->render(stage.flight[i].input);
        if (lens)
            for (PassTime& pass : lens->run(*renderer)) stats.passes.push_back(std::move(pass));
        const double frame_ms = to_ms(stopwatch.now() - begin);
        if (is_kept(i)) times.frame_ms.push_back(frame_ms);
        if (!is_warm(i)) continue;
        for (const PassTime& pass : stats.passes)
            times.pass_ms[pass.name] += pass.ms / warm_frames(stage);
    }
    const auto after = processor_times();
    if (const auto use = before && after ? use_between(*before, *after) : std::nullopt)
        times.elsewhere_processors = use->elsewhere();
    return times;
}

}  // namespace foverig
