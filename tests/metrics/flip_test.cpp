#include "metrics/flip.h"

#include <gtest/gtest.h>

#include "metrics/flip_hdr.h"
#include "metrics/pooling.h"
#include "tests/metrics/expected.h"
#include "tests/metrics/pictures.h"

namespace foverig::metrics {
namespace {

class FlipAgainstExpected : public test::Expected {
  protected:
    void check(const nlohmann::json& row, const Plane& errors) {
        const Pooled got = pool(errors);
        const auto near = [&](const char* key, double value, const char* name) {
            if (row.contains(key)) {
                EXPECT_NEAR(value, row.at(key).get<double>(), tolerance(name)) << key << row;
            }
        };
        near("mean", got.mean, "flip_mean");
        near("weighted_q1", got.weighted_q1, "flip_weighted_quantiles");
        near("weighted_median", got.weighted_median, "flip_weighted_quantiles");
        near("weighted_q3", got.weighted_q3, "flip_weighted_quantiles");
        near("min", got.min, "flip_minmax");
        near("max", got.max, "flip_minmax");
    }
};

TEST_F(FlipAgainstExpected, HasTheMeansAndQuantilesOfTheReferenceProgram) {
    int rows = 0;
    for (const auto& row : json.at("flip")) {
        if (row.at("mode") != "LDR") continue;
        check(row, flip(image(row.at("ref")), image(row.at("test")), row.at("ppd")));
        ++rows;
    }
    EXPECT_EQ(rows, 28);
}

TEST_F(FlipAgainstExpected, HasThoseOfHighDynamicRangeToo) {
    const std::map<std::string, ToneMapper> tone_mappers{{"aces", ToneMapper::aces},
                                                         {"hable", ToneMapper::hable},
                                                         {"reinhard", ToneMapper::reinhard}};
    int rows = 0;
    for (const auto& row : json.at("flip")) {
        if (row.at("mode") != "HDR") continue;
        const Image& reference = image(row.at("ref"));
        const ToneMapper tone_mapper = tone_mappers.at(row.at("tone_mapper"));
        ExposureRange exposures = exposure_range(reference, tone_mapper);
        if (row.contains("exposures_forced"))
            exposures = {row.at("start_exposure"), row.at("stop_exposure"),
                         row.at("num_exposures")};
        EXPECT_NEAR(exposures.start, row.at("start_exposure"), tolerance("flip_exposure"));
        EXPECT_NEAR(exposures.stop, row.at("stop_exposure"), tolerance("flip_exposure"));
        EXPECT_EQ(exposures.count, row.at("num_exposures").get<int>());
        check(row,
              flip_hdr(reference, image(row.at("test")), row.at("ppd"), tone_mapper, exposures));
        ++rows;
    }
    EXPECT_EQ(rows, 9);
}

TEST_F(FlipAgainstExpected, HasWhatItsAuthorsAndAnotherPortPrinted) {
    int rows = 0;
    for (const auto& row : json.at("published")) {
        if (row.at("metric") != "flip" || !row.contains("ref")) continue;
        check(row, flip(image(row.at("ref")), image(row.at("test")), row.at("ppd")));
        ++rows;
    }
    EXPECT_EQ(rows, 4);
}

TEST(Flip, OfBlackAndWhiteIsItsKnownLargest) {
    // By hand: |dL| = 100; 100^0.7 = 25.1189; 0.95 + (25.1189 - 16.5104) / 24.7657 * 0.05.
    const Plane errors = flip(test::flat(40, 30, vec3(0.0F)), test::flat(40, 30, vec3(1.0F)), 20.0);
    for (const float e : errors.values) EXPECT_NEAR(e, 0.967380F, 1.0e-5F);
}

TEST(Flip, IsSymmetricBitForBitAndZeroForEqualImages) {
    const Image a = test::noise(300, 70, 1);
    const Image b = test::noise(300, 70, 2);
    EXPECT_EQ(flip(a, b, 30.0).values, flip(b, a, 30.0).values);
    EXPECT_EQ(flip(a, a, 30.0).values, std::vector<float>(a.pixels.size(), 0.0F));
}

TEST(Flip, SeesNoMoreOfAnImageAtItsTilesEdges) {
    // A far error reaches only as far as the filters do: the tile it lies in must not matter.
    const Image grey = test::flat(600, 140, vec3(0.2F));
    std::vector<float> middle_rows;
    for (const int x : {100, 255, 256, 511}) {
        Image spot = grey;
        spot.at(x, 64) = vec3(1.0F);
        const Plane errors = flip(grey, spot, 67.0);
        EXPECT_GT(errors.row(64)[x], 0.1F);
        EXPECT_EQ(errors.row(64)[x], flip(spot, grey, 67.0).row(64)[x]);
        middle_rows.push_back(errors.row(64)[x]);
        EXPECT_FLOAT_EQ(errors.row(64)[x - 3], errors.row(64)[x + 3]);
        EXPECT_FLOAT_EQ(errors.row(61)[x], errors.row(67)[x]);
        EXPECT_EQ(errors.row(64)[x - 40], 0.0F);
    }
    for (const float e : middle_rows) EXPECT_FLOAT_EQ(e, middle_rows[0]);
}

TEST(Flip, RefusesImagesOfTwoSizes) {
    EXPECT_THROW(flip(test::noise(8, 8, 1), test::noise(8, 9, 1), 30.0), std::invalid_argument);
}

TEST(HdrFlip, OfABlackReferenceStaysFinite) {
    const Image black = test::flat(32, 32, vec3(0.0F));
    const Image lit = test::flat(32, 32, vec3(3.0F));
    for (const ToneMapper t : {ToneMapper::aces, ToneMapper::hable, ToneMapper::reinhard}) {
        const Pooled got = pool(flip_hdr(black, lit, 67.0, t, exposure_range(black, t)));
        EXPECT_GT(got.mean, 0.3);
        EXPECT_LE(got.max, 1.0);
        Image nearly_black = black;
        nearly_black.at(3, 3) = vec3(5.0F);
        EXPECT_TRUE(std::isfinite(exposure_range(nearly_black, t).stop));
    }
}

}  // namespace
}  // namespace foverig::metrics
