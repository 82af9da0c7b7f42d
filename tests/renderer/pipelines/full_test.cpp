#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/scene/library.h"
#include "tests/renderer/polygon_light.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

constexpr vec3 kPaint{0.6F, 0.3F, 0.9F};

Image render(const std::shared_ptr<const Scene>& scene, const RenderSettings& settings,
             const EyeView& view, FrameStats* stats = nullptr) {
    const auto renderer = make_renderer(scene, settings);
    const FrameStats s = renderer->render(frame_of(view, 3));
    if (stats != nullptr) *stats = s;
    return renderer->image(0);
}

SmallScene floor_scene(const Material& material) {
    SmallScene s;
    s.add_quad(s.add_material(material), {-20, 0, 20}, {40, 0, 0}, {0, 0, -40});
    return s;
}

Material matte(const vec3& diffuse) {
    Material m;
    m.diffuse = diffuse;
    return m;
}

TEST(Full, APointLightOnAPlaneIsLambertsLaw) {
    SmallScene s = floor_scene(matte(kPaint));
    const PointLight light{{0.3F, 2.0F, -0.2F}, {5.0F, 7.0F, 9.0F}};
    s.scene().point_lights.push_back(light);
    const EyeView view = view_at({0, 3, 4}, {0, 0, 0}, 96, 80);
    const Image image = render(s.finish(), settings_of("full"), view);
    for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 96; ++x) {
            const dvec3 p = floor_point(view, x, y);
            if (std::abs(p.x) > 19.0 || std::abs(p.z) > 19.0 || p.y < -1.0 ||
                floor_point(view, x, y).z > 4.0)
                continue;
            const dvec3 l = dvec3(light.position_m) - p;
            for (int c = 0; c < 3; ++c) {
                const double expected = static_cast<double>(kPaint[c]) / std::numbers::pi *
                                        static_cast<double>(light.intensity[c]) * l.y /
                                        std::pow(glm::length(l), 3.0);
                ASSERT_NEAR(image.at(x, y)[c], expected, 1.0e-3 * expected) << x << ' ' << y;
            }
        }
    }
}

TEST(Full, TheHighlightIsPhongs) {
    Material shiny = matte(vec3(0.0F));
    shiny.specular = {0.5F, 0.25F, 1.0F};
    shiny.shininess = 20.0F;
    SmallScene s = floor_scene(shiny);
    const PointLight light{{0.0F, 2.0F, -2.0F}, vec3(3.0F)};
    s.scene().point_lights.push_back(light);
    const EyeView view = view_at({0, 2, 2}, {0, 0, 0}, 64, 64, 0.7F);
    const Image image = render(s.finish(), settings_of("full"), view);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const dvec3 p = floor_point(view, x, y);
            const dvec3 l = dvec3(light.position_m) - p;
            const dvec3 d = glm::normalize(l);
            const dvec3 mirrored(-d.x, d.y, -d.z);
            const double lobe =
                std::max(0.0, glm::dot(mirrored, glm::normalize(dvec3(view.position_m) - p)));
            const double expected = 3.0 / glm::dot(l, l) * std::pow(lobe, 20.0);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(image.at(x, y)[c], static_cast<double>(shiny.specular[c]) * expected,
                            2.0e-3 * expected + 1.0e-6);
        }
    }
}

TEST(Full, AShadowIsWhereTheLightIsHidden) {
    SmallScene s = floor_scene(matte(vec3(1.0F)));
    s.add_quad(s.add_matte(vec3(0.5F)), {-0.5F, 1, 0.5F}, {1, 0, 0}, {0, 0, -1});
    s.scene().point_lights.push_back(
        {{0, 2, 0}, vec3(4.0F)});  // the shadow is twice the card: |x|, |z| < 1
    const EyeView view = view_at({0, 0.6F, 2.2F}, {0, 0, 0}, 80, 60);
    const Image image = render(s.finish(), settings_of("full"), view);
    int dark = 0;
    for (int y = 0; y < 60; ++y) {
        for (int x = 0; x < 80; ++x) {
            const dvec3 p = floor_point(view, x, y);
            if (p.z < -1.5 || p.z > 2.0 ||
                std::abs(std::max(std::abs(p.x), std::abs(p.z)) - 1.0) < 1.0e-3)
                continue;
            const bool shadow = std::abs(p.x) < 1.0 && std::abs(p.z) < 1.0;
            ASSERT_EQ(image.at(x, y).x == 0.0F, shadow) << p.x << ' ' << p.z;
            dark += shadow ? 1 : 0;
        }
    }
    EXPECT_GT(dark, 100);
}

