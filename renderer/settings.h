#pragma once
// Every knob of the renderer. Defaults are the papers' values where they give one.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace foverig {

/// Weier 2016 3.1. Configurations: small (5, 10, 0.01), medium (10, 20, 0.05), large (15, 30, 0.1).
struct FoveationSettings {
    double r0_deg = 10.0;  ///< inside: every pixel
    double r1_deg = 20.0;  ///< outside: p_min of the pixels; linear between; >= r0_deg
    double p_min = 0.05;   ///< 0..1
};

struct LightingSettings {
    bool point_lights = true;  ///< false: leave the scene's point lights out
    bool area_lights = true;
    int area_samples = 8;      ///< shadow rays a pixel for each area light; 0 = none
    int ao_samples = 0;        ///< ambient occlusion rays a pixel; 0 = no occlusion
    double ao_radius_m = 0.0;  ///< reach of an occlusion ray; 0 = unbounded
};

/// Weier 2016 3.2-3.5. The paper names no thresholds; ours are explained in docs/reprojected.md.
struct ReprojectionSettings {
    int support_width_px = 0;     ///< 0: 256 at 1182 wide, scaled with the eye's width
    int support_height_px = 0;    ///< 0: 318 at 1464 high
    double epsilon_depth = 0.30;  ///< depth step to a neighbour, as a share of the depth: resample
    double epsilon_lum = 0.25;    ///< luminance step to a neighbour, of full scale: resample
    double epsilon_grazing = 0.10;  ///< cosine of mesh normal and view below which to resample
    double epsilon_cache =
        0.05;             ///< depth difference of cache and sample, share of depth: drop the cache
    double k_min = 0.10;  ///< weight of a new sample when the old one is one frame old
    double k_max = 1.00;  ///< ... and when it is t_max frames old
    int t_max = 30;       ///< frames
    double k_min_light = 0.05;  ///< the same for the light buffer (3.1: its own rate)
    int footprint_samples = 2;  ///< normally distributed taps of a reprojected pixel: 1, 2, 4 or 8
    double footprint_sigma = 0.30;  ///< of the footprint's width
    int post_samples = 2;           ///< n of 3.5; more found no better neighbour
    int post_search_px = 16;        ///< furthest neighbour that 3.5 looks for
    bool oversampling = false;      ///< jitter primary rays over the pixel and accumulate (5)
};

struct ReferenceSettings {
    int samples = 256;  ///< most samples a pixel
    int max_bounces = 4;
    double target_error = 0.0;  ///< stop when the estimated relative error is below; 0 = never
};

struct RenderSettings {
    std::string pipeline = "reprojected";  ///< full | reprojected | reference
    std::string backend = "auto";          ///< auto | embree | host-bvh | cuda
    int threads = 0;                       ///< 0: one a core
    std::uint32_t seed = 1;
    bool robust_tracing = true;  ///< watertight edges; false is faster and may leak light at edges
    FoveationSettings foveation;
    LightingSettings lighting;
    ReprojectionSettings reprojection;
    ReferenceSettings reference;
    /// effects.<name> = "off"; an absent name means "auto". Never "force".
    std::map<std::string, std::string> effects;
};

}  // namespace foverig
