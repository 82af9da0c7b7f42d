#include "renderer/effects/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foverig {
namespace {

struct Finding {
    bool called_for = false;
    std::string because;
};

Finding textures(const Scene& scene) {
    const auto used = std::count_if(
        scene.materials.begin(), scene.materials.end(),
        [](const Material& m) { return m.diffuse_texture >= 0 || m.emission_texture >= 0; });
    const bool on = used > 0 && !scene.textures.empty() && !scene.texcoords.empty();
    return {on, on ? fmt::format("{} of {} materials have a texture", used, scene.materials.size())
                   : "no material has a texture"};
}

Finding alpha_mask(const Scene& scene) {
    std::size_t triangles = 0;
    for (const Part& part : scene.parts) triangles += part.alpha_masked ? part.triangle_count : 0U;
    return {triangles > 0, triangles > 0
                               ? fmt::format("{} triangles have transparent texels", triangles)
                               : "no triangle has a transparent texel"};
}

Finding point_light(const Scene& scene, const LightingSettings& s) {
    if (!s.point_lights) return {false, "lighting.point_lights is off"};
    const std::size_t n = scene.point_lights.size();
    return {n > 0, n > 0 ? fmt::format("the scene has {} point light{}", n, n == 1 ? "" : "s")
                         : "the scene has no point light"};
}

Finding area_light(const Scene& scene, const LightingSettings& s) {
    if (!s.area_lights) return {false, "lighting.area_lights is off"};
    if (s.area_samples <= 0) return {false, "lighting.area_samples is 0"};
    const std::size_t n = scene.area_lights.size();
    return {n > 0, n > 0 ? fmt::format("the scene has {} area light{}, {} samples each", n,
                                       n == 1 ? "" : "s", s.area_samples)
                         : "the scene has no area light"};
}

Finding ambient_occlusion(const Scene& scene, const LightingSettings& s) {
    if (s.ao_samples <= 0) return {false, "lighting.ao_samples is 0"};
    const bool lit = scene.ambient.x + scene.ambient.y + scene.ambient.z > 0.0F;
    return {lit, lit ? fmt::format("lighting.ao_samples is {} and the scene has ambient light",
                                   s.ao_samples)
                     : "the scene has no ambient light to occlude"};
}

Finding moving_geometry(const Scene& scene) {
    const auto n = std::count_if(scene.parts.begin(), scene.parts.end(),
                                 [](const Part& p) { return p.motion >= 0; });
    return {n > 0, n > 0 ? fmt::format("{} of {} parts move", n, scene.parts.size())
                         : "nothing in the scene moves"};
}

}  // namespace

const std::vector<std::string>& effect_names() {
    static const std::vector<std::string> names = {
        "textures",     "alpha_mask",      "point_light",  "area_light",   "ambient_occlusion",
        "light_buffer", "moving_geometry", "reprojection", "oversampling", "post_process"};
    return names;
}

std::string_view follows_from(std::string_view effect) {
    if (effect == "light_buffer") return "effects.area_light and effects.ambient_occlusion";
    if (effect == "reprojection") return "the pipeline";
    return {};
}

EffectPlan::EffectPlan(const Scene& scene, const RenderSettings& settings) {
    for (const auto& [name, value] : settings.effects) {
        const auto& known = effect_names();
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw std::invalid_argument(fmt::format("effects.{}: no such effect; known are {}",
                                                    name, fmt::join(known, ", ")));
        if (value != "auto" && value != "off")
            throw std::invalid_argument(
                fmt::format("effects.{} = \"{}\": expected \"auto\" or \"off\"; an effect that the "
                            "scene does not call for cannot be forced",
                            name, value));
        if (value == "off" && !follows_from(name).empty())
            throw std::invalid_argument(fmt::format(
                "effects.{} = \"off\": expected \"auto\", since it follows from {}; change that",
                name, follows_from(name)));
    }
    const auto add = [&](Finding finding, std::vector<std::string> passes) {
        PlannedEffect e;
        e.name = effect_names()[effects_.size()];
        const auto asked = settings.effects.find(e.name);
        const bool refused = asked != settings.effects.end() && asked->second == "off";
        e.on = finding.called_for && !refused;
        e.because = refused && finding.called_for
                        ? fmt::format("effects.{} is off (else: {})", e.name, finding.because)
                        : finding.because;
        if (e.on)
            e.passes = std::move(passes);
        else
            e.bytes = 0;
        effects_.push_back(std::move(e));
    };
    const bool reprojects = settings.pipeline == "reprojected";
    add(textures(scene), {});
    add(alpha_mask(scene), {});
    add(point_light(scene, settings.lighting), {"shadow_point", "shade_point_light"});
    add(area_light(scene, settings.lighting), {"shadow_area"});
    std::vector<std::string> occlusion{"ambient_occlusion"};
    if (settings.pipeline != "reference") occlusion.emplace_back("order_occlusion");
    add(ambient_occlusion(scene, settings.lighting), std::move(occlusion));
    const bool stochastic = on(Effect::area_light) || on(Effect::ambient_occlusion);
    add({stochastic, stochastic ? "area light or ambient occlusion is sampled"
                                : "no light is sampled at random"},
        {});
    add(moving_geometry(scene), {"move_geometry"});
    add({reprojects, reprojects ? "pipeline is reprojected"
                                : fmt::format("pipeline {} keeps no history", settings.pipeline)},
        {"reproject_vertices", "measure_facing", "reproject_coarse", "mark_resampling",
         "reproject_raster", "reproject", "cache_update", "merge"});
    add({settings.reprojection.oversampling, settings.reprojection.oversampling
                                                 ? "reprojection.oversampling is on"
                                                 : "reprojection.oversampling is off"},
        {});
    const bool noisy_reuse = reprojects && on(Effect::light_buffer);
    add({noisy_reuse, noisy_reuse
                          ? "resampled pixels carry light noise that their neighbours do not"
                          : "no light noise next to reused pixels"},
        {"post_process"});
}

bool EffectPlan::same_effects(const EffectPlan& other) const {
    return std::ranges::equal(effects_, other.effects_, {}, &PlannedEffect::on, &PlannedEffect::on);
}

void EffectPlan::take_reasons(const EffectPlan& other) {
    for (std::size_t i = 0; i < effects_.size(); ++i)
        effects_[i].because = other.effects_[i].because;
}

void EffectPlan::record_frame(const std::vector<PassTime>& passes, std::uint64_t frames) {
    for (PlannedEffect& effect : effects_) {
        if (effect.passes.empty()) continue;
        double ms = 0.0;
        for (const PassTime& pass : passes)
            if (std::find(effect.passes.begin(), effect.passes.end(), pass.name) !=
                effect.passes.end())
                ms += pass.ms;
        const double before = effect.measured_ms < 0.0 ? 0.0 : effect.measured_ms;
        effect.measured_ms = before + (ms - before) / static_cast<double>(frames);
    }
}

void EffectPlan::record_bytes(Effect effect, std::uint64_t bytes) {
    effects_[static_cast<std::size_t>(effect)].bytes = bytes;
}

}  // namespace foverig
