#include "rig/diff_options.h"

#include <fmt/format.h>

#include "metrics/flip.h"
#include "rig/number_in.h"

namespace foverig {

void DiffOptions::add_to(CLI::App& app) {
    CLI::App& diff = *app.add_subcommand("diff", "how far two images or sequences are apart");
    pixels_per_degree_ = metrics::kDefaultPixelsPerDegree;
    diff.add_option("reference", reference_, "PNG, EXR, HDR or PFM; or a folder of frames")
        ->type_name("A")
        ->required();
    diff.add_option("test", test_, "what to compare with it")->type_name("B")->required();
    diff.add_option("--ppd", pixels_per_degree_,
                    "pixels per degree in the middle of the view; a DK2 has 9.6")
        ->check(number_in(1.0, 1000.0))
        ->capture_default_str();
    diff.add_option("--metrics", metrics_, "only these, with commas between; none: all that apply")
        ->delimiter(',')
        ->check(CLI::IsMember(all_metrics()))
        ->type_name("NAMES");
    diff.add_option("--gaze", gaze_px_,
                    "where the eye looks, in pixels from the top left; none: "
                    "the middle")
        ->delimiter(',')
        ->expected(2)
        ->check(number_in(-1e6, 1e6))
        ->type_name("X,Y");
    diff.add_option("--fovea-deg", fovea_deg_, "what `gaze` takes for the fovea")
        ->check(number_in(0.0, 180.0))
        ->capture_default_str();
    diff.add_option("--fps", frames_per_s_, "frames a second of a sequence")
        ->check(number_in(8.0, 10000.0))
        ->capture_default_str();
    diff.add_option("--peak-cd-m2", light_.peak_cd_m2, "light of the screen's white, for fvvdp")
        ->check(number_in(0.1, 10000.0))
        ->capture_default_str();
    diff.add_option("--black-cd-m2", light_.black_cd_m2, "light of its black, room light included")
        ->check(number_in(1.0e-4, 1000.0))
        ->capture_default_str();
    diff.add_option("--tone-mapper", tone_mapper_, "of FLIP between two EXR, HDR or PFM")
        ->check(CLI::IsMember({"aces", "hable", "reinhard"}))
        ->capture_default_str();
    diff.add_option("--out", out_, "write the map of FLIP as a PNG")->type_name("FILE");
    diff.add_flag("--json", json_, "one JSON object on the last line");
    diff.footer(
        "Examples:\n"
        "  foverig diff full.png foveated.png --ppd 9.6 --gaze 591,732 --out error.png\n"
        "  foverig diff reference.exr test.exr --metrics flip,relmse --json\n"
        "  foverig diff frames-full frames-foveated --fps 75     adds change and flicker\n"
        "  foverig diff a.png b.png --metrics fvvdp --ppd 9.6 --gaze 591,732   in JOD, 10 is best\n"
        "docs/metrics.md defines each.");
}

DiffRequest DiffOptions::request() const {
    if (light_.black_cd_m2 >= light_.peak_cd_m2)
        throw UsageError(fmt::format(
            "--black-cd-m2 {:g} is not below --peak-cd-m2 {:g}; expected a darker black",
            light_.black_cd_m2, light_.peak_cd_m2));
    DiffRequest request;
    request.reference = reference_;
    request.test = test_;
    request.json = json_;
    if (!out_.empty()) request.heatmap = out_;
    DiffSettings& settings = request.settings;
    settings.pixels_per_degree = pixels_per_degree_;
    settings.fovea_deg = fovea_deg_;
    settings.frames_per_s = frames_per_s_;
    settings.light = light_;
    settings.metrics = metrics_;
    if (!gaze_px_.empty()) settings.gaze_px = dvec2(gaze_px_[0], gaze_px_[1]);
    if (tone_mapper_ == "hable") settings.tone_mapper = metrics::ToneMapper::hable;
    if (tone_mapper_ == "reinhard") settings.tone_mapper = metrics::ToneMapper::reinhard;
    return request;
}

}  // namespace foverig
