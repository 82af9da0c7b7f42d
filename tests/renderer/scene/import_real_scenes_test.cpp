// The real scenes of ../shared/scenes against the numbers that their README counted from the files.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/renderer/scene/import_files.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(FOVERIG_SOURCE_DIR).parent_path() / "shared" / "scenes";

struct Expected {
    const char* file;
    double metres_per_unit;
    std::size_t triangles;  ///< README; those without area are left out
    vec3 extent_m;
    std::size_t textures;  ///< that materials use as colour
};

void PrintTo(const Expected& expected, std::ostream* out) {
    *out << expected.file;
}

class ImportRealScene : public testing::TestWithParam<Expected> {};

TEST_P(ImportRealScene, HasWhatTheReadmeCounted) {
    const Expected& expected = GetParam();
    if (!fs::exists(kScenes / expected.file))
        GTEST_SKIP() << expected.file << " is not beside the checkout";
    ImportSettings settings;
    settings.metres_per_unit = expected.metres_per_unit;
    const Scene scene = import_scene(kScenes / expected.file, settings);
    EXPECT_NO_THROW(check_scene(scene));
    EXPECT_LE(scene.triangles.size(), expected.triangles);
    EXPECT_GE(scene.triangles.size(), expected.triangles - expected.triangles / 2000 - 1);
    EXPECT_EQ(scene.textures.size(), expected.textures);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(scene.bounds.max_m[k] - scene.bounds.min_m[k], expected.extent_m[k],
                    0.01F * expected.extent_m[k] + 0.051F);
    EXPECT_GE(scene.point_lights.size() + scene.area_lights.size(), 1U);
    EXPECT_GE(scene.camera_path.size(), 4U);
    for (const CameraKey& key : scene.camera_path)
        EXPECT_GT(glm::length(key.target_m - key.position_m), 0.0F);
}

INSTANTIATE_TEST_SUITE_P(
    All, ImportRealScene,
    testing::Values(Expected{"sponza/sponza.glb", 1.0, 262'267, {29.8F, 12.4F, 18.3F}, 24},
                    Expected{"sibenik/sibenik.obj", 1.0, 75'284, {40.3F, 30.6F, 17.0F}, 0},
                    Expected{"sponza-dabrovic/sponza.obj", 1.0, 66'447, {34.8F, 16.6F, 15.6F}, 0},
                    Expected{"kitchen/kitchen.glb", 1.0, 1'443'517, {6.9F, 3.4F, 8.7F}, 9},
                    Expected{
                        "hotel-room/hotel-room.glb", 0.001, 99'029, {6.499F, 2.197F, 9.995F}, 6},
                    Expected{"statues/bunny.glb", 1.0, 144'046, {1.61F, 1.62F, 1.23F}, 0},
                    Expected{"statues/dragon.obj", 1.0, 100'000, {0.894F, 1.41F, 2.0F}, 0},
                    Expected{"statues/nefertiti.obj", 1.0, 99'938, {238.0F, 362.0F, 494.0F}, 0},
                    Expected{"san-miguel-partial/san_miguel_partial.glb.zst",
                             1.0,
                             9'407'550,
                             {84.74F, 53.98F, 73.89F},
                             0},
                    Expected{"spot/spot_triangulated.obj", 1.0, 5'856, {0.9F, 1.7F, 1.7F}, 0}));

Scene scene_or_skip(const char* file) {
    return fs::exists(kScenes / file) ? import_scene(kScenes / file) : Scene{};
}

TEST(ImportRealScenes, SponzaHasThreeMaskedMaterialsInAPartOfTheirOwn) {
    const Scene scene = scene_or_skip("sponza/sponza.glb");
    if (scene.triangles.empty()) GTEST_SKIP() << "Sponza is not beside the checkout";
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_FALSE(scene.parts[0].alpha_masked);
    EXPECT_TRUE(scene.parts[1].alpha_masked);
    EXPECT_EQ(std::count_if(scene.materials.begin(), scene.materials.end(),
                            [](const Material& m) { return m.alpha_cutoff > 0.0F; }),
              3);
    for (const CameraKey& key : scene.camera_path) {
        EXPECT_TRUE(glm::all(glm::greaterThan(key.position_m, scene.bounds.min_m)));
        EXPECT_TRUE(glm::all(glm::lessThan(key.position_m, scene.bounds.max_m)));
    }
}

TEST(ImportRealScenes, KitchenIsLitByItsFourAreaLights) {
    const Scene scene = scene_or_skip("kitchen/kitchen.glb");
    if (scene.triangles.empty()) GTEST_SKIP() << "the kitchen is not beside the checkout";
    ASSERT_EQ(scene.area_lights.size(), 4U);
    EXPECT_TRUE(scene.point_lights.empty());
    // The window: 1.6235 x 2.2013 m, emissive strength 16.032 (read from the file's JSON).
    EXPECT_NEAR(
        glm::length(scene.area_lights[0].edge_u_m) * glm::length(scene.area_lights[0].edge_v_m),
        1.62353F * 2.20128F, 1.0e-3F);
    EXPECT_NEAR(scene.area_lights[0].radiance.x, 16.032F, 1.0e-3F);
}

TEST(ImportRealScenes, CornellLightIsTheOneInTheCeiling) {
    const Scene scene = scene_or_skip("cornell/CornellBox-Original.obj");
    if (scene.triangles.empty()) GTEST_SKIP() << "the Cornell boxes are not beside the checkout";
    ASSERT_EQ(scene.area_lights.size(), 1U);
    EXPECT_EQ(scene.area_lights[0].radiance, vec3(17.0F, 12.0F, 4.0F));
    EXPECT_NEAR(scene.area_lights[0].corner_m.y, 1.98F, 0.01F);
}

}  // namespace
}  // namespace foverig
