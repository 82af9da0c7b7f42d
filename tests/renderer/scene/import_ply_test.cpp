#include <algorithm>

#include "tests/renderer/scene/import_files.h"

namespace foverig {
namespace {

using test::SceneFiles;

std::string header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment a roof\nelement vertex 4\nproperty float x\nproperty double y\nproperty "
           "short z\nproperty uchar red\n"
           "element face 2\nproperty float quality\nproperty list uchar int "
           "vertex_indices\nend_header\n";
}

template <class T>
void put(std::string& bytes, T value, bool big) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
}

std::string binary_body(bool big) {
    std::string bytes;
    const double corners[4][3] = {{0, 0, 0}, {1, 0.25, 0}, {1, 0.25, 2}, {0, 0, 2}};
    for (const auto& c : corners) {
        put(bytes, static_cast<float>(c[0]), big);
        put(bytes, c[1], big);
        put(bytes, static_cast<std::int16_t>(c[2]), big);
        put(bytes, std::uint8_t{200}, big);
    }
    for (const std::vector<int>& face : {std::vector<int>{0, 1, 2}, std::vector<int>{0, 2, 3}}) {
        put(bytes, 1.0F, big);
        put(bytes, std::uint8_t{3}, big);
        for (const int i : face) put(bytes, i, big);
    }
    return bytes;
}

TEST(ImportPly, ThreeFormatsGiveTheSameScene) {
    const SceneFiles files;
    const Scene ascii = import_scene(files.write(
        "a.ply", header("ascii") +
                     "0 0 0 200\n1 0.25 0 200\n1 .25 2 200\n0 0 2 200\n1 3 0 1 2\n1 3 0 2 3\n"));
    const Scene little =
        import_scene(files.write("l.ply", header("binary_little_endian") + binary_body(false)));
    const Scene big =
        import_scene(files.write("b.ply", header("binary_big_endian") + binary_body(true)));
    EXPECT_EQ(ascii.triangles.size(), 2U);
    EXPECT_EQ(ascii.bounds.max_m, vec3(1.0F, 0.25F, 2.0F));
    for (const Scene* other : {&little, &big}) {
        EXPECT_EQ(ascii.positions_m, other->positions_m);
        EXPECT_EQ(ascii.normals, other->normals);
        EXPECT_EQ(ascii.triangles, other->triangles);
    }
}

TEST(ImportPly, StripsTurnEverySecondTriangleRound) {
    const SceneFiles files;
    const Scene scene = import_scene(
        files.write("s.ply",
                    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float "
                    "y\nproperty float z\n"
                    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n8 0 1 2 3 -1 2 3 4\n"));
    ASSERT_EQ(scene.triangles.size(), 3U);
    for (std::size_t t = 0; t < 3; ++t) EXPECT_GT(test::face_normal(scene, t).z, 0.99) << t;
}

TEST(ImportPly, CountsThatTheFileCannotHoldAreRejectedBeforeMemoryIsAskedFor) {
    const SceneFiles files;
    const std::string start = "ply\nformat binary_little_endian 1.0\nelement vertex ";
    const std::string rest =
        "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list "
        "uint int vertex_indices\nend_header\n";
    EXPECT_NE(
        test::import_error(files.write("v.ply", start + "4000000000" + rest)).find("cannot hold"),
        std::string::npos);
    const std::string lying_list = start + "1" + rest + std::string(12, '\0') + "\xFF\xFF\xFF\xFF";
    EXPECT_NE(test::import_error(files.write("f.ply", lying_list)).find("has a list of"),
              std::string::npos);
    EXPECT_NE(test::import_error(files.write("t.ply", header("ascii") + "0 0 0 200\n1 0.25"))
                  .find("ends before"),
              std::string::npos);
}

}  // namespace
}  // namespace foverig
