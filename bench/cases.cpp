#include "bench/cases.h"

#include <fmt/format.h>

#include <stdexcept>

#include "renderer/scene/library.h"
#include "rig/scenario/foveation_configuration.h"

namespace foverig::bench {
namespace {

constexpr double kShortReachShare = 0.05;  ///< of the scene's diagonal (PERFORMANCE.md 6.4)
constexpr float kLampShare = 0.03F;

double diagonal_m(const Scene& scene) {
    return double{glm::length(scene.bounds.max_m - scene.bounds.min_m)};
}

AreaLight lamp_at(const PointLight& light, float side_m) {
    const vec3 u(side_m, 0.0F, 0.0F);
    const vec3 v(0.0F, 0.0F, side_m);
    return {light.position_m - 0.5F * (u + v), u, v, light.intensity / (side_m * side_m)};
}

PointLight bulb_in(const AreaLight& light) {
    const float area_m2 = glm::length(glm::cross(light.edge_u_m, light.edge_v_m));
    return {light.corner_m + 0.5F * (light.edge_u_m + light.edge_v_m), light.radiance * area_m2};
}

/// The scene's own first light as the kind that the load asks for, and no other light.
void leave_one_light(Scene& scene, Load load) {
    if (scene.point_lights.empty() && scene.area_lights.empty())
        throw std::runtime_error(fmt::format("scene {} has no light", scene.name));
    const bool has_point = !scene.point_lights.empty();
    const PointLight point = has_point ? scene.point_lights[0] : bulb_in(scene.area_lights[0]);
    const AreaLight area = !scene.area_lights.empty()
                               ? scene.area_lights[0]
                               : lamp_at(point, kLampShare * static_cast<float>(diagonal_m(scene)));
    scene.point_lights.clear();
    scene.area_lights.clear();
    if (load == Load::point) scene.point_lights.push_back(point);
    if (load == Load::area8) scene.area_lights.push_back(area);
}

std::filesystem::path file_of(const Options& options, const std::string& name) {
    return options.scenes / name / (name == "sponza" ? "sponza.glb" : name + ".obj");
}

}  // namespace

const char* name_of(Load load) {
    switch (load) {
        case Load::point:
            return "point";
        case Load::area8:
            return "area8";
        case Load::ao16:
            return "ao16";
        default:
            return "ao16_short";
    }
}

const std::vector<std::string>& scene_names() {
    static const std::vector<std::string> names = {"sponza", "sibenik"};
    return names;
}

Case SceneShelf::take(const std::string& name, Load load) {
    if (name != name_) {
        const std::filesystem::path file = file_of(options_, name);
        const bool there = std::filesystem::exists(file);
        scene_ = there ? load_scene(file.string()) : make_builtin_scene("atrium");
        note_ = there ? "" : fmt::format("{} is not there: built-in atrium instead", file.string());
        name_ = name;
    }
    Case made;
    Scene scene = scene_;
    leave_one_light(scene, load);
    RenderSettings& s = made.settings;
    s.robust_tracing = options_.robust;
    apply_foveation_configuration("medium", s.foveation);
    s.lighting.area_samples = load == Load::area8 ? 8 : 0;
    s.lighting.ao_samples = load == Load::ao16 || load == Load::ao16_short ? 16 : 0;
    if (load == Load::ao16_short) s.lighting.ao_radius_m = kShortReachShare * diagonal_m(scene);
    made.scene = std::make_shared<const Scene>(std::move(scene));
    made.note = note_;
    return made;
}

}  // namespace foverig::bench
