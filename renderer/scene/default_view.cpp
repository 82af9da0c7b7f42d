#include "renderer/scene/default_view.h"

#include "renderer/scene/default_lights.h"
#include "renderer/scene/flight.h"
#include "renderer/scene/known_flights.h"
#include "renderer/scene/lights_from_emission.h"

namespace foverig::scene_import {

void add_default_view(Scene& scene) {
    const Occupancy grid(scene);
    const bool indoors = grid.room_share() > kRoomShare;
    std::optional<std::vector<CameraKey>> keys = known_flight(scene);
    if (!keys && indoors) keys = flight_before_stage(grid, scene.bounds);
    if (!keys && indoors) keys = flight_through_rooms(grid);
    scene.camera_path = keys ? *keys : flight_around(scene.bounds);
    scene.ambient = vec3(0.25F);
    scene.background = indoors ? vec3(0.30F, 0.42F, 0.60F) : vec3(0.05F, 0.06F, 0.08F);
    if (add_lights_from_emission(scene) == 0)
        scene.point_lights.push_back(indoors && keys ? light_over_flight(scene, grid, *keys)
                                                     : light_beside_object(scene));
}

}  // namespace foverig::scene_import
