#pragma once
// The atrium's measures and paints, and the pieces it is put together from. Every piece of an
// arcade is made in the frame of a bay: x along the arcade, 0 in the bay's middle; z = 0 on the
// columns' axis, +z towards the court; y = 0 on the court's floor.
#include "renderer/scene/builtin/mesh.h"
#include "renderer/scene/builtin/scene_builder.h"

namespace foverig::builtin::atrium {

inline constexpr int kBaysLong = 9;
inline constexpr int kBaysShort = 4;
inline constexpr float kBay_m = 2.8F;
inline constexpr float kCourtHalfX_m = 0.5F * kBaysLong * kBay_m;
inline constexpr float kCourtHalfZ_m = 0.5F * kBaysShort * kBay_m;
inline constexpr float kGallery_m = 3.6F;    ///< columns' axis to outer wall
inline constexpr float kWallHalf_m = 0.25F;  ///< of the arcade's wall

inline constexpr float kSpring_m = 3.3F;  ///< where the ground floor's arches begin
inline constexpr float kUpperFloor_m = 5.2F;
inline constexpr float kRail_m = kUpperFloor_m + 0.95F;
inline constexpr float kUpperSpring_m = 8.0F;
inline constexpr float kEaves_m = 9.8F;

struct Paints {
    Surface stone, pale_stone, brick, plaster, vault, floor, inlay, wood, roof, terracotta, iron;
    std::uint16_t red_cloth, green_cloth, blue_cloth, lace, pennant, leaf, foliage, glow, water;
};
Paints add_paints(SceneBuilder& builder);

// atrium_arcade.cpp
Mesh make_column(const Paints& paints, double detail);
Mesh make_upper_column(const Paints& paints, double detail);
Mesh make_corner_pier(const Paints& paints);
Mesh make_arcade_bay(const Paints& paints, double detail);
Mesh make_balustrade(const Paints& paints, double detail);

// atrium_gallery.cpp
Mesh make_gallery_bay(const Paints& paints, double detail);
Mesh make_gallery_corner(const Paints& paints, double detail);
Mesh make_door(const Paints& paints);
Mesh make_window(const Paints& paints);

// atrium_decor.cpp
enum class Hanging { red, green, blue, lace };
/// Two drapes tied back to the columns, or one closed sheet of lace.
Mesh make_curtain(const Paints& paints, Hanging hanging, double detail, std::uint32_t seed);
Mesh make_banner(const Paints& paints, double detail, std::uint32_t seed);
Mesh make_lantern(const Paints& paints);
Mesh make_fountain(const Paints& paints, double detail);
Mesh make_pot(const Paints& paints, double detail);
/// Leaves only: goes into the part with alpha. Rooted at the origin.
Mesh make_fern(const Paints& paints, std::uint32_t seed);
Mesh make_ivy(const Paints& paints, std::uint32_t seed);

}  // namespace foverig::builtin::atrium
