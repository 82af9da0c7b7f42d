#pragma once
// The renderer as the rig sees it: a scene and settings go in, images and counts come out. It knows
// no device, reads no clock but the backend's pass timers, and keeps its history between frames.
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/effects/plan.h"
#include "renderer/half.h"
#include "renderer/image.h"
#include "renderer/scene/scene.h"
#include "renderer/settings.h"
#include "renderer/view.h"

namespace foverig {

struct FrameInput {
    std::uint32_t frame = 0;     ///< 0, 1, 2, ...; a jump drops the history's age, not the history
    double time_s = 0.0;         ///< where moving parts stand
    std::vector<EyeInput> eyes;  ///< one or two
};

struct FrameStats {
    double render_ms = 0.0;  ///< wall time of render(), all eyes
    std::vector<PassTime> passes;
    RayCounts rays;
    std::uint64_t sampled_pixels = 0;  ///< pixels that got a primary ray
    std::uint64_t all_pixels = 0;
    NumericCounts numerics;
};

class Renderer {
  public:
    virtual ~Renderer() = default;
    virtual FrameStats render(const FrameInput& input) = 0;
    /// Other settings from the next frame on, with the history that there is. False, and nothing
    /// changed, where they need a renderer of their own: what is allocated would be another.
    virtual bool tune(const RenderSettings& /*settings*/) { return false; }

    virtual const EffectPlan& plan() const = 0;
    virtual std::string backend_name() const = 0;
    virtual std::uint64_t backend_bytes() const = 0;

    /// The last frame of that eye: linear RGB, not yet distorted; as reports and metrics want it.
    virtual Image image(int eye) const = 0;
    /// The same as displays want it, where it lies, row by row; until the next render().
    virtual View<const Half4> pixels(int eye) const = 0;
    /// Copies the same into a texture of the current OpenGL context (2D, RGBA16F, of its size)
    /// without the host; false: this renderer cannot, take pixels().
    virtual bool copy_to_texture(int /*eye*/, unsigned int /*gl_texture*/) const { return false; }
    /// 1 where the last frame traced a primary ray. Empty for pipelines that trace every pixel.
    virtual Mask sampling_mask(int eye) const = 0;
    /// 1 where the last frame found the reprojection wanting (Weier 2016 3.3).
    virtual Mask resampling_mask(int eye) const = 0;
    /// Estimated relative error of the last frame's mean; < 0 where the pipeline has no estimate.
    virtual double estimated_error() const { return -1.0; }
};

/// What a setting of backend comes to on this machine.
struct BackendChoice {
    std::string name;  ///< embree, host-bvh or cuda
    std::string why;   ///< of `auto`: the reason; else empty
};

/// `auto` is the GPU where there is one that renders this pipeline, else Embree. Throws
/// std::invalid_argument for an unknown backend, naming the known ones.
BackendChoice choose_backend(const RenderSettings& settings);

/// Throws std::invalid_argument for an unknown pipeline or backend, naming the known ones, and
/// BackendError where that backend cannot be had.
std::unique_ptr<Renderer> make_renderer(std::shared_ptr<const Scene> scene,
                                        const RenderSettings& settings);

std::vector<std::string> pipeline_names();
std::vector<std::string> backend_names();

}  // namespace foverig
