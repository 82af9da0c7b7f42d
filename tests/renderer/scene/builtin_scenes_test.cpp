// Every built-in scene: arrays that agree, documented sizes, the same bytes every time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "renderer/scene/error.h"
#include "renderer/scene/library.h"

namespace foverig {
namespace {

/// FNV-1a, 64 bits (draft-eastlake-fnv), over the bytes of an array.
template <class T>
std::uint64_t hashed(const std::vector<T>& values, std::uint64_t hash) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(T); ++i)
        hash = (hash ^ bytes[i]) * 0x100000001b3ULL;
    return hash;
}

std::uint64_t hash_of(const Scene& scene) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    hash = hashed(scene.positions_m, hash);
    hash = hashed(scene.normals, hash);
    hash = hashed(scene.texcoords, hash);
    hash = hashed(scene.triangles, hash);
    hash = hashed(scene.triangle_materials, hash);
    hash = hashed(scene.texels, hash);
    return hashed(scene.camera_path, hash);
}

/// Every scene is made once for all tests.
const Scene& scene_named(const std::string& name) {
    static std::map<std::string, Scene> scenes;
    const auto found = scenes.find(name);
    return found != scenes.end() ? found->second
                                 : scenes.emplace(name, make_builtin_scene(name)).first->second;
}

struct Documented {
    const char* name;
    std::size_t triangles;
    std::uint64_t hash;
};
// Hashes agree between g++ 12 -O0 and -O3 for x86-64-v3, and clang 14 -O3 for the machine at hand.
constexpr Documented kDocumented[] = {
    {"cornell", 13'000, 0x33e3823d8a2f9761ULL},      {"atrium", 150'000, 0x5184e4baa5d0d54dULL},
    {"tunnel-geom", 200'000, 0xc68bf0cfc60d9ee0ULL}, {"tunnel-maps", 12'000, 0xd297666336d4e52bULL},
    {"voxel-town", 400'000, 0xdf8079aec97ab094ULL},  {"city", 770'000, 0xb088ae364c406eefULL},
};

class BuiltinScene : public testing::TestWithParam<Documented> {
  protected:
    const Scene& scene_ = scene_named(GetParam().name);
};

TEST_P(BuiltinScene, IsNamedAndHasAboutTheDocumentedSize) {
    EXPECT_EQ(scene_.name, GetParam().name);
    const auto documented = static_cast<double>(GetParam().triangles);
    EXPECT_NEAR(static_cast<double>(scene_.triangles.size()), documented, 0.05 * documented);
}

TEST_P(BuiltinScene, IsTheSameBytesEveryTimeAndOnEveryMachine) {
    EXPECT_EQ(hash_of(make_builtin_scene(GetParam().name)), hash_of(scene_));
    EXPECT_EQ(hash_of(scene_), GetParam().hash) << std::hex << "0x" << hash_of(scene_);
}

TEST_P(BuiltinScene, PartsTileTheArraysAndShareNoVertex) {
    std::size_t triangle = 0;
    std::size_t vertex = 0;
    for (const Part& part : scene_.parts) {
        ASSERT_EQ(part.first_triangle, triangle);
        ASSERT_EQ(part.first_vertex, vertex);
        triangle += part.triangle_count;
        vertex += part.vertex_count;
        ASSERT_LE(triangle, scene_.triangles.size());
        for (std::size_t t = part.first_triangle; t < triangle; ++t) {
            for (int k = 0; k < 3; ++k) {
                ASSERT_GE(scene_.triangles[t][k], part.first_vertex);
                ASSERT_LT(scene_.triangles[t][k], vertex);
            }
        }
    }
    EXPECT_EQ(triangle, scene_.triangles.size());
    EXPECT_EQ(vertex, scene_.positions_m.size());
}

