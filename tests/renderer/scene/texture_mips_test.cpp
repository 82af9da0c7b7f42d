// Written against IEC 61966-2-1: half of full light is code 188 of 255.
#include <png.h>

#include "renderer/scene/textures.h"
#include "tests/renderer/scene/import_files.h"

namespace foverig {
namespace {

using scene_import::append_texture;
using scene_import::ImportContext;
using scene_import::ImportedScene;
using scene_import::RgbaImage;

constexpr std::uint32_t kWhite = 0xFFFFFFFFU;
constexpr std::uint32_t kBlack = 0xFF000000U;

std::vector<std::uint32_t> coarsest(const RgbaImage& image, bool alpha) {
    ImportedScene imported;
    append_texture(imported, image, {true, true, alpha}, ImportContext{});
    return {imported.scene.texels.end() - 1, imported.scene.texels.end()};
}

TEST(TextureMips, AverageIsTakenInLinearLight) {
    EXPECT_EQ(coarsest({2, 2, false, {kWhite, kBlack, kBlack, kWhite}}, false)[0], 0xFFBCBCBCU);
}

TEST(TextureMips, ColourBehindHolesDoesNotBleed) {
    const std::uint32_t hidden_green = 0x0000FF00U;
    const std::uint32_t red = 0xFF0000FFU;
    EXPECT_EQ(coarsest({2, 2, true, {red, hidden_green, hidden_green, red}}, true)[0], 0x800000FFU);
}

TEST(TextureMips, OpaqueUseForgetsAlpha) {
    ImportedScene imported;
    append_texture(imported, {1, 1, true, {0x10FFFFFFU}}, {true, true, false}, ImportContext{});
    EXPECT_EQ(imported.scene.texels[0], kWhite);
    EXPECT_FALSE(imported.scene.textures[0].has_alpha);
}

TEST(TextureMips, OddSizesWeighEveryTexelByItsArea) {
    // 3 texels to 1: each counts a third; 1/3 of full light is code 156.
    EXPECT_EQ(coarsest({3, 1, false, {kWhite, kBlack, kBlack}}, false)[0], 0xFF9C9C9CU);
    // A constant image stays what it is through every level of any size.
    ImportedScene imported;
    append_texture(imported, {13, 7, false, std::vector<std::uint32_t>(91, 0xFF336699U)},
                   {true, true, false}, ImportContext{});
    EXPECT_EQ(imported.scene.textures[0].level_count, 4U);
    EXPECT_EQ(imported.scene.texels.size(), 91U + 6 * 3 + 3 * 1 + 1);
    for (const std::uint32_t texel : imported.scene.texels) EXPECT_EQ(texel, 0xFF336699U);
}

TEST(TextureImage, PngKeepsItsTexels) {
    const std::vector<std::uint32_t> pixels{0xFF0000FFU, 0x8000FF00U, 0x00FF0000U,
                                            0xFF123456U, 0xFFFFFFFFU, 0xFF000000U};
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = 3;
    png.height = 2;
    png.format = PNG_FORMAT_RGBA;
    png_alloc_size_t size = 0;
    png_image_write_get_memory_size(png, size, 0, pixels.data(), 0, nullptr);
    std::string bytes(size, '\0');
    ASSERT_NE(png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr),
              0);
    const RgbaImage image =
        scene_import::decode_image(std::string_view(bytes).substr(0, size), 100);
    EXPECT_EQ(image.width, 3U);
    EXPECT_EQ(image.pixels, pixels);
    EXPECT_THROW(scene_import::decode_image(std::string_view(bytes).substr(0, size), 5),
                 scene_import::ImageError);
    EXPECT_THROW(scene_import::decode_image(std::string_view(bytes).substr(0, size / 2), 100),
                 scene_import::ImageError);
}

TEST(TextureImage, MaskGoesIntoAlpha) {
    const RgbaImage red{1, 1, false, {0xFF0000FFU}};
    const RgbaImage mask{2, 1, false, {kWhite, kBlack}};
    const RgbaImage both = scene_import::with_alpha_of(red, mask);
    EXPECT_EQ(both.width, 2U);
    EXPECT_EQ(both.pixels[0], 0xFF0000FFU);
    EXPECT_EQ(both.pixels[1], 0x000000FFU);
}

}  // namespace
}  // namespace foverig
