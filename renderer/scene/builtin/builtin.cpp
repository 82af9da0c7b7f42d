#include <array>
#include <cmath>

#include "renderer/check.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/error.h"
#include "renderer/scene/library.h"

namespace foverig {
namespace {

struct Entry {
    const char* name;
    const char* summary;
    Scene (*make)(double detail);
};

constexpr std::array kEntries{
    Entry{"cornell",
          "Cornell box with a turning torus knot; one area light, one point light; 13 k triangles",
          builtin::make_cornell},
    Entry{"atrium",
          "colonnaded court on two storeys with curtains, plants and lattices; 150 k triangles",
          builtin::make_atrium},
    Entry{"tunnel-geom",
          "tunnel of noisy displaced rock (the paper's Tunnel_geom); 200 k triangles",
          builtin::make_tunnel_geom},
    Entry{
        "tunnel-maps",
        "smooth tunnel with checkerboard and noise maps (the paper's Tunnel_Maps); 12 k triangles",
        builtin::make_tunnel_maps},
    Entry{"voxel-town",
          "town of 1 m blocks with many depth discontinuities; 400 k triangles, 6.7 M at detail 16",
          builtin::make_voxel_town},
    Entry{"city",
          "blocks of varied buildings, streets, cars and trees (for Urban Sprawl); 770 k triangles",
          builtin::make_city},
};

}  // namespace

namespace builtin {

int finer(int count, double detail, int least) {
    const double scaled = std::floor(static_cast<double>(count) * std::sqrt(detail) + 0.5);
    return scaled < least ? least : static_cast<int>(scaled);
}

}  // namespace builtin

std::vector<BuiltinInfo> builtin_scenes() {
    std::vector<BuiltinInfo> infos;
    for (const Entry& entry : kEntries) infos.push_back({entry.name, entry.summary});
    return infos;
}

Scene make_builtin_scene(std::string_view name, double detail) {
    if (!(detail >= 0.01 && detail <= 64.0)) {
        throw SceneError(
            fmt::format("scene '{}': detail is {}, expected 0.01 to 64", name, detail));
    }
    std::string known;
    for (const Entry& entry : kEntries) {
        if (name == entry.name) return entry.make(detail);
        known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.name);
    }
    throw SceneError(fmt::format("there is no built-in scene '{}'; there are {}", name, known));
}

}  // namespace foverig
