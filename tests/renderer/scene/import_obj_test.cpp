#include <cmath>
#include <cstdio>

#include "tests/renderer/scene/import_files.h"

namespace foverig {
namespace {

using test::SceneFiles;

constexpr const char* kCube = R"(
v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f 2 3 7 6
f 4 1 5 8
)";

TEST(ImportObj, CubeWithoutNormalsGetsFlatSides) {
    const SceneFiles files;
    const Scene scene = import_scene(files.write("cube.obj", kCube));
    EXPECT_EQ(scene.triangles.size(), 12U);
    EXPECT_EQ(scene.positions_m.size(), 24U);
    EXPECT_NEAR(test::area_m2(scene), 24.0, 1.0e-9);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k)
            EXPECT_GT(
                glm::dot(dvec3(scene.normals[scene.triangles[t][k]]), test::face_normal(scene, t)),
                0.9999);
}

TEST(ImportObj, FineSphereWithoutNormalsGetsRadialOnes) {
    constexpr int kRings = 24;
    constexpr int kSegments = 48;
    std::string text;
    for (int r = 0; r <= kRings; ++r)
        for (int s = 0; s < kSegments; ++s) {
            const double polar = 3.14159265358979 * r / kRings;
            const double around = 2.0 * 3.14159265358979 * s / kSegments;
            char line[96];
            std::snprintf(line, sizeof line, "v %.12f %.12f %.12f\n",
                          std::sin(polar) * std::cos(around), std::cos(polar),
                          std::sin(polar) * std::sin(around));
            text += line;
        }
    for (int r = 0; r < kRings; ++r)
        for (int s = 0; s < kSegments; ++s) {
            const int a = 1 + r * kSegments + s;
            const int b = 1 + r * kSegments + (s + 1) % kSegments;
            text += "f " + std::to_string(a) + " " + std::to_string(b) + " " +
                    std::to_string(b + kSegments) + " " + std::to_string(a + kSegments) + "\n";
        }
    const SceneFiles files;
    const Scene scene = import_scene(files.write("sphere.obj", text));
    for (std::size_t i = 0; i < scene.positions_m.size(); ++i)
        EXPECT_GT(glm::dot(scene.normals[i], glm::normalize(scene.positions_m[i])), 0.999F)
            << "vertex " << i;
}

TEST(ImportObj, ConcavePolygonKeepsItsArea) {
    const SceneFiles files;
    // An L of three unit squares, clockwise seen from +z, and a comb.
    const Scene l = import_scene(files.write(
        "l.obj", "v 0 0 0\nv 0 2 0\nv 1 2 0\nv 1 1 0\nv 2 1 0\nv 2 0 0\nf 1 2 3 4 5 6\n"));
    EXPECT_EQ(l.triangles.size(), 4U);
    EXPECT_NEAR(test::area_m2(l), 3.0, 1.0e-12);
    EXPECT_LT(test::face_normal(l, 0).z, -0.99);

    std::string comb;
    std::string face = "f 1 2";
    comb += "v 10 -1 0\nv 0 -1 0\n";
    for (int i = 0; i < 10; ++i) {
        comb += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + ".5 5 0\n";
        face += " " + std::to_string(3 + 2 * i) + " " + std::to_string(4 + 2 * i);
    }
    comb += "v 10 0 0\n";
    const Scene teeth = import_scene(files.write("comb.obj", comb + face + " 23\n"));
    EXPECT_NEAR(test::area_m2(teeth), 10.0 + 10 * 2.5, 1.0e-5);
}

TEST(ImportObj, NegativeIndicesCountFromTheEnd) {
    const SceneFiles files;
    const Scene scene = import_scene(
        files.write("n.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n"));
    ASSERT_EQ(scene.triangles.size(), 1U);
    EXPECT_NEAR(test::area_m2(scene), 0.5, 1.0e-12);
}

TEST(ImportObj, FarSceneKeepsItsShapeRelativeToItsOrigin) {
    const SceneFiles files;
    // Ten kilometres away float steps by 1 mm; these sides are 0.1 mm long.
    const Scene scene = import_scene(files.write(
        "far.obj", "v 10000 20000 0\nv 10000.0001 20000 0\nv 10000 20000.0001 0\nf 1 2 3\n"));
    EXPECT_NEAR(scene.origin_m.x, 10000.0, 1.0);
    EXPECT_NEAR(scene.origin_m.y, 20000.0, 1.0);
    EXPECT_NEAR(test::area_m2(scene), 0.5e-8, 1.0e-12);
}

TEST(ImportObj, ScaleTurnsFileUnitsIntoMetres) {
    const SceneFiles files;
    ImportSettings settings;
    settings.metres_per_unit = 0.001;
    const Scene scene = import_scene(files.write("cube.obj", kCube), settings);
    EXPECT_FLOAT_EQ(scene.bounds.max_m.x, 0.001F);
    EXPECT_NEAR(test::area_m2(scene) / 24.0e-6, 1.0, 1.0e-6);
}

