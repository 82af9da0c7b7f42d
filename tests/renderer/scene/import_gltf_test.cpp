#include <nlohmann/json.hpp>

#include <cmath>

#include "tests/renderer/scene/import_files.h"

namespace foverig {
namespace {

using nlohmann::json;
using test::SceneFiles;

/// A unit square in z = 0, counter-clockwise, as two indexed triangles, in an external buffer.
json square(const SceneFiles& files) {
    const std::vector<float> positions{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<float> texcoords{0, 1, 1, 1, 1, 0, 0, 0};
    const std::vector<std::uint16_t> indices{0, 1, 2, 0, 2, 3};
    const std::string bytes =
        test::bytes_of(positions) + test::bytes_of(texcoords) + test::bytes_of(indices);
    files.write("square.bin", bytes);
    return json{{"asset", {{"version", "2.0"}}},
                {"scene", 0},
                {"scenes", {{{"nodes", {0}}}}},
                {"nodes", {{{"mesh", 0}}}},
                {"meshes",
                 {{{"primitives",
                    {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}, {"indices", 2}}}}}}},
                {"buffers", {{{"byteLength", bytes.size()}, {"uri", "square.bin"}}}},
                {"bufferViews",
                 {{{"buffer", 0}, {"byteLength", 48}},
                  {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 32}},
                  {{"buffer", 0}, {"byteOffset", 80}, {"byteLength", 12}}}},
                {"accessors",
                 {{{"bufferView", 0}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                  {{"bufferView", 1}, {"componentType", 5126}, {"count", 4}, {"type", "VEC2"}},
                  {{"bufferView", 2}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}}}};
}

Scene imported(const SceneFiles& files, const json& gltf) {
    return import_scene(files.write("a.gltf", gltf.dump()));
}

std::string error_of(const SceneFiles& files, const json& gltf) {
    const auto file = files.write("a.gltf", gltf.dump());
    const std::string error = test::import_error(file);
    EXPECT_TRUE(error.starts_with(file.string() + ": ")) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    return error;
}

TEST(ImportGltf, SquareLoads) {
    const SceneFiles files;
    const Scene scene = imported(files, square(files));
    EXPECT_EQ(scene.triangles.size(), 2U);
    EXPECT_EQ(scene.positions_m.size(), 4U);
    EXPECT_NEAR(test::area_m2(scene), 1.0, 1.0e-12);
    EXPECT_GT(test::face_normal(scene, 0).z, 0.99);
}

TEST(ImportGltf, NodesMultiplyDownTheTree) {
    const SceneFiles files;
    json gltf = square(files);
    // 90 degrees about z inside a shift inside a scale: (1, 0) goes to (0, 1), then (5, 1), then
    // (10, 2).
    gltf["nodes"] = {{{"scale", {2, 2, 2}}, {"children", {1}}},
                     {{"translation", {5, 0, 0}}, {"children", {2}}},
                     {{"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}, {"mesh", 0}}};
    const Scene scene = imported(files, gltf);
    EXPECT_NEAR(scene.bounds.min_m.x, 8.0F, 1.0e-5F);
    EXPECT_NEAR(scene.bounds.max_m.x, 10.0F, 1.0e-5F);
    EXPECT_NEAR(scene.bounds.max_m.y, 2.0F, 1.0e-5F);
    EXPECT_NEAR(test::area_m2(scene), 4.0, 1.0e-5);
}

TEST(ImportGltf, MirrorTurnsTheWindingRound) {
    const SceneFiles files;
    json gltf = square(files);
    gltf["nodes"][0]["scale"] = {-1, 1, 1};
    const Scene scene = imported(files, gltf);
    for (std::size_t t = 0; t < 2; ++t) EXPECT_GT(test::face_normal(scene, t).z, 0.99);
    for (const vec3& normal : scene.normals) EXPECT_GT(normal.z, 0.99F);
}

TEST(ImportGltf, InstancesAreUnfoldedUpToTheLimit) {
    const SceneFiles files;
    json gltf = square(files);
    gltf["nodes"] = json::array();
    gltf["scenes"][0]["nodes"] = json::array();
    for (int i = 0; i < 50; ++i) {
        gltf["nodes"].push_back({{"mesh", 0}, {"translation", {2 * i, 0, 0}}});
        gltf["scenes"][0]["nodes"].push_back(i);
    }
    EXPECT_EQ(imported(files, gltf).triangles.size(), 100U);
    ImportSettings settings;
    settings.max_triangles = 99;
    EXPECT_NE(
        test::import_error(files.folder() / "a.gltf", settings).find("more than 99 triangles"),
        std::string::npos);
}

TEST(ImportGltf, StripsAndFansCoverTheSameSquare) {
    const SceneFiles files;
    for (const auto& [mode, order] : {std::pair{5, std::vector<std::uint16_t>{0, 1, 3, 2}},
                                      std::pair{6, std::vector<std::uint16_t>{0, 1, 2, 3}}}) {
        json gltf = square(files);
        std::string bytes(92, '\0');
        std::ifstream(files.folder() / "square.bin", std::ios::binary).read(bytes.data(), 92);
        files.write("other.bin", bytes.substr(0, 80) + test::bytes_of(order) + "    ");
        gltf["buffers"][0]["uri"] = "other.bin";
        gltf["accessors"][2]["count"] = 4;
        gltf["meshes"][0]["primitives"][0]["mode"] = mode;
        const Scene scene = imported(files, gltf);
        ASSERT_EQ(scene.triangles.size(), 2U) << "mode " << mode;
        EXPECT_NEAR(test::area_m2(scene), 1.0, 1.0e-12);
        for (std::size_t t = 0; t < 2; ++t)
            EXPECT_GT(test::face_normal(scene, t).z, 0.99) << "mode " << mode;
    }
}

TEST(ImportGltf, LinesAreSkippedAndNoted) {
    const SceneFiles files;
    json gltf = square(files);
    json lines = gltf["meshes"][0]["primitives"][0];
    lines["mode"] = 1;
    gltf["meshes"][0]["primitives"].push_back(lines);
    const Scene scene = imported(files, gltf);
    EXPECT_EQ(scene.triangles.size(), 2U);
    ASSERT_EQ(scene.notes.size(), 1U);
    EXPECT_EQ(scene.notes[0], "1 primitives of points or lines left out");
}

TEST(ImportGltf, SparseAccessorReplacesItsElements) {
    const SceneFiles files;
    json gltf = square(files);
    // Corner 2 moves from (1, 1, 0) to (3, 3, 0).
    files.write("sparse.bin", test::bytes_of(std::vector<std::uint32_t>{2}) +
                                  test::bytes_of(std::vector<float>{3, 3, 0}));
    gltf["buffers"].push_back({{"byteLength", 16}, {"uri", "sparse.bin"}});
    gltf["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 4}});
    gltf["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 4}, {"byteLength", 12}});
    gltf["accessors"][0]["sparse"] = {{"count", 1},
                                      {"indices", {{"bufferView", 3}, {"componentType", 5125}}},
                                      {"values", {{"bufferView", 4}}}};
    EXPECT_NEAR(test::area_m2(imported(files, gltf)), 3.0, 1.0e-6);
    gltf["accessors"][0]["sparse"]["count"] = 2;
    EXPECT_NE(error_of(files, gltf).find("accessors[0] wants 2 elements"), std::string::npos);
}

TEST(ImportGltf, NormalisedIntegersBecomeFractions) {
    const SceneFiles files;
    json gltf = square(files);
    files.write("q.bin", test::bytes_of(std::vector<std::int16_t>{0, 0, 0, 0, 32767, 0, 0, 0, 32767,
                                                                  32767, 0, 0, 0, 32767, 0, 0}));
    gltf["buffers"].push_back({{"byteLength", 32}, {"uri", "q.bin"}});
    gltf["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 32}, {"byteStride", 8}});
    gltf["accessors"][0] = {{"bufferView", 3},
                            {"componentType", 5122},
                            {"normalized", true},
                            {"count", 4},
                            {"type", "VEC3"}};
    gltf["extensionsRequired"] = {"KHR_mesh_quantization"};
    EXPECT_NEAR(test::area_m2(imported(files, gltf)), 1.0, 1.0e-6);
}

TEST(ImportGltf, SkinnedMeshStandsWhereItsJointsHoldIt) {
    const SceneFiles files;
    json gltf = square(files);
    std::string bytes =
        test::bytes_of(std::vector<std::uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    bytes += test::bytes_of(
        std::vector<float>{0.5F, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0});
    files.write("skin.bin", bytes);
    gltf["buffers"].push_back({{"byteLength", 80}, {"uri", "skin.bin"}});
    gltf["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 16}});
    gltf["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 16}, {"byteLength", 64}});
    gltf["accessors"].push_back(
        {{"bufferView", 3}, {"componentType", 5121}, {"count", 4}, {"type", "VEC4"}});
    gltf["accessors"].push_back(
        {{"bufferView", 4}, {"componentType", 5126}, {"count", 4}, {"type", "VEC4"}});
    gltf["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = 3;
    gltf["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = 4;
    gltf["skins"] = {{{"joints", {1, 2}}}};
    // The node's own transform does not count (glTF 2.0, 3.7.3.3): half of (10,0,0) and half of
    // (0,4,0).
    gltf["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                     {{"translation", {10, 0, 0}}},
                     {{"translation", {0, 4, 0}}}};
    gltf["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = imported(files, gltf);
    EXPECT_NEAR(scene.bounds.min_m.x + static_cast<float>(scene.origin_m.x), 5.0F, 1.0e-5F);
    EXPECT_NEAR(scene.bounds.min_m.y + static_cast<float>(scene.origin_m.y), 2.0F, 1.0e-5F);
}

/// 2 x 1: an opaque red texel and a clear green one.
constexpr const char* kHalfClearPng =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAD0lEQVR4nGP4z8DwHwgZAA/"
    "5Av4tR4H0AAAAAElFTkSuQmCC";

TEST(ImportGltf, OnlyMaterialsThatCanBeClearAreMasked) {
    const SceneFiles files;
    json gltf = square(files);
    gltf["images"] = {{{"uri", kHalfClearPng}}};
    gltf["textures"] = {{{"source", 0}}};
    const json textured{{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}};
    gltf["materials"] = {
        {{"pbrMetallicRoughness", textured}, {"alphaMode", "MASK"}, {"alphaCutoff", 0.25}},
        {{"pbrMetallicRoughness", textured}},
        {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}}};
    json primitive = gltf["meshes"][0]["primitives"][0];
    gltf["meshes"][0]["primitives"] = json::array();
    for (int m = 0; m < 3; ++m) {
        primitive["material"] = m;
        gltf["meshes"][0]["primitives"].push_back(primitive);
    }
    const Scene scene = imported(files, gltf);
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_FALSE(scene.parts[0].alpha_masked);
    EXPECT_EQ(scene.parts[0].triangle_count, 4U);
    EXPECT_TRUE(scene.parts[1].alpha_masked);
    EXPECT_EQ(scene.parts[1].triangle_count, 2U);
    const Material& masked =
        scene.materials[scene.triangle_materials[scene.parts[1].first_triangle]];
    EXPECT_FLOAT_EQ(masked.alpha_cutoff, 0.25F);
    EXPECT_EQ(
        scene.texels[scene.textures[static_cast<std::size_t>(masked.diffuse_texture)].first_texel],
        0xFF0000FFU);
    EXPECT_EQ(scene.texcoords[scene.triangles[0].x], vec2(0.0F, 1.0F));
}

TEST(ImportGltf, TextureTransformGoesIntoTheCoordinates) {
    const SceneFiles files;
    json gltf = square(files);
    gltf["images"] = {{{"uri", kHalfClearPng}}};
    gltf["textures"] = {{{"source", 0}}};
    gltf["extensionsUsed"] = {"KHR_texture_transform"};
    // The specification's order: scale, then rotation, then offset.
    gltf["materials"] = {{{"pbrMetallicRoughness",
                           {{"baseColorTexture",
                             {{"index", 0},
                              {"extensions",
                               {{"KHR_texture_transform",
                                 {{"offset", {0.5, 0.25}},
                                  {"scale", {2, 3}},
                                  {"rotation", 1.5707963267948966}}}}}}}}}}};
    gltf["meshes"][0]["primitives"][0]["material"] = 0;
    const Scene scene = imported(files, gltf);
    for (std::size_t i = 0; i < 4; ++i) {
        const vec3& p = scene.positions_m[i];
        const vec2 uv(p.x, 1.0F - p.y);
        // Rotation by +90 degrees in the specification's sense: (u, v) -> (v, -u).
        EXPECT_NEAR(scene.texcoords[i].x, 0.5F + 3.0F * uv.y, 1.0e-5F);
        EXPECT_NEAR(scene.texcoords[i].y, 0.25F - 2.0F * uv.x, 1.0e-5F);
    }
}

TEST(ImportGltf, LiesAboutMemoryAreErrors) {
    const SceneFiles files;
    const auto changed = [&](const char* pointer, const json& value) {
        json gltf = square(files);
        gltf[json::json_pointer(pointer)] = value;
        return error_of(files, gltf);
    };
    EXPECT_NE(changed("/accessors/0/count", 5).find("accessors[0] wants 5 elements"),
              std::string::npos);
    EXPECT_NE(changed("/accessors/0/count", 18446744073709551615U).find("accessors[0]"),
              std::string::npos);
    EXPECT_NE(changed("/accessors/0/byteOffset", 18446744073709551000U).find("accessors[0]"),
              std::string::npos);
    EXPECT_NE(changed("/accessors/2/componentType", 5122).find("not unsigned"), std::string::npos);
    EXPECT_NE(changed("/bufferViews/0/byteOffset", 18446744073709551600U).find("bufferViews[0]"),
              std::string::npos);
    EXPECT_NE(changed("/bufferViews/0/byteStride", 4).find("byteStride"), std::string::npos);
    EXPECT_NE(changed("/bufferViews/0/buffer", 7).find("bufferViews[0].buffer is 7"),
              std::string::npos);
    EXPECT_NE(changed("/meshes/0/primitives/0/indices", -1).find("indices is -1"),
              std::string::npos);
    EXPECT_NE(changed("/nodes/0/mesh", 1).find("nodes[0].mesh is 1"), std::string::npos);
    EXPECT_NE(changed("/nodes/0/children", json::array({0})).find("descendant"), std::string::npos);
    EXPECT_NE(changed("/buffers/0/uri", "../square.bin").find("own folder"), std::string::npos);
    EXPECT_NE(changed("/buffers/0/uri", "%2e%2e/square.bin").find("own folder"), std::string::npos);
    EXPECT_NE(changed("/buffers/0/uri", "http://localhost/square.bin").find("own folder"),
              std::string::npos);
    EXPECT_NE(changed("/asset/version", "1.0").find("version '1.0'"), std::string::npos);
    EXPECT_NE(changed("/extensionsRequired", json::array({"KHR_draco_mesh_compression"}))
                  .find("KHR_draco_mesh_compression"),
              std::string::npos);
}

TEST(ImportGltf, DeepJsonIsRejectedInsteadOfOverflowingTheStack) {
    const SceneFiles files;
    const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
    EXPECT_NE(test::import_error(
                  files.write("a.gltf", R"({"asset":{"version":"2.0"},"extras":)" + deep + "}"))
                  .find("nests"),
              std::string::npos);
}

}  // namespace
}  // namespace foverig
