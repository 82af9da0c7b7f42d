#include "renderer/image_read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <fstream>

namespace foverig {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class ImageRead : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / ("image_read_" + std::to_string(getpid()));
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    ReadImage read(const std::string& bytes) const {
        const fs::path file = root_ / "image";
        std::ofstream(file, std::ios::binary) << bytes;
        return read_image(file);
    }

    std::string complaint(const std::string& bytes) const {
        try {
            read(bytes);
        } catch (const ImageFileError& error) {
            return error.what();
        }
        return "read";
    }

    std::string written(bool exr) const {
        Image image{5, 4, {}};
        for (int i = 0; i < 20; ++i)
            image.pixels.emplace_back(static_cast<float>(i) * 0.05F, 0.25F, 1.0F);
        const fs::path file = root_ / "written";
        exr ? write_exr(file, image) : write_png(file, image);
        std::ostringstream text;
        text << std::ifstream(file, std::ios::binary).rdbuf();
        return text.str();
    }

    fs::path root_;
};

/// 16 bits a channel, with alpha; two pixels in a row.
std::string png16(const std::array<std::uint16_t, 8>& codes) {
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &bytes,
        [](png_structp p, png_bytep data, std::size_t size) {
            static_cast<std::string*>(png_get_io_ptr(p))
                ->append(reinterpret_cast<const char*>(data), size);
        },
        nullptr);
    png_set_IHDR(png, info, 2, 1, 16, PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_set_swap(png);
    png_write_row(png, reinterpret_cast<png_const_bytep>(codes.data()));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

std::string float_bytes(float value, bool big_endian) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    std::string bytes;
    for (unsigned i = 0; i < 4; ++i)
        bytes += static_cast<char>(bits >> (8U * (big_endian ? 3U - i : i)));
    return bytes;
}

TEST_F(ImageRead, ReadsSixteenBitsByTheCurveOfSrgbOverBlack) {
    const std::string bytes = png16({1000, 2570, 32768, 65535, 65535, 40000, 0, 32768});
    const Image image = read(bytes).image;
    ASSERT_EQ(image.pixels.size(), 2U);
    // IEC 61966-2-1 by hand: below 0.04045 a straight line, where a power of 2.2 is far off.
    EXPECT_NEAR(image.pixels[0].x, 1000.0 / 65535.0 / 12.92, 1e-7);
    EXPECT_NEAR(image.pixels[0].y, 2570.0 / 65535.0 / 12.92, 1e-7);
    EXPECT_NEAR(image.pixels[0].z, std::pow((32768.0 / 65535.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_NEAR(image.pixels[1].x, 32768.0 / 65535.0, 1e-6);
    EXPECT_THAT(complaint(bytes.substr(0, bytes.size() - 30)), HasSubstr("libpng rejects"));
}

TEST_F(ImageRead, GivesBackWhatWePutIntoPngAndExr) {
    const ReadImage png = read(written(false));
    EXPECT_FALSE(png.high_dynamic_range);
    ASSERT_EQ(png.image.pixels.size(), 20U);
    EXPECT_NEAR(srgb_from_linear(png.image.at(0, 1).x), srgb_from_linear(0.25F), 0.5F / 255.0F);
    const ReadImage exr = read(written(true));
    EXPECT_TRUE(exr.high_dynamic_range);
    ASSERT_EQ(exr.image.width_px, 5);
    EXPECT_NEAR(exr.image.at(1, 2).x, 0.55F, 0.0005F);
    EXPECT_EQ(exr.image.at(4, 3).y, 0.25F);
}

TEST_F(ImageRead, ReadsPfmBottomRowFirstInEitherOrderOfBytes) {
    for (const bool big : {false, true}) {
        std::string bytes = std::string("PF\n1 2\n") + (big ? "1.0\n" : "-1.0\n");
        for (const float v : {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 60000.0F}) bytes += float_bytes(v, big);
        const Image image = read(bytes).image;
        EXPECT_EQ(image.at(0, 1), vec3(1.0F, 2.0F, 3.0F));
        EXPECT_EQ(image.at(0, 0), vec3(4.0F, 5.0F, 60000.0F));
    }
    EXPECT_EQ(read("Pf\n1 1\n-1\n" + float_bytes(0.5F, false)).image.at(0, 0), vec3(0.5F));
}

TEST_F(ImageRead, ReadsRadianceFlatAndPacked) {
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X ";
    // 128 is 2^(128 - 136) * 128 = 0.5 at exponent 128.
    const Image flat = read(head + "1\n" + "\x80\x40\x20\x80").image;
    EXPECT_EQ(flat.at(0, 0), vec3(0.5F, 0.25F, 0.125F));
    const std::string packed = head + "8\n" + std::string("\x02\x02\x00\x08", 4) + "\x88\x80" +
                               "\x88\x40" + "\x88\x20" + "\x08\x80\x80\x80\x80\x81\x81\x81\x81";
    const Image image = read(packed).image;
    EXPECT_EQ(image.at(3, 0), vec3(0.5F, 0.25F, 0.125F));
    EXPECT_EQ(image.at(7, 0), vec3(1.0F, 0.5F, 0.25F));
}

TEST_F(ImageRead, SaysInOneSentenceWhatIsWrong) {
    EXPECT_THAT(complaint("this is no image"), HasSubstr("expected PNG, PFM, Radiance HDR or EXR"));
    EXPECT_THAT(complaint(""), HasSubstr("is no image"));
    EXPECT_THAT(complaint("PF\n4 4\n-1.0\nabcdefghijkl"),
                HasSubstr("cut off after 12 of its 192 bytes"));
    EXPECT_THAT(complaint("PF\n4 400\n-1.0\nabc"), HasSubstr("bytes cannot hold"));
    EXPECT_THAT(complaint("PF\n99999 99999\n-1.0\n"), HasSubstr("more than"));
    EXPECT_THAT(complaint("PF\n-4 4\n-1.0\n"), HasSubstr("has no pixels"));
    EXPECT_THAT(complaint("PF\nfour 4\n-1.0\n"), HasSubstr("'four'"));
    EXPECT_THAT(complaint("PF\n4"), HasSubstr("header is cut off"));
    EXPECT_THAT(complaint("#?RADIANCE\n\n-Y 2 +X 2\nabcd"), HasSubstr("cut off"));
    EXPECT_THAT(complaint("#?RADIANCE\n\n+Y 2 +X 2\n"), HasSubstr("expected -Y N +X N"));
    EXPECT_THAT(complaint("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n"), HasSubstr("xyze"));
    try {
        read_image(root_ / "missing.png");
        FAIL();
    } catch (const ImageFileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("missing.png: there is no such file"));
    }
}

TEST_F(ImageRead, RefusesEveryFileThatIsCutOff) {
    for (const bool exr : {false, true}) {
        const std::string whole = written(exr);
        // A PNG's last chunk holds no pixels, nor does the checksum before it.
        const std::size_t needed = whole.size() - (exr ? 0 : 20);
        for (std::size_t size = 8; size < needed; size += 7)
            EXPECT_NE(complaint(whole.substr(0, size)), "read") << (exr ? "EXR " : "PNG ") << size;
    }
}

}  // namespace
}  // namespace foverig
