#include "rig/scenario/key_makers.h"
#include "rig/scenario/render_keys.h"

namespace foverig {
namespace {

/// The kernel is compiled for these counts alone.
void only_powers_of_two(Key& key) {
    key.expected = "1, 2, 4 or 8";
    key.set = [set = key.set, expected = key.expected](
                  Scenario& s, const KeyValue& v) -> std::optional<std::string> {
        const std::int64_t count = std::get<std::int64_t>(v);
        if (count < 1 || (count & (count - 1)) != 0) return expected;
        return set(s, v) ? std::optional(expected) : std::nullopt;
    };
}

}  // namespace

void add_reprojection_keys(std::vector<Key>& keys) {
    const auto number = [&](const char* name, Range range, const char* help, auto at) {
        keys.push_back(number_key(std::string("reprojection.") + name, "", range, help, at));
    };
    const auto integer = [&](const char* name, const char* unit, Range range, const char* help,
                             auto at) {
        keys.push_back(integer_key(std::string("reprojection.") + name, unit, range, help, at));
    };
    integer(
        "support_width_px", "px", {0, 8192}, "of the support image; 0 = 256 at 1182 wide, scaled",
        [](auto& s) -> auto& { return s.render.reprojection.support_width_px; });
    integer(
        "support_height_px", "px", {0, 8192}, "of the support image; 0 = 318 at 1464 high, scaled",
        [](auto& s) -> auto& { return s.render.reprojection.support_height_px; });
    number(
        "epsilon_depth", {0.0, 10.0}, "depth step to a neighbour, share of depth: resample",
        [](auto& s) -> auto& { return s.render.reprojection.epsilon_depth; });
    number(
        "epsilon_lum", {0.0, 10.0}, "luminance step to a neighbour, of full scale: resample",
        [](auto& s) -> auto& { return s.render.reprojection.epsilon_lum; });
    number(
        "epsilon_grazing", {0.0, 1.0}, "cosine of normal and view below which to resample",
        [](auto& s) -> auto& { return s.render.reprojection.epsilon_grazing; });
    number(
        "epsilon_cache", {0.0, 10.0},
        "depth difference of cache and sample, share of depth: drop the cache",
        [](auto& s) -> auto& { return s.render.reprojection.epsilon_cache; });
    number(
        "k_min", {1.0e-6, 1.0}, "weight of a new sample when the old one is a frame old",
        [](auto& s) -> auto& { return s.render.reprojection.k_min; });
    number(
        "k_max", {1.0e-6, 1.0}, "weight of a new sample when the old one is t_max frames old",
        [](auto& s) -> auto& { return s.render.reprojection.k_max; });
    integer(
        "t_max", "frames", {1, 100'000}, "age at which the weight reaches k_max",
        [](auto& s) -> auto& { return s.render.reprojection.t_max; });
    number(
        "k_min_light", {1.0e-6, 1.0}, "k_min of the light buffer",
        [](auto& s) -> auto& { return s.render.reprojection.k_min_light; });
    integer(
        "footprint_samples", "", {1, 8}, "taps of the reprojected pixel's footprint",
        [](auto& s) -> auto& { return s.render.reprojection.footprint_samples; });
    only_powers_of_two(keys.back());
    number(
        "footprint_sigma", {0.0, 10.0}, "of those taps, of the footprint's width",
        [](auto& s) -> auto& { return s.render.reprojection.footprint_sigma; });
    integer(
        "post_samples", "", {1, 1024}, "neighbours the post-process borrows from",
        [](auto& s) -> auto& { return s.render.reprojection.post_samples; });
    integer(
        "post_search_px", "px", {1, 4096}, "furthest of those neighbours",
        [](auto& s) -> auto& { return s.render.reprojection.post_search_px; });
    keys.push_back(flag_key(
        "reprojection.oversampling", "jitter primary rays over the pixel and accumulate",
        [](auto& s) -> auto& { return s.render.reprojection.oversampling; }));
}

}  // namespace foverig
