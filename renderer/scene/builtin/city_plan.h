#pragma once
// The city's measures, paints and pieces. Blocks lie on a grid about the origin, streets between
// them; a facade is made in its own frame: x along it, y up, +z out to the street, wall at z = 0.
#include <array>

#include "renderer/scene/builtin/scene_builder.h"

namespace foverig::builtin::city {

inline constexpr float kPitchX_m = 66.0F;
inline constexpr float kPitchZ_m = 56.0F;
inline constexpr float kStreet_m = 12.0F;  ///< kerb to kerb
inline constexpr float kSidewalk_m = 3.4F;
inline constexpr float kKerb_m = 0.14F;  ///< height of the sidewalk over the street

struct Paints {
    std::array<Surface, 7> walls;  ///< two bricks, four plasters, ashlar
    Surface trim, dark_trim, concrete, asphalt, sidewalk, roof, grass, metal, paint_white, wood,
        bark;
    std::array<std::uint16_t, 4> glass;  ///< clear to curtained
    std::array<std::uint16_t, 6> cars;
    std::array<Surface, 5> awnings;
    std::uint16_t tyre, headlight, taillight, lamp, foliage, water;
};
Paints add_paints(SceneBuilder& builder);

enum class Windows { punched, tall, ribbon, curtain };

/// What one building's facades have in common.
struct Look {
    Windows windows = Windows::punched;
    Surface wall, trim;
    float bay_m = 3.0F;
    float storey_m = 3.2F;
    int storeys = 5;  ///< above the ground floor
    bool balconies = false;
    bool shops = true;
    std::uint32_t seed = 0;

    float height_m() const { return kGroundFloor_m + storey_m * static_cast<float>(storeys); }
    static constexpr float kGroundFloor_m = 4.2F;
};
Look make_look(const Paints& paints, int storeys, std::uint32_t seed);

// city_facade.cpp, city_windows.cpp
Mesh make_facade(const Paints& paints, const Look& look, float width_m);
struct Opening {
    float x0, x1, y0, y1;
};
/// A cell of wall with a glazed opening in it, set back, with frame and sill.
void add_window(Mesh& mesh, const Paints& paints, const Look& look, const Opening& cell,
                const Opening& hole, std::uint16_t glass);
void add_balcony(Mesh& mesh, const Paints& paints, const Opening& hole);

// city_building.cpp: turned and placed; `street_sides` has bit k where the side that faces
// k quarter turns from +z looks on a street; the others are blank walls.
void add_building(Mesh& mesh, const Paints& paints, const Look& look, const vec3& centre_m,
                  vec2 size_m, unsigned street_sides);

// city_street.cpp, city_traffic.cpp
void lay_streets(Mesh& mesh, const Paints& paints, int blocks_x, int blocks_z);
Mesh make_street_lamp(const Paints& paints);
Mesh make_bench(const Paints& paints);
Mesh make_car(const Paints& paints, std::uint32_t seed);

}  // namespace foverig::builtin::city
