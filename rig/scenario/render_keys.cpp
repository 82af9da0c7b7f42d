#include "rig/scenario/render_keys.h"

#include "renderer/effects/plan.h"
#include "renderer/renderer.h"
#include "rig/scenario/foveation_configuration.h"
#include "rig/scenario/key_makers.h"

namespace foverig {

void add_renderer_keys(std::vector<Key>& keys) {
    keys.push_back(choice_key(
        "pipeline", pipeline_names(), "how a frame is made",
        [](auto& s) -> auto& { return s.render.pipeline; }));
    keys.push_back(choice_key(
        "backend", backend_names(), "what traces the rays",
        [](auto& s) -> auto& { return s.render.backend; }));
    keys.push_back(integer_key(
        "threads", "", {0, 1024}, "of the backend; 0 = one a core",
        [](auto& s) -> auto& { return s.render.threads; }));
    keys.push_back(integer_key(
        "seed", "", {0, 4294967295.0}, "of every random choice: sampling, motion, faults",
        [](auto& s) -> auto& { return s.render.seed; }));
}

void add_foveation_keys(std::vector<Key>& keys) {
    Key configuration = text_key(
        "foveation.configuration", "one of " + joined(foveation_configurations()),
        "Weier 2016: sets r0_deg, r1_deg and p_min together; these three win where given",
        [](auto& s) -> auto& { return s.render.pipeline; });
    configuration.get = [](const Scenario& s) {
        return KeyValue(foveation_configuration(s.render.foveation));
    };
    configuration.set = [expected = configuration.expected](
                            Scenario& s, const KeyValue& v) -> std::optional<std::string> {
        const auto& name = std::get<std::string>(v);
        const auto& known = foveation_configurations();
        if (std::find(known.begin(), known.end(), name) == known.end()) return expected;
        apply_foveation_configuration(name, s.render.foveation);
        return std::nullopt;
    };
    keys.push_back(std::move(configuration));
    keys.push_back(number_key(
        "foveation.r0_deg", "deg", {0.0, 180.0}, "every pixel is traced this close to the gaze",
        [](auto& s) -> auto& { return s.render.foveation.r0_deg; }));
    keys.push_back(number_key(
        "foveation.r1_deg", "deg", {0.0, 180.0},
        "p_min of the pixels from here on; linear between; >= r0_deg",
        [](auto& s) -> auto& { return s.render.foveation.r1_deg; }));
    keys.push_back(number_key(
        "foveation.p_min", "", {0.0, 1.0}, "share of the pixels traced in the periphery",
        [](auto& s) -> auto& { return s.render.foveation.p_min; }));
}

void add_lighting_keys(std::vector<Key>& keys) {
    keys.push_back(flag_key(
        "lighting.point_lights", "use the scene's point lights",
        [](auto& s) -> auto& { return s.render.lighting.point_lights; }));
    keys.push_back(flag_key(
        "lighting.area_lights", "use the scene's area lights",
        [](auto& s) -> auto& { return s.render.lighting.area_lights; }));
    keys.push_back(integer_key(
        "lighting.area_samples", "", {0, 1024}, "shadow rays a pixel for each area light",
        [](auto& s) -> auto& { return s.render.lighting.area_samples; }));
    keys.push_back(integer_key(
        "lighting.ao_samples", "", {0, 1024}, "ambient occlusion rays a pixel",
        [](auto& s) -> auto& { return s.render.lighting.ao_samples; }));
    keys.push_back(number_key(
        "lighting.ao_radius_m", "m", {0.0, 1e6}, "reach of an occlusion ray; 0 = unbounded",
        [](auto& s) -> auto& { return s.render.lighting.ao_radius_m; }));
}

void add_reference_keys(std::vector<Key>& keys) {
    keys.push_back(integer_key(
        "reference.samples", "", {1, 1'000'000}, "most samples a pixel of the reference pipeline",
        [](auto& s) -> auto& { return s.render.reference.samples; }));
    keys.push_back(integer_key(
        "reference.max_bounces", "", {0, 64}, "of its paths",
        [](auto& s) -> auto& { return s.render.reference.max_bounces; }));
    keys.push_back(number_key(
        "reference.target_error", "", {0.0, 1.0},
        "stop below this estimated relative error; 0 = never",
        [](auto& s) -> auto& { return s.render.reference.target_error; }));
}

void add_effect_keys(std::vector<Key>& keys) {
    for (const std::string& effect : effect_names()) {
        const std::string cause(follows_from(effect));
        keys.push_back(
            {.name = "effects." + effect,
             .type = KeyType::text,
             .expected = cause.empty() ? "auto or off" : "auto",
             .help = cause.empty() ? "auto: on where the scene and the settings call for it"
                                   : "follows from " + cause,
             .get =
                 [effect](const Scenario& s) {
                     const auto found = s.render.effects.find(effect);
                     return KeyValue(found == s.render.effects.end() ? "auto" : found->second);
                 },
             .set = [effect, cause](Scenario& s, const KeyValue& v) -> std::optional<std::string> {
                 const auto& value = std::get<std::string>(v);
                 if (!cause.empty() && value != "auto")
                     return "auto, since it follows from " + cause + "; change that";
                 if (value != "auto" && value != "off") return "auto or off";
                 s.render.effects[effect] = value;
                 return std::nullopt;
             }});
    }
}

}  // namespace foverig
