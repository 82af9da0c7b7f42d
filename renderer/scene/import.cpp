#include <algorithm>
#include <cctype>
#include <new>

#include "renderer/check.h"
#include "renderer/scene/default_view.h"
#include "renderer/scene/flatten.h"
#include "renderer/scene/import_error.h"
#include "renderer/scene/imported.h"

namespace foverig {

using scene_import::fail;
using scene_import::ImportContext;
using scene_import::ImportedScene;

namespace {

inline constexpr std::size_t kMostNotes = 20;

/// mesh.glb.zst is mesh.glb: read_file unpacks it.
std::filesystem::path unpacked_name(std::filesystem::path file) {
    if (file.extension() == ".zst") file.replace_extension();
    return file;
}

ImportedScene read_by_suffix(const ImportContext& context) {
    std::string suffix = unpacked_name(context.file).extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix == ".obj") return scene_import::import_obj(context);
    if (suffix == ".gltf" || suffix == ".glb") return scene_import::import_gltf(context);
    if (suffix == ".ply") return scene_import::import_ply(context);
    fail(context.file,
         "has the suffix '{}'; expected .obj, .gltf, .glb or .ply, or one of them with .zst",
         suffix);
}

Scene import_checked(const ImportContext& context) {
    if (!(context.settings.metres_per_unit > 0.0 && context.settings.metres_per_unit < 1.0e30))
        fail(context.file, "cannot be imported with metres_per_unit {}; it must be above 0",
             context.settings.metres_per_unit);
    ImportedScene imported = read_by_suffix(context);
    scene_import::flatten(imported, context);
    Scene scene = std::move(imported.scene);
    scene.name = unpacked_name(context.file).stem().string();
    update_bounds(scene);
    scene_import::add_default_view(scene);
    // Thousands of missing materials are one finding, not thousands.
    if (scene.notes.size() > kMostNotes) {
        const std::size_t more = scene.notes.size() - kMostNotes;
        scene.notes.resize(kMostNotes);
        scene.notes.push_back(fmt::format("and {} more of the kind", more));
    }
    check_scene(scene);
    return scene;
}

}  // namespace

Scene import_scene(const std::filesystem::path& file, const ImportSettings& settings) {
    try {
        return import_checked({file, settings});
    } catch (const SceneError&) {
        throw;
    } catch (const InternalError&) {
        throw;
    } catch (const std::bad_alloc&) {
        fail(file, "needs more memory than there is; take a smaller scene");
    } catch (const std::exception& error) {
        fail(file, "cannot be read ({})", error.what());
    }
}

Scene load_scene(const std::string& name_or_file, const ImportSettings& settings) {
    const std::vector<BuiltinInfo> builtins = builtin_scenes();
    const auto known = [&](const BuiltinInfo& info) { return info.name == name_or_file; };
    if (std::any_of(builtins.begin(), builtins.end(), known))
        return make_builtin_scene(name_or_file);
    if (std::filesystem::path(name_or_file).extension().empty()) {
        std::string names;
        for (const BuiltinInfo& info : builtins) names += (names.empty() ? "" : ", ") + info.name;
        throw SceneError(name_or_file + ": is neither a built-in scene (" + names +
                         ") nor an .obj, .gltf, .glb or .ply file");
    }
    return import_scene(name_or_file, settings);
}

}  // namespace foverig