TEST(Full, AnAreaLightIsTheFormFactorOfItsPolygon) {
    SmallScene s = floor_scene(matte(kPaint));
    const AreaLight light{
        {-0.4F, 1.5F, -0.6F}, {1.2F, 0.2F, 0.1F}, {-0.1F, 0.3F, 0.9F}, {3.0F, 2.0F, 1.0F}};
    s.scene().area_lights.push_back(light);
    const EyeView view = view_at({0, 4, 3}, {0, 0, 0}, 64, 64, 0.5F);
    RenderSettings settings = settings_of("full");
    settings.lighting.area_samples = 16;
    const Image image = render(s.finish(), settings, view);
    double bias = 0.0;
    int blocks = 0;
    for (int y = 0; y < 64; y += 4) {
        for (int x = 0; x < 64; x += 4) {
            double mean = 0.0;  // of the 16 patterns: 256 stratified samples
            double expected = 0.0;
            for (int i = 0; i < 16; ++i) {
                mean += static_cast<double>(image.at(x + i % 4, y + i / 4).x) / 16;
                expected +=
                    static_cast<double>(kPaint.x) / std::numbers::pi * 3.0 *
                    polygon_irradiance(light, floor_point(view, x + i % 4, y + i / 4), {0, 1, 0}) /
                    16;
            }
            ASSERT_NEAR(mean, expected, 0.04 * expected) << x << ' ' << y;
            bias += mean / expected - 1.0;
            ++blocks;
        }
    }
    EXPECT_NEAR(bias / blocks, 0.0, 2.0e-3);
}

/// Mean over 4x4 blocks of the open share of the hemisphere, beside what `expected` says there.
template <class Expected>
void expect_openness(SmallScene& s, double radius_m, const EyeView& view,
                     const Expected& expected) {
    s.scene().ambient = vec3(0.5F);
    RenderSettings settings = settings_of("full");
    settings.lighting.ao_samples = 16;
    settings.lighting.ao_radius_m = radius_m;
    const Image image = render(s.finish(), settings, view);
    double bias = 0.0;
    int blocks = 0;
    for (int y = 0; y < view.height_px; y += 4) {
        for (int x = 0; x < view.width_px; x += 4) {
            double mean = 0.0;
            double wanted = 0.0;
            bool known = true;
            for (int i = 0; i < 16; ++i) {
                const dvec3 p = floor_point(view, x + i % 4, y + i / 4);
                known = known && p.x > 1.0e-3 && std::abs(p.z) < 10.0;
                mean += static_cast<double>(image.at(x + i % 4, y + i / 4).x) / (0.5 * 0.8 * 16);
                wanted += expected(p) / 16;
            }
            if (!known) continue;
            ASSERT_NEAR(mean, wanted, 0.05) << x << ' ' << y;
            bias += mean - wanted;
            ++blocks;
        }
    }
    ASSERT_GT(blocks, 50);
    EXPECT_NEAR(bias / blocks, 0.0, 4.0e-3);
}

