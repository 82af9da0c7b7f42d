#include "rig/open_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "devices/display/display.h"
#include "renderer/scene/library.h"
#include "rig/failure.h"
#include "rig/text/nearest.h"

namespace foverig {
namespace {

void apply_lights(const LightSettings& settings, Scene& scene) {
    if (!settings.keep) {
        scene.point_lights.clear();
        scene.area_lights.clear();
    }
    const auto vector_at = [](const std::vector<double>& numbers, std::size_t i) {
        return dvec3(numbers[i], numbers[i + 1], numbers[i + 2]);
    };
    for (std::size_t i = 0; i < settings.points_m.size(); i += 3) {
        scene.point_lights.push_back({vec3(vector_at(settings.points_m, i) - scene.origin_m),
                                      vec3(static_cast<float>(settings.point_intensity))});
    }
    for (std::size_t i = 0; i < settings.areas_m.size(); i += 9) {
        scene.area_lights.push_back({vec3(vector_at(settings.areas_m, i) - scene.origin_m),
                                     vec3(vector_at(settings.areas_m, i + 3)),
                                     vec3(vector_at(settings.areas_m, i + 6)),
                                     vec3(static_cast<float>(settings.area_radiance))});
    }
}

std::vector<std::string> builtin_names() {
    std::vector<std::string> names;
    for (const BuiltinInfo& scene : builtin_scenes()) names.push_back(scene.name);
    return names;
}

bool is_builtin(const std::string& scene) {
    const auto names = builtin_names();
    return std::find(names.begin(), names.end(), scene) != names.end();
}

Scene load(const Scenario& scenario) {
    if (is_builtin(scenario.scene))
        return make_builtin_scene(scenario.scene, scenario.scene_detail);
    require_scene(scenario);
    ImportSettings settings;
    settings.metres_per_unit = scenario.scene_scale;
    return import_scene(scenario.scene, settings);
}

}  // namespace

void require_scene(const Scenario& scenario) {
    const std::filesystem::path file = scenario.scene;
    std::error_code error;
    if (is_builtin(scenario.scene) || std::filesystem::exists(file, error)) return;
    if (file.has_extension())
        throw InputError(fmt::format(
            "{}: there is no such file; name an .obj, .gltf, .glb or .ply file", scenario.scene));
    throw UsageError(
        fmt::format("scene {}: neither a built-in scene nor a file; the nearest built-in one is {} "
                    "(foverig scenes lists them)",
                    scenario.scene, nearest(scenario.scene, builtin_names())));
}

std::shared_ptr<const Scene> open_scene(const Scenario& scenario, bool sees_through) {
    Scene scene = load(scenario);
    apply_lights(scenario.lights, scene);
    if (sees_through) scene.background = {kNothingMet[0], kNothingMet[1], kNothingMet[2]};
    return std::make_shared<const Scene>(std::move(scene));
}

std::unique_ptr<Renderer> open_renderer(std::shared_ptr<const Scene> scene,
                                        const RenderSettings& settings) {
    try {
        return make_renderer(std::move(scene), settings);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

std::string backend_text(const Renderer& renderer, const RenderSettings& settings) {
    const std::string why = choose_backend(settings).why;
    return why.empty() ? renderer.backend_name()
                       : fmt::format("{} ({})", renderer.backend_name(), why);
}

std::unique_ptr<LensPass> open_lens(const Scenario& scenario) {
    return scenario.display.distortion ? std::make_unique<LensPass>(scenario) : nullptr;
}

}  // namespace foverig