TEST(ImportObj, TrianglesWithoutAreaOrNumbersAreDroppedAndNoted) {
    const SceneFiles files;
    const Scene scene = import_scene(
        files.write("odd.obj",
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 2 0 0\nv 1.#IND 0 0\nv 1e999 0 0\n"
                    "f 1 2 3\nf 1 2 5\nf 1 2 4\nf 1 2 6\nf 1 3 7\n"));
    EXPECT_EQ(scene.triangles.size(), 1U);
    ASSERT_EQ(scene.notes.size(), 2U);
    EXPECT_EQ(scene.notes[0], "3 triangles left out: a corner is not a finite number");
    EXPECT_EQ(scene.notes[1], "1 triangles left out: they have no area");
}

TEST(ImportObj, MaterialsFollowTheLibrary) {
    const SceneFiles files;
    files.write("m.mtl",
                "newmtl a\nKd 0.1 0.2 0.3\nKs 0.5 0.5 0.5\nNs 40\nillum 2\nnewmtl lamp\nKd 0 0 "
                "0\nKe 5 6 7\nnewmtl glass\nd 0.25\nNi 1.33\n");
    const Scene scene =
        import_scene(files.write("m.obj",
                                 "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl a\nf 1 "
                                 "2 3\nusemtl lamp \nf 2 4 3\nusemtl glass\nf 1 2 4\n"));
    ASSERT_EQ(scene.materials.size(), 3U);
    EXPECT_EQ(scene.materials[0].diffuse, vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(scene.materials[0].specular, vec3(0.5F));
    EXPECT_EQ(scene.materials[0].shininess, 40.0F);
    EXPECT_EQ(scene.materials[1].emission, vec3(5.0F, 6.0F, 7.0F));
    EXPECT_FLOAT_EQ(scene.materials[2].transmission, 0.75F);
    EXPECT_FLOAT_EQ(scene.materials[2].ior, 1.33F);
}

TEST(ImportObj, EmissiveQuadBecomesAnAreaLight) {
    const SceneFiles files;
    files.write("m.mtl", "newmtl lamp\nKe 5 6 7\n");
    const Scene scene =
        import_scene(files.write("m.obj",
                                 "mtllib m.mtl\nv 0 0 0\nv 4 0 0\nv 4 0 4\nv 0 0 4\nf 1 2 3 4\n"
                                 "v 1 3 1\nv 3 3 1\nv 3 3 2\nv 1 3 2\nusemtl lamp\nf 5 6 7 8\n"));
    ASSERT_EQ(scene.area_lights.size(), 1U);
    EXPECT_TRUE(scene.point_lights.empty());
    const AreaLight& light = scene.area_lights[0];
    EXPECT_EQ(light.radiance, vec3(5.0F, 6.0F, 7.0F));
    EXPECT_NEAR(glm::length(glm::cross(light.edge_u_m, light.edge_v_m)), 2.0F, 1.0e-5F);
    const vec3 middle = light.corner_m + 0.5F * (light.edge_u_m + light.edge_v_m);
    EXPECT_NEAR(glm::length(middle - vec3(2.0F, 3.0F, 1.5F)), 0.0F, 1.0e-5F);
}

TEST(ImportObj, LibraryOutsideTheFolderIsNotRead) {
    const SceneFiles files;
    files.write("secret.mtl", "newmtl a\nKd 0.1 0.2 0.3\n");
    constexpr const char* kBody = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    std::filesystem::create_directories(files.folder() / "in");
    std::filesystem::create_symlink(files.folder() / "secret.mtl",
                                    files.folder() / "in" / "link.mtl");
    for (const std::string& name :
         {std::string("../secret.mtl"), (files.folder() / "secret.mtl").string(),
          std::string("link.mtl"), std::string("..\\secret.mtl")}) {
        const Scene scene = import_scene(files.write("in/a.obj", "mtllib " + name + "\n" + kBody));
        EXPECT_EQ(scene.materials[0].diffuse, Material{}.diffuse) << name;
        EXPECT_FALSE(scene.notes.empty()) << name;
    }
}

TEST(ImportObj, ErrorsAreOneSentenceThatNamesTheFile) {
    const SceneFiles files;
    const auto far_index = files.write("a.obj", "v 0 0 0\nf 1 2 3\n");
    EXPECT_EQ(test::import_error(far_index),
              far_index.string() +
                  ": face 1 names position 2, but 1 are there before it; indices start at 1");
    EXPECT_NE(test::import_error(files.folder() / "gone.obj").find("there is no such file"),
              std::string::npos);
    EXPECT_NE(
        test::import_error(files.write("a.fbx", "x")).find("expected .obj, .gltf, .glb or .ply"),
        std::string::npos);
    EXPECT_NE(
        test::import_error(files.write("big.obj", "v 0 0 0\nv 3e38 0 0\nv 0 3e38 0\nf 1 2 3\n"))
            .find("metres_per_unit"),
        std::string::npos);
    ImportSettings few;
    few.max_triangles = 11;
    EXPECT_NE(
        test::import_error(files.write("cube.obj", kCube), few).find("more than 11 triangles"),
        std::string::npos);
}

}  // namespace
}  // namespace foverig