TEST_P(BuiltinScene, MaterialsAndTexturesAreThere) {
    ASSERT_EQ(scene_.triangle_materials.size(), scene_.triangles.size());
    for (const std::uint16_t m : scene_.triangle_materials) ASSERT_LT(m, scene_.materials.size());
    for (const Material& m : scene_.materials) {
        EXPECT_LT(m.diffuse_texture, static_cast<int>(scene_.textures.size()));
        EXPECT_LT(m.emission_texture, static_cast<int>(scene_.textures.size()));
        EXPECT_GE(m.shininess, 1.0F);
    }
}

TEST_P(BuiltinScene, NormalsAreUnitAndTexcoordsFinite) {
    ASSERT_EQ(scene_.normals.size(), scene_.positions_m.size());
    for (const vec3& n : scene_.normals) ASSERT_NEAR(glm::length(n), 1.0F, 1.0e-5F);
    if (scene_.textures.empty())
        EXPECT_TRUE(scene_.texcoords.empty());
    else
        EXPECT_EQ(scene_.texcoords.size(), scene_.positions_m.size());
    for (const vec2& t : scene_.texcoords) ASSERT_TRUE(std::isfinite(t.x) && std::isfinite(t.y));
}

TEST_P(BuiltinScene, TrianglesHaveAreaAndFaceWhereTheirNormalsPoint) {
    std::size_t turned = 0;
    for (const uvec3& t : scene_.triangles) {
        const dvec3 a(scene_.positions_m[t.x]);
        const dvec3 area =
            glm::cross(dvec3(scene_.positions_m[t.y]) - a, dvec3(scene_.positions_m[t.z]) - a);
        ASSERT_GT(glm::length(area), 0.0);
        const dvec3 mean =
            dvec3(scene_.normals[t.x]) + dvec3(scene_.normals[t.y]) + dvec3(scene_.normals[t.z]);
        turned += glm::dot(area, mean) <= 0.0 ? 1U : 0U;
    }
    // A noisy surface may fold within one triangle of its smooth normals.
    EXPECT_LE(turned, scene_.triangles.size() / 500U);
}

TEST_P(BuiltinScene, BoundsAreThoseOfThePositions) {
    dvec3 low(1.0e30);
    dvec3 high(-1.0e30);
    for (const vec3& p : scene_.positions_m) {
        low = glm::min(low, dvec3(p));
        high = glm::max(high, dvec3(p));
    }
    EXPECT_EQ(dvec3(scene_.bounds.min_m), low);
    EXPECT_EQ(dvec3(scene_.bounds.max_m), high);
}

TEST_P(BuiltinScene, MipChainsTileTheTexels) {
    std::size_t end = 0;
    for (const Texture& t : scene_.textures) {
        ASSERT_EQ(t.first_texel, end);
        ASSERT_EQ(t.width & (t.width - 1), 0U);
        ASSERT_EQ(t.height & (t.height - 1), 0U);
        EXPECT_EQ(1U << (t.level_count - 1), std::max(t.width, t.height));
        for (std::uint32_t l = 0; l < t.level_count; ++l)
            end += std::size_t{std::max(1U, t.width >> l)} * std::max(1U, t.height >> l);
    }
    EXPECT_EQ(end, scene_.texels.size());
}

