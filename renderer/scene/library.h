#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"

namespace foverig {

struct ImportSettings {
    double metres_per_unit = 1.0;              ///< 0.001 for a file in millimetres
    std::uint64_t max_triangles = 64'000'000;  ///< after instances are unfolded
    std::uint64_t max_texture_px = 1U << 28U;  ///< of one image, before mips
};

/// Reads OBJ+MTL, glTF 2.0, GLB or PLY (by suffix). Throws SceneError with one clear sentence that
/// names the file. Never fetches, never reads outside the file's own folder.
Scene import_scene(const std::filesystem::path& file, const ImportSettings& settings = {});

struct BuiltinInfo {
    std::string name;
    std::string summary;
};
std::vector<BuiltinInfo> builtin_scenes();

/// Makes the scene of that name; the same name and detail give the same bytes on every machine.
/// `detail` scales the triangle count (1 = the size documented for the scene).
Scene make_builtin_scene(std::string_view name, double detail = 1.0);

/// A built-in name, or else a file to import.
Scene load_scene(const std::string& name_or_file, const ImportSettings& settings = {});

}  // namespace foverig
