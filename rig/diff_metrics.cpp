#include "rig/diff_metrics.h"

#include <algorithm>

#include "metrics/display_code.h"
#include "metrics/eccentricity.h"
#include "metrics/flip.h"
#include "metrics/pixel_errors.h"
#include "metrics/pooling.h"
#include "metrics/ssim.h"

namespace foverig {
namespace {

using Json = nlohmann::ordered_json;

Json flip_json(const metrics::Plane& errors) {
    const metrics::Pooled p = metrics::pool(errors);
    return {{"mean", p.mean},
            {"weighted_median", p.weighted_median},
            {"weighted_q1", p.weighted_q1},
            {"weighted_q3", p.weighted_q3},
            {"min", p.min},
            {"max", p.max}};
}

/// Where no pixel is in the fovea, or none outside, there is nothing to say of it.
Json gaze_json(const metrics::Plane& errors, const metrics::GazedView& view, double fovea_deg) {
    const metrics::GazedError e = metrics::pool_by_gaze(errors, view, fovea_deg);
    Json json = Json::object();
    if (e.fovea_pixels > 0) json["fovea"] = e.fovea;
    if (e.fovea_pixels < errors.values.size()) json["periphery"] = e.periphery;
    json["acuity"] = e.acuity;
    return json;
}

/// Adds up the numbers of one frame; what is not a number stays.
void accumulate(Json& sum, const Json& frame) {
    for (const auto& [key, value] : frame.items()) {
        if (!sum.contains(key)) {
            sum[key] = value;
        } else if (value.is_object()) {
            accumulate(sum[key], value);
        } else if (value.is_number()) {
            const double before = sum[key].get<double>();
            const double now = value.get<double>();
            sum[key] = key == "max"   ? std::max(before, now)
                       : key == "min" ? std::min(before, now)
                                      : before + now;
        }
    }
}

void divide(Json& sum, int frames) {
    for (auto& [key, value] : sum.items()) {
        if (value.is_object())
            divide(value, frames);
        else if (value.is_number_float() && key != "max" && key != "min")
            value = value.get<double>() / frames;
    }
}

}  // namespace

const std::vector<std::string>& all_metrics() {
    static const std::vector<std::string> names{"flip",  "ssim",   "psnr",   "mse",
                                                "mae",   "relmse", "smape",  "gaze",
                                                "fvvdp", "change", "flicker"};
    return names;
}

DiffMetrics::DiffMetrics(const DiffSettings& settings, bool sequence)
    : settings_(settings),
      sum_(Json::object()),
      flicker_(settings.frames_per_s),
      regional_(settings.frames_per_s, settings.fovea_deg),
      vdp_(settings.light, sequence ? std::optional(settings.frames_per_s) : std::nullopt),
      foveated_vdp_(vdp_) {}

bool DiffMetrics::wanted(const std::string& metric) const {
    const auto& chosen = settings_.metrics;
    return chosen.empty() || std::find(chosen.begin(), chosen.end(), metric) != chosen.end();
}

metrics::GazedView DiffMetrics::view_of(const Image& image) const {
    const dvec2 gaze =
        settings_.gaze_px.value_or(dvec2(0.5 * image.width_px, 0.5 * image.height_px));
    return metrics::gazed_screen(image.width_px, image.height_px, settings_.pixels_per_degree,
                                 gaze.x, gaze.y);
}

Json DiffMetrics::of_pair(const ReadImage& reference, const ReadImage& test) {
    using namespace metrics;
    const Image& r = reference.image;
    const Image& t = test.image;
    const bool hdr = reference.high_dynamic_range && test.high_dynamic_range;
    Json json = Json::object();
    if (wanted("flip")) {
        if (hdr) {
            const ExposureRange range = exposure_range(r, settings_.tone_mapper);
            flip_map_ = flip_hdr(r, t, settings_.pixels_per_degree, settings_.tone_mapper, range);
            json["flip"] = flip_json(flip_map_);
            json["flip"]["start_exposure"] = range.start;
            json["flip"]["stop_exposure"] = range.stop;
        } else {
            flip_map_ = flip(r, t, settings_.pixels_per_degree);
            json["flip"] = flip_json(flip_map_);
        }
    }
    if (wanted("ssim"))
        if (const auto similarity = ssim(r, t)) json["ssim"]["mean"] = *similarity;
    const Differences codes = code_differences(r, t);
    const Differences own = hdr ? linear_differences(r, t) : codes;
    const char* unit = hdr ? "linear" : "codes of 0 to 255";
    if (wanted("psnr")) json["psnr"]["db"] = psnr_db(codes.mse);
    if (wanted("mse")) json["mse"] = {{"mean", own.mse}, {"of", unit}};
    if (wanted("mae")) json["mae"] = {{"mean", own.mae}, {"max", own.largest}, {"of", unit}};
    const RelativeDifferences relative = relative_differences(r, t);
    if (wanted("relmse")) json["relmse"]["mean"] = relative.relmse;
    if (wanted("smape")) json["smape"]["mean"] = relative.smape;
    if (wanted("gaze")) {
        const GazedView view = view_of(r);
        json["gaze"]["absolute"] = gaze_json(absolute_error(r, t), view, settings_.fovea_deg);
        if (wanted("flip")) json["gaze"]["flip"] = gaze_json(flip_map_, view, settings_.fovea_deg);
    }
    return json;
}

void DiffMetrics::add(const ReadImage& reference, const ReadImage& test) {
    accumulate(sum_, of_pair(reference, test));
    const Image& r = reference.image;
    const Image& t = test.image;
    if (wanted("fvvdp")) {
        vdp_.add(r, t, view_of(r), false);
        foveated_vdp_.add(r, t, view_of(r), true);
    }
    if (wanted("change")) change_.add(r, t);
    if (wanted("flicker")) flicker_.add(r, t);
    if (wanted("change") || wanted("flicker")) regional_.add(r, t, view_of(r));
    ++frames_;
}

Json DiffMetrics::result() const {
    Json json = sum_;
    divide(json, std::max(1, frames_));
    if (wanted("fvvdp"))
        json["fvvdp"] = {{"jod", vdp_.jod()}, {"foveated_jod", foveated_vdp_.jod()}};
    if (frames_ < 2) return json;
    if (wanted("change")) {
        const metrics::Change c = change_.change();
        json["change"] = {
            {"reference", c.reference}, {"test", c.test}, {"mae", c.mae}, {"mse", c.mse}};
    }
    if (wanted("flicker")) json["flicker"]["rms"] = flicker_.rms_codes();
    const metrics::RegionalChange regional = regional_.change();
    for (const auto& [name, region] :
         {std::pair("fovea", regional.fovea), std::pair("periphery", regional.periphery)}) {
        if (!region) continue;
        if (wanted("change"))
            json["change"][name] = {
                {"reference", region->reference}, {"test", region->test}, {"mae", region->mae}};
        if (wanted("flicker")) json["flicker"][name] = region->flicker_rms;
    }
    return json;
}

}  // namespace foverig
