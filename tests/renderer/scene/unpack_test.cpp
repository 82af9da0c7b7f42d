#include "renderer/scene/unpack.h"

#include <gmock/gmock.h>
#include <zstd.h>

#include "tests/renderer/scene/import_files.h"

namespace foverig {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string packed(std::string_view bytes) {
    std::string out(ZSTD_compressBound(bytes.size()), '\0');
    out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
    return out;
}

using test::import_error;

TEST(Unpack, APackedSceneIsTheScene) {
    const test::SceneFiles files;
    const Scene scene = import_scene(files.write("one.obj.zst", packed(kTriangle)));
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_EQ(scene.name, "one");
}

TEST(Unpack, FramesOneAfterTheOtherAreOneFile) {
    const std::string both = packed("first, ") + packed("second");
    EXPECT_EQ(scene_import::unpack_zstd(both, "both.zst", 1000), "first, second");
}

TEST(Unpack, WhatTheFormatCannotHoldIsRefusedHoweverSmallItIsPacked) {
    const std::string many = packed(std::string(200'000, 'v') + std::string(200'000, 'w'));
    std::string padded = many;  // a packed file of honest size
    for (int i = 0; i < 2000; ++i) padded += packed("0123456789 " + std::to_string(i * 7919));
    EXPECT_GT(scene_import::unpack_zstd(padded, "big.zst", 1'000'000).size(), 400'000U);
    EXPECT_THROW(scene_import::unpack_zstd(padded, "big.zst", 100'000), SceneError);
}

TEST(Unpack, TornAndDamagedDataNameTheFileAndWhatToDo) {
    const test::SceneFiles files;
    const std::string whole = packed(std::string(5000, 'v') + kTriangle);
    const std::string torn = import_error(files.write("torn.obj.zst", whole.substr(0, 20)));
    EXPECT_THAT(torn, testing::HasSubstr("torn.obj.zst: ends within its zstd data"));
    std::string bent = whole;
    bent[4] = '\xFF';
    const std::string damaged = import_error(files.write("bent.obj.zst", bent));
    EXPECT_THAT(damaged, testing::HasSubstr("bent.obj.zst: "));
}

TEST(Unpack, ABombIsRefusedBeforeItFillsTheMemory) {
    const test::SceneFiles files;
    const std::string bomb = packed(std::string(std::size_t{64} << 20U, '\0'));
    ASSERT_LT(bomb.size(), 10'000U);
    EXPECT_THAT(import_error(files.write("bomb.obj.zst", bomb)),
                testing::HasSubstr("unpacks to more than 64 times"));
}

TEST(Unpack, TheSuffixBelowStillDecides) {
    const test::SceneFiles files;
    EXPECT_THAT(import_error(files.write("mesh.stl.zst", packed("solid"))),
                testing::HasSubstr("has the suffix '.stl'"));
}

}  // namespace
}  // namespace foverig