EyeView from_above() {
    return view_at({2.0F, 3.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, 64, 64, 0.6F);
}

TEST(Occlusion, APlaneInTheOpenSeesEverything) {
    SmallScene s = floor_scene(matte(vec3(0.8F)));
    expect_openness(s, 0.0, from_above(), [](const dvec3&) { return 1.0; });
}

TEST(Occlusion, BesideAnEndlessWallHalfIsOpen) {
    SmallScene s = floor_scene(matte(vec3(0.8F)));
    s.add_quad(0, {0, 0, 4000}, {0, 0, -8000}, {0, 4000, 0});
    expect_openness(s, 0.0, from_above(), [](const dvec3&) { return 0.5; });
}

TEST(Occlusion, BesideALongWallItIsTheWallsFormFactor) {
    // Horizontal element beside an endless strip of height h at distance d: F = (1 - d / sqrt(d^2 +
    // h^2)) / 2.
    SmallScene s = floor_scene(matte(vec3(0.8F)));
    s.add_quad(0, {0, 0, 4000}, {0, 0, -8000}, {0, 1.5F, 0});
    expect_openness(s, 0.0, from_above(),
                    [](const dvec3& p) { return 0.5 + 0.5 * p.x / std::hypot(p.x, 1.5); });
}

TEST(Occlusion, BeyondTheRadiusAWallDoesNotCount) {
    SmallScene s = floor_scene(matte(vec3(0.8F)));
    s.add_quad(0, {0, 0, 4000}, {0, 0, -8000}, {0, 4000, 0});
    s.scene().ambient = vec3(0.5F);
    RenderSettings settings = settings_of("full");
    settings.lighting.ao_samples = 8;
    settings.lighting.ao_radius_m = 0.75;
    const EyeView view = from_above();
    const Image image = render(s.finish(), settings, view);
    int closed = 0;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double d = floor_point(view, x, y).x;
            if (d > 0.7501) {
                ASSERT_NEAR(image.at(x, y).x, 0.4F, 1.0e-3F);
            } else {
                closed += image.at(x, y).x < 0.39F ? 1 : 0;
            }
        }
    }
    EXPECT_GT(closed, 20);
}

TEST(Full, ShowsBackgroundEmissionAndAmbient) {
    Material lamp = matte(vec3(0.5F, 0.0F, 0.0F));
    lamp.emission = {0.0F, 2.0F, 0.0F};
    SmallScene s;
    s.add_quad(s.add_material(lamp), {-1, -1, -2}, {1, 0, 0}, {0, 2, 0});
    s.scene().ambient = vec3(0.25F);
    s.scene().background = {0.125F, 0.5F, 1.0F};
    const Image image =
        render(s.finish(), settings_of("full"), view_at({0, 0, 0}, {0, 0, -1}, 64, 64, 0.4F));
    EXPECT_EQ(image.at(5, 30), vec3(0.125F, 2.0F, 0.0F));
    EXPECT_EQ(image.at(60, 30), vec3(0.125F, 0.5F, 1.0F));
}

TEST(Full, DegenerateGeometryAndLightsMakeNoNan) {
    SmallScene s = floor_scene(matte(kPaint));
    s.add_quad(0, {0, 0.5F, 0}, {1, 0, 0}, {0, 1.0e-30F, 0});  // without area
    s.scene().normals[5] = s.scene().normals[4] = {0, 1, 0};
    s.scene().normals[6] = s.scene().normals[7] = {0, 1, 0};
    s.scene().point_lights.push_back({{0.0F, 0.0F, 0.0F}, vec3(1.0F)});  // in the surface
    s.scene().point_lights.push_back({{0.0F, 3.0F, 4.0F}, vec3(1.0F)});  // in the eye
    s.scene().area_lights.push_back({{0, 2, 0}, {1, 0, 0}, {2, 0, 0}, vec3(1.0F)});  // no area
    s.scene().area_lights.push_back(
        {{-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, vec3(1.0F)});  // in the surface
    s.scene().ambient = vec3(0.1F);
    RenderSettings settings = settings_of("full");
    settings.lighting.ao_samples = 4;
    FrameStats stats;
    const Image image = render(s.finish(), settings, view_at({0, 3, 4}, {0, 0, 0}, 64, 64), &stats);
    EXPECT_EQ(stats.numerics.nan, 0U);
    EXPECT_EQ(stats.numerics.inf, 0U);
    for (const vec3& p : image.pixels) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
}

TEST(Full, BuiltInScenesHaveNoNan) {
    RenderSettings settings = settings_of("full");
    settings.lighting.ao_samples = 2;
    for (const char* name : {"cornell", "atrium", "tunnel-maps"}) {
        const auto scene = std::make_shared<const Scene>(make_builtin_scene(name, 0.25));
        FrameStats stats;
        const Image image = render(
            scene, settings,
            view_at(scene->camera_path[0].position_m, scene->camera_path[0].target_m, 160, 120),
            &stats);
        EXPECT_EQ(stats.numerics.nan + stats.numerics.inf, 0U) << name;
        double sum = 0.0;
        for (const vec3& p : image.pixels) sum += static_cast<double>(p.x + p.y + p.z);
        EXPECT_TRUE(sum > 0.0 && std::isfinite(sum)) << name;
    }
}

}  // namespace
}  // namespace foverig
