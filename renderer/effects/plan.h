#pragma once
// Only what a scene calls for: computed from the scene and the settings, never from flags that a
// person must set. Pipelines ask the plan; an effect that is off allocates and launches nothing.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/settings.h"

namespace foverig {

enum class Effect {
    textures,
    alpha_mask,
    point_light,
    area_light,
    ambient_occlusion,
    light_buffer,
    moving_geometry,
    reprojection,
    oversampling,
    post_process,
    count,
};

struct PassTime {
    std::string name;  ///< the launch name
    double ms = 0.0;   ///< share of the frame's wall time
};

struct PlannedEffect {
    std::string name;
    bool on = false;
    std::string because;                 ///< what in the scene or the settings decides it
    std::vector<std::string> passes;     ///< launch names it adds; empty while off
    std::optional<std::uint64_t> bytes;  ///< memory it adds; 0 while off, absent before a frame
    double measured_ms = -1.0;           ///< mean a frame of its passes; < 0: not measured yet
};

class EffectPlan {
  public:
    EffectPlan() = default;
    EffectPlan(const Scene& scene, const RenderSettings& settings);

    bool on(Effect effect) const { return effects_[static_cast<std::size_t>(effect)].on; }
    const std::vector<PlannedEffect>& effects() const { return effects_; }
    PlannedEffect& operator[](Effect effect) { return effects_[static_cast<std::size_t>(effect)]; }

    /// Whether the other plan has the same effects on.
    bool same_effects(const EffectPlan& other) const;
    /// The other plan's reasons; what was measured stays.
    void take_reasons(const EffectPlan& other);

    /// Takes the pass times of the `frames`-th frame into each effect's mean cost.
    void record_frame(const std::vector<PassTime>& passes, std::uint64_t frames);
    /// Takes what is allocated now for that effect, all eyes.
    void record_bytes(Effect effect, std::uint64_t bytes);

  private:
    std::vector<PlannedEffect> effects_;
};

/// Names that `effects.<name>` may use, in the order of Effect.
const std::vector<std::string>& effect_names();
/// For an effect that cannot be turned off by itself, what it follows from; else empty.
std::string_view follows_from(std::string_view effect);

}  // namespace foverig
