#include "rig/scenario/world_keys.h"

#include "rig/scenario/key_makers.h"

namespace foverig {

void add_camera_keys(std::vector<Key>& keys) {
    keys.push_back(choice_key(
        "camera.path", {"scene", "keys", "still"},
        "scene: fly the scene's own path; keys: fly camera.keys_m; still: "
        "stand at position_m",
        [](auto& s) -> auto& { return s.camera.path; }));
    keys.push_back(point_key(
        "camera.position_m", "where to stand when camera.path is still",
        [](auto& s) -> auto& { return s.camera.position_m; }));
    keys.push_back(point_key(
        "camera.target_m", "what to look at when camera.path is still",
        [](auto& s) -> auto& { return s.camera.target_m; }));
    keys.push_back(numbers_key(
        "camera.keys_m", 6, "six numbers a key: position x, y, z, target x, y, z (m)",
        "the way to fly, there and back, when camera.path is keys",
        [](auto& s) -> auto& { return s.camera.keys_m; }));
    keys.push_back(number_key(
        "camera.one_way_s", "s", {0.0, 86'400.0},
        "time of one flight along the path; 0 = the scene's",
        [](auto& s) -> auto& { return s.camera.one_way_s; }));
}

void add_light_keys(std::vector<Key>& keys) {
    keys.push_back(flag_key(
        "lights.keep", "false: leave the scene's own lights out",
        [](auto& s) -> auto& { return s.lights.keep; }));
    keys.push_back(numbers_key(
        "lights.points_m", 3, "three numbers a light: x, y, z (m)", "point lights to add",
        [](auto& s) -> auto& { return s.lights.points_m; }));
    keys.push_back(number_key(
        "lights.point_intensity", "W/sr", {0.0, 1e9}, "of each light in lights.points_m",
        [](auto& s) -> auto& { return s.lights.point_intensity; }));
    keys.push_back(numbers_key(
        "lights.areas_m", 9, "nine numbers a light: corner, edge and other edge, x, y, z each (m)",
        "parallelograms of light to add; both sides shine",
        [](auto& s) -> auto& { return s.lights.areas_m; }));
    keys.push_back(number_key(
        "lights.area_radiance", "W/sr/m2", {0.0, 1e9}, "of each light in lights.areas_m",
        [](auto& s) -> auto& { return s.lights.area_radiance; }));
}

}  // namespace foverig
