#include <array>

#include "renderer/scene/builtin/atrium_plan.h"
#include "renderer/scene/builtin/foliage.h"
#include "renderer/scene/builtin/scenes.h"
#include "renderer/scene/builtin/shapes.h"

namespace foverig::builtin {
namespace {

using namespace atrium;

struct Site {
    const Paints& paints;
    double detail;
    Mesh solid;
    Mesh masked;
};

struct Side {
    int bays;
    Placement frame;  ///< of the side's middle, on the columns' axis

    Placement at(float along_m, float up_m = 0.0F, float out_m = 0.0F) const {
        const vec3 shift = rotate_y({along_m, up_m, out_m}, frame.turns);
        return {frame.position_m + shift, frame.turns};
    }
    float bay_m(int bay) const {
        return kBay_m * (static_cast<float>(bay) - 0.5F * static_cast<float>(bays - 1));
    }
};

constexpr std::array<Side, 4> kSidesOfCourt{Side{kBaysLong, {{0.0F, 0.0F, -kCourtHalfZ_m}, 0.0F}},
                                            Side{kBaysShort, {{-kCourtHalfX_m, 0.0F, 0.0F}, 0.25F}},
                                            Side{kBaysLong, {{0.0F, 0.0F, kCourtHalfZ_m}, 0.5F}},
                                            Side{kBaysShort, {{kCourtHalfX_m, 0.0F, 0.0F}, 0.75F}}};

void build_house(Site& site) {
    const Mesh bay = [&] {
        Mesh mesh = make_arcade_bay(site.paints, site.detail);
        mesh.append(make_balustrade(site.paints, site.detail));
        mesh.append(make_gallery_bay(site.paints, site.detail));
        mesh.append(make_window(site.paints));
        mesh.append(make_lantern(site.paints), {{0.0F, 0.0F, -0.5F * kGallery_m}});
        return mesh;
    }();
    Mesh column = make_column(site.paints, site.detail);
    column.append(make_upper_column(site.paints, site.detail));
    const Mesh door = make_door(site.paints);
    const Mesh pier = make_corner_pier(site.paints);
    const Mesh corner = make_gallery_corner(site.paints, site.detail);
    for (const Side& side : kSidesOfCourt) {
        for (int i = 0; i < side.bays; ++i) {
            site.solid.append(bay, side.at(side.bay_m(i)));
            if (i > 0) site.solid.append(column, side.at(side.bay_m(i) - 0.5F * kBay_m));
            if (i % 2 == 1) site.solid.append(door, side.at(side.bay_m(i)));
        }
        const float end_m = 0.5F * kBay_m * static_cast<float>(side.bays);
        site.solid.append(pier, side.at(-end_m));
        site.solid.append(corner, side.at(-end_m));
    }
}

void lay_court(Site& site) {
    const float x = kCourtHalfX_m - kWallHalf_m;
    const float z = kCourtHalfZ_m - kWallHalf_m;
    add_quad(site.solid, site.paints.inlay, {-x, 0.0F, z}, {2.0F * x, 0.0F, 0.0F},
             {0.0F, 0.0F, -2.0F * z});
    site.solid.append(make_fountain(site.paints, site.detail));
}

void hang_cloth(Site& site) {
    // By bay, clockwise; '.' is an open arch.
    constexpr std::array<const char*, 4> kHangings{"r.Lg.bL.r", ".L.r", "b.g.rL.gL", "gL.b"};
    for (std::size_t s = 0; s < kSidesOfCourt.size(); ++s) {
        const Side& side = kSidesOfCourt[s];
        for (int i = 0; i < side.bays; ++i) {
            const char what = kHangings[s][i];
            if (what == '.') continue;
            const auto seed = static_cast<std::uint32_t>(100 * s) + static_cast<std::uint32_t>(i);
            const Hanging hanging = what == 'r'   ? Hanging::red
                                    : what == 'g' ? Hanging::green
                                    : what == 'b' ? Hanging::blue
                                                  : Hanging::lace;
            Mesh& mesh = hanging == Hanging::lace ? site.masked : site.solid;
            mesh.append(make_curtain(site.paints, hanging, site.detail, seed),
                        side.at(side.bay_m(i)));
            Mesh rod;
            add_box(rod, site.paints.iron, {-1.2F, kSpring_m - 0.22F, -0.02F},
                    {1.2F, kSpring_m - 0.18F, 0.02F}, kSides | kTop | kBottom);
            site.solid.append(rod, side.at(side.bay_m(i)));
        }
        for (int i = 1; i < side.bays; i += 3) {
            site.masked.append(make_banner(site.paints, site.detail, static_cast<std::uint32_t>(i)),
                               side.at(side.bay_m(i)));
        }
    }
}

void add_tree(Site& site, const vec3& position_m, std::uint32_t seed) {
    constexpr std::array<vec2, 4> kTrunk{vec2{0.07F, 0.0F}, vec2{0.05F, 0.6F}, vec2{0.045F, 1.3F},
                                         vec2{0.02F, 2.0F}};
    const float turns = 0.13F * static_cast<float>(seed);
    site.solid.append(make_pot(site.paints, site.detail), {position_m, turns, 1.5F});
    add_lathe(site.solid, site.paints.wood, kTrunk, 8, position_m + vec3{0.0F, 0.75F, 0.0F});
    site.masked.append(make_crown(site.paints.foliage, 0.95F, 110, seed),
                       {position_m + vec3{0.0F, 2.6F, 0.0F}, turns});
}

void plant(Site& site) {
    const Mesh pot = make_pot(site.paints, site.detail);
    std::uint32_t seed = 1;
    for (const Side& side : kSidesOfCourt) {
        for (int i = 1; i < side.bays; ++i) {
            const float x = side.bay_m(i) - 0.5F * kBay_m;
            if (i % 2 == 1) {
                site.solid.append(pot, side.at(x, 0.0F, 0.75F));
                site.masked.append(make_fern(site.paints, ++seed), side.at(x, 0.0F, 0.75F));
            }
        }
        for (int i = 2; i < side.bays; i += 3) {
            site.masked.append(make_ivy(site.paints, ++seed), side.at(side.bay_m(i), kRail_m));
        }
    }
    for (const float x : {-8.4F, 8.4F}) {
        for (const float z : {-2.6F, 2.6F}) add_tree(site, {x, 0.0F, z}, ++seed);
    }
}

}  // namespace

Scene make_atrium(double detail) {
    SceneBuilder builder("atrium");
    const Paints paints = add_paints(builder);
    Site site{paints, detail, {}, {}};
    build_house(site);
    lay_court(site);
    hang_cloth(site);
    plant(site);
    builder.add_part(std::move(site.solid));
    builder.add_part(std::move(site.masked), true);

    Scene& scene = builder.scene();
    scene.point_lights.push_back({{-2.4F, 6.6F, 0.9F}, vec3{150.0F, 137.0F, 114.0F}});
    scene.area_lights.push_back(
        {{-5.0F, 12.4F, -2.0F}, {10.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 4.0F}, {6.6F, 6.8F, 7.2F}});
    scene.ambient = vec3{0.24F, 0.26F, 0.30F};
    scene.background = vec3{0.42F, 0.62F, 0.92F};
    scene.camera_path = {
        {{-11.0F, 1.7F, 0.3F}, {0.0F, 2.6F, -0.6F}}, {{-5.5F, 1.8F, -2.6F}, {4.0F, 2.4F, -4.5F}},
        {{0.5F, 1.9F, -3.4F}, {9.0F, 2.8F, 1.0F}},   {{5.6F, 2.6F, -0.4F}, {9.0F, 5.0F, 5.5F}},
        {{8.0F, 4.4F, 0.6F}, {0.0F, 4.2F, 5.0F}},    {{4.0F, 6.6F, 2.0F}, {-6.0F, 6.2F, -4.0F}},
        {{-2.0F, 7.2F, 2.2F}, {-9.0F, 3.0F, -2.5F}}, {{-8.0F, 4.2F, 0.2F}, {2.0F, 3.2F, 0.0F}}};
    scene.camera_path_s = 24.0F;
    return builder.finish();
}

}  // namespace foverig::builtin