double linear_of(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

TEST_P(BuiltinScene, MipmapsKeepTheMeanLight) {
    for (const Texture& t : scene_.textures) {
        if (t.has_alpha) continue;
        const std::size_t count = std::size_t{t.width} * t.height;
        double level0 = 0.0;
        for (std::size_t i = 0; i < count; ++i)
            level0 += linear_of((scene_.texels[t.first_texel + i] >> 8U & 255U) / 255.0);
        level0 /= static_cast<double>(count);
        const double level1 = [&] {
            double sum = 0.0;
            for (std::size_t i = 0; i < count / 4; ++i)
                sum += linear_of((scene_.texels[t.first_texel + count + i] >> 8U & 255U) / 255.0);
            return sum / static_cast<double>(count / 4);
        }();
        // Half a code of 255 at the steepest point of the sRGB curve.
        EXPECT_NEAR(level1, level0, 0.5 / 255.0 * 2.4);
    }
}

TEST_P(BuiltinScene, OnlyMaskedPartsHoldCutOuts) {
    for (const Part& part : scene_.parts) {
        for (std::size_t t = part.first_triangle; t < part.first_triangle + part.triangle_count;
             ++t) {
            const Material& m = scene_.materials[scene_.triangle_materials[t]];
            ASSERT_EQ(m.alpha_cutoff > 0.0F, part.alpha_masked);
            if (!part.alpha_masked) continue;
            ASSERT_GE(m.diffuse_texture, 0);
            ASSERT_TRUE(scene_.textures[static_cast<std::size_t>(m.diffuse_texture)].has_alpha);
        }
    }
}

TEST_P(BuiltinScene, HasBothKindsOfLightAndAFlight) {
    EXPECT_GE(scene_.point_lights.size(), 1U);
    EXPECT_GE(scene_.area_lights.size(), 1U);
    EXPECT_GE(scene_.camera_path.size(), 4U);
    EXPECT_NEAR(scene_.camera_path_s, 20.0F, 5.0F);
    for (const CameraKey& key : scene_.camera_path)
        EXPECT_GT(glm::distance(key.position_m, key.target_m), 0.5F);
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinScene, testing::ValuesIn(kDocumented), [](const auto& scene) {
    std::string name = scene.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(BuiltinScenes, ListNamesEveryScene) {
    std::set<std::string> names;
    for (const BuiltinInfo& info : builtin_scenes()) {
        names.insert(info.name);
        EXPECT_FALSE(info.summary.empty());
    }
    EXPECT_THAT(names, testing::ElementsAre("atrium", "city", "cornell", "tunnel-geom",
                                            "tunnel-maps", "voxel-town"));
}

TEST(BuiltinScenes, UnknownNameIsRefusedWithTheKnownOnes) {
    try {
        make_builtin_scene("atrum");
        FAIL() << "accepted";
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(),
                    testing::AllOf(testing::HasSubstr("'atrum'"), testing::HasSubstr("atrium")));
    }
}

TEST(BuiltinScenes, DetailOutOfRangeIsRefused) {
    EXPECT_THROW(make_builtin_scene("cornell", 0.0), SceneError);
    EXPECT_THROW(make_builtin_scene("cornell", -1.0), SceneError);
    EXPECT_THROW(make_builtin_scene("cornell", 1.0e6), SceneError);
    EXPECT_THROW(make_builtin_scene("cornell", std::nan("")), SceneError);
}

TEST(BuiltinScenes, DetailScalesTheCountOfTriangles) {
    for (const char* name : {"tunnel-geom", "tunnel-maps", "cornell"}) {
        const auto base = static_cast<double>(scene_named(name).triangles.size());
        EXPECT_NEAR(static_cast<double>(make_builtin_scene(name, 4.0).triangles.size()), 4.0 * base,
                    0.15 * 4.0 * base)
            << name;
        EXPECT_LT(static_cast<double>(make_builtin_scene(name, 0.1).triangles.size()), 0.2 * base)
            << name;
    }
}

TEST(BuiltinScenes, VoxelTownReachesRungholtsSizeAtDetail16) {
    // Weier 2016 table 1: Rungholt has 6.7 M triangles.
    const Scene town = make_builtin_scene("voxel-town", 16.0);
    EXPECT_NEAR(static_cast<double>(town.triangles.size()), 6.7e6, 0.1e6);
}

TEST(BuiltinScenes, CornellHasOneMovingPart) {
    const Scene& scene = scene_named("cornell");
    const auto moving = std::count_if(scene.parts.begin(), scene.parts.end(),
                                      [](const Part& p) { return p.motion != kNone; });
    EXPECT_EQ(moving, 1);
    ASSERT_EQ(scene.motions.size(), 1U);
    EXPECT_NE(scene.motions[0].rate_rad_s, 0.0F);
    EXPECT_NEAR(glm::length(scene.motions[0].axis), 1.0F, 1.0e-6F);
}

}  // namespace
}  // namespace foverig
