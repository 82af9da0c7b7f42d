#include "metrics/pixel_errors.h"

#include <gtest/gtest.h>

#include "metrics/display_code.h"
#include "metrics/finite.h"
#include "metrics/ssim.h"
#include "tests/metrics/expected.h"
#include "tests/metrics/pictures.h"

namespace foverig::metrics {
namespace {

class BasicAgainstExpected : public test::Expected {};

TEST_F(BasicAgainstExpected, HasThePlainErrorsOfTheRows) {
    int values = 0;
    for (const auto& row : json.at("basic")) {
        const Image& r = image(row.at("ref"));
        const Image& t = image(row.at("test"));
        const auto relative = [&](const char* key, double value) {
            if (!row.contains(key)) return;
            const double expected = row.at(key).get<double>();
            EXPECT_NEAR(value, expected, tolerance("mse_rel") * expected) << key << row;
            ++values;
        };
        const Differences codes = code_differences(r, t);
        relative("mse_rgb8", codes.mse);
        relative("mae_rgb8", codes.mae);
        if (row.contains("max_abs")) {
            EXPECT_NEAR(codes.largest, row.at("max_abs").get<double>(), 1.0e-3);
        }
        if (row.contains("psnr_rgb8")) {
            EXPECT_NEAR(psnr_db(codes.mse), row.at("psnr_rgb8").get<double>(),
                        tolerance("psnr_db"));
        }
        const Differences linear = linear_differences(r, t);
        relative("mse", linear.mse);
        relative("mae", linear.mae);
        const RelativeDifferences to_reference = relative_differences(r, t);
        relative("relmse_eps1e_2", to_reference.relmse);
        relative("mape_eps1e_2", to_reference.mape);
        relative("smape_eps1e_2", to_reference.smape);
    }
    EXPECT_EQ(values, 6 * 2 + 2 * 5 + 2);
}

TEST_F(BasicAgainstExpected, HasTheStructuralSimilarityOfTheRows) {
    int rows = 0;
    for (const auto& row : json.at("basic")) {
        if (!row.contains("ssim_luma_wang2004")) continue;
        EXPECT_NEAR(ssim(image(row.at("ref")), image(row.at("test"))).value(),
                    row.at("ssim_luma_wang2004").get<double>(), tolerance("ssim"))
            << row;
        ++rows;
    }
    EXPECT_EQ(rows, 6);
}

TEST(PixelErrors, AreTheirDefinitionsOnOnePixel) {
    const Image r = test::flat(1, 1, vec3(2.0F, 0.0F, 1.0F));
    const Image t = test::flat(1, 1, vec3(3.0F, 0.5F, 1.0F));
    EXPECT_NEAR(linear_differences(r, t).mse, 1.25 / 3.0, 1e-12);
    EXPECT_NEAR(linear_differences(r, t).mae, 1.5 / 3.0, 1e-12);
    EXPECT_EQ(linear_differences(r, t).largest, 1.0);
    const RelativeDifferences e = relative_differences(r, t);
    EXPECT_NEAR(e.relmse, (1.0 / 4.01 + 0.25 / 0.01) / 3.0, 1e-9);
    EXPECT_NEAR(e.mape, (1.0 / 2.01 + 0.5 / 0.01) / 3.0, 1e-9);
    EXPECT_NEAR(e.smape, (2.0 / 5.01 + 1.0 / 0.51) / 3.0, 1e-9);
    EXPECT_NEAR(psnr_db(255.0 * 255.0), 0.0, 1e-12);
    EXPECT_TRUE(std::isinf(psnr_db(0.0)));
}

TEST(PixelErrors, AreZeroForEqualImagesAndSymmetricWhereTheySaySo) {
    const Image a = test::noise(61, 37, 3);
    const Image b = test::noise(61, 37, 4);
    EXPECT_EQ(code_differences(a, a).mse, 0.0);
    EXPECT_EQ(linear_differences(a, a).largest, 0.0);
    EXPECT_EQ(relative_differences(a, a).relmse, 0.0);
    EXPECT_EQ(ssim(a, a).value(), 1.0);
    EXPECT_EQ(code_differences(a, b).mse, code_differences(b, a).mse);
    EXPECT_EQ(relative_differences(a, b).smape, relative_differences(b, a).smape);
    EXPECT_EQ(ssim(a, b).value(), ssim(b, a).value());
}

TEST(Ssim, OfConstantImagesIsTheLuminanceTermAlone) {
    const Image black = test::flat(16, 12, vec3(0.0F));
    const Image white = test::flat(16, 12, vec3(1.0F));
    constexpr double kC1 = 0.01 * 255.0 * 0.01 * 255.0;
    EXPECT_NEAR(ssim(black, white).value(), kC1 / (255.0 * 255.0 + kC1), 1e-6);
    EXPECT_FALSE(ssim(test::flat(10, 40, vec3(0.0F)), test::flat(10, 40, vec3(0.0F))));
}

TEST(DisplayCode, IsTheCodeOfEveryEightBitImage) {
    for (int code = 0; code < 256; ++code)
        EXPECT_NEAR(display_code(linear_from_srgb(static_cast<float>(code) / 255.0F)), code, 1e-3);
    EXPECT_EQ(display_code(-1.0F), 0.0F);
    EXPECT_NEAR(display_code(7.0F), 255.0F, 1e-4);
}

TEST(Power, IsThatOfDoublePrecision) {
    double worst = 0.0;
    for (int i = 1; i < 40000; ++i) {
        const float x = 1.0e-4F * static_cast<float>(i) * static_cast<float>(i % 97 + 1);
        for (const float p : {1.0F / 3.0F, 0.7F, 1.0F / 2.4F, 0.03F}) {
            const double expected = std::pow(double{x}, double{p});
            worst = std::max(worst, std::abs(double{power_of(x, p)} - expected) / expected);
        }
    }
    EXPECT_LT(worst, 1.0e-6);
    EXPECT_EQ(power_of(0.0F, 0.5F), 0.0F);
    EXPECT_EQ(power_of(-1.0F, 0.5F), 0.0F);
}

TEST(Finite, CountsWhatNoMetricMayMeetAndReplacesIt) {
    Image image = test::noise(9, 5, 1);
    image.at(3, 2) = {NAN, INFINITY, -INFINITY};
    EXPECT_EQ(count_not_finite(image), 3U);
    const Image mended = with_finite_values(image);
    EXPECT_EQ(mended.at(3, 2), vec3(0.0F, 65504.0F, 0.0F));
    EXPECT_EQ(count_not_finite(mended), 0U);
    EXPECT_EQ(mended.at(2, 2), image.at(2, 2));
}

}  // namespace
}  // namespace foverig::metrics
