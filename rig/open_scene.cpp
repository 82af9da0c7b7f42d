#include "rig/open_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "renderer/scene/library.h"
#include "rig/failure.h"
#include "rig/text/nearest.h"

namespace foverig {

std::shared_ptr<const Scene> open_scene(const Scenario& scenario) {
    std::vector<std::string> names;
    for (const BuiltinInfo& scene : builtin_scenes()) names.push_back(scene.name);
    if (std::find(names.begin(), names.end(), scenario.scene) != names.end()) {
        return std::make_shared<Scene>(make_builtin_scene(scenario.scene, scenario.scene_detail));
    }
    const std::filesystem::path file = scenario.scene;
    std::error_code error;
    if (!file.has_extension() && !std::filesystem::exists(file, error)) {
        throw UsageError(fmt::format(
            "scene {}: neither a built-in scene nor a file; the nearest built-in one is {} "
            "(foverig scenes lists them)", scenario.scene, nearest(scenario.scene, names)));
    }
    ImportSettings settings;
    settings.metres_per_unit = scenario.scene_scale;
    return std::make_shared<Scene>(import_scene(file, settings));
}

std::unique_ptr<Renderer> open_renderer(std::shared_ptr<const Scene> scene,
                                        const RenderSettings& settings) {
    try {
        return make_renderer(std::move(scene), settings);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

std::unique_ptr<LensPass> open_lens(const Scenario& scenario) {
    return scenario.display.distortion ? std::make_unique<LensPass>(scenario) : nullptr;
}

}  // namespace foverig
