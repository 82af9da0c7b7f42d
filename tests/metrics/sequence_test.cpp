// What is measured over a sequence: change, flicker, and the filters that flicker is seen through.
#include <gtest/gtest.h>

#include "metrics/change.h"
#include "metrics/flicker.h"
#include "metrics/regional_change.h"
#include "metrics/temporal_filters.h"
#include "tests/metrics/expected.h"
#include "tests/metrics/pictures.h"

namespace foverig::metrics {
namespace {

class SequenceAgainstExpected : public test::Expected {};

TEST_F(SequenceAgainstExpected, HasTheDerivativeErrorsOfTheRows) {
    int rows = 0;
    for (const auto& row : json.at("basic")) {
        if (!row.contains("temporal_derivative_mse_rgb8")) continue;
        const auto reference = test::frames_of(image(row.at("ref")), 128);
        const auto other = test::frames_of(image(row.at("test")), 128);
        ChangeOverTime over_time;
        for (std::size_t i = 0; i < reference.size(); ++i) over_time.add(reference[i], other[i]);
        const double mse = row.at("temporal_derivative_mse_rgb8");
        const double mae = row.at("temporal_derivative_mae_rgb8");
        EXPECT_EQ(over_time.change().pairs, 23);
        EXPECT_NEAR(over_time.change().mse, mse, tolerance("mse_rel") * mse);
        EXPECT_NEAR(over_time.change().mae, mae, tolerance("mse_rel") * mae);
        ++rows;
    }
    EXPECT_EQ(rows, 2);
}

TEST_F(SequenceAgainstExpected, SeesThroughTheFiltersOfFovVideoVdp) {
    const auto& expected = json.at("fvvdp_temporal_filters").at(0);
    const TemporalFilters filters(expected.at("fps").get<double>());
    ASSERT_EQ(filters.sustained.size(), expected.at("sustained").size());
    for (std::size_t i = 0; i < filters.sustained.size(); ++i) {
        EXPECT_NEAR(filters.sustained[i], expected.at("sustained")[i].get<double>(), 1e-6) << i;
        EXPECT_NEAR(filters.transient[i], expected.at("transient")[i].get<double>(), 1e-6) << i;
    }
}

TEST_F(SequenceAgainstExpected, FindsMoreFlickerWhereABrightnessFlickersThanInNoise) {
    const auto reference = test::frames_of(image("vid_ref.png"), 128);
    const auto flickering = test::frames_of(image("vid_flicker.png"), 128);
    Flicker flicker(75.0), none(75.0);
    for (std::size_t i = 0; i < reference.size(); ++i) {
        flicker.add(reference[i], flickering[i]);
        none.add(reference[i], reference[i]);
    }
    EXPECT_GT(flicker.rms_codes(), 0.5);
    EXPECT_EQ(none.rms_codes(), 0.0);
}

TEST(Change, TellsTheReferencesMotionFromTheTests) {
    const auto grey = [](float code) {
        return test::flat(7, 3, vec3(linear_from_srgb(code / 255.0F)));
    };
    ChangeOverTime over_time;
    over_time.add(grey(10.0F), grey(10.0F));
    over_time.add(grey(13.0F), grey(20.0F));
    over_time.add(grey(13.0F), grey(20.0F));
    const Change change = over_time.change();
    EXPECT_NEAR(change.reference, 1.5, 1e-3);
    EXPECT_NEAR(change.test, 5.0, 1e-3);
    EXPECT_NEAR(change.mae, 3.5, 1e-3);
    EXPECT_NEAR(change.mse, 24.5, 1e-2);
}

TEST(Flicker, OfAnErrorThatStandsStillIsNextToNothing) {
    Flicker still(75.0), blinking(75.0);
    const Image dark = test::flat(8, 8, vec3(0.1F));
    const Image light = test::flat(8, 8, vec3(0.2F));
    for (int i = 0; i < 40; ++i) {
        still.add(dark, light);
        blinking.add(dark, i / 8 % 2 == 0 ? light : dark);
    }
    EXPECT_GT(blinking.rms_codes(), 5.0);
    EXPECT_LT(still.rms_codes(), 0.05 * blinking.rms_codes());
}

// What is thrown away need not be computed: of a frame that is only seen the next ones keep all.
TEST(SequenceMetrics, SeeThroughFramesThatAreNotJudged) {
    const auto frame = [](int i) {
        return test::flat(8, 8, vec3(0.1F + 0.02F * static_cast<float>(i * i % 7)));
    };
    const Image still = test::flat(8, 8, vec3(0.3F));
    ChangeOverTime all, last;
    Flicker flicker(75.0), last_flicker(75.0);
    for (int i = 0; i < 30; ++i) {
        all.add(still, frame(i));
        flicker.add(still, frame(i));
        if (i < 29) {
            last.see(still, frame(i));
            last_flicker.see(still, frame(i));
        }
    }
    last.add(still, frame(29));
    last_flicker.add(still, frame(29));
    EXPECT_EQ(last.change().pairs, 1);
    EXPECT_EQ(last.change().mae, all.newest().mae);
    EXPECT_GT(last.change().mae, 0.0);
    EXPECT_EQ(last_flicker.newest_rms_codes(), flicker.newest_rms_codes());
    EXPECT_GT(last_flicker.newest_rms_codes(), 0.0);
    EXPECT_THROW(last.see(test::flat(4, 4, vec3(0.0F)), test::flat(4, 4, vec3(0.0F))),
                 std::invalid_argument);
}

TEST(RegionalChange, TellsTheFoveaFromThePeripheryAndAgreesWithTheWholeImage) {
    constexpr int kWidth = 60, kHeight = 40;
    const GazedView view = gazed_screen(kWidth, kHeight, 4.0, 20.0, 20.0);
    RegionalChangeOverTime regional(75.0, 3.0);
    ChangeOverTime whole;
    Flicker flicker(75.0);
    const Image still = test::flat(kWidth, kHeight, vec3(0.3F));
    for (int i = 0; i < 6; ++i) {
        Image other = still;
        for (int y = 15; y < 25; ++y)  // within 3 degrees of the gaze
            for (int x = 15; x < 25; ++x) other.at(x, y) = vec3(i % 2 == 0 ? 0.3F : 0.4F);
        regional.add(still, other, view);
        whole.add(still, other);
        flicker.add(still, other);
    }
    const RegionalChange change = regional.change();
    ASSERT_TRUE(change.fovea && change.periphery);
    EXPECT_EQ(change.fovea->reference, 0.0);
    EXPECT_EQ(change.periphery->test, 0.0);
    EXPECT_EQ(change.periphery->flicker_rms, 0.0);
    Plane inside(kWidth, kHeight);
    const double share =
        static_cast<double>(pool_by_gaze(inside, view, 3.0).fovea_pixels) / (kWidth * kHeight);
    EXPECT_NEAR(change.fovea->test * share, whole.change().test, 1e-6);
    EXPECT_NEAR(change.fovea->mae * share, whole.change().mae, 1e-6);
    EXPECT_GT(change.fovea->flicker_rms, flicker.rms_codes());
}

TEST(RegionalChange, HasNoPeripheryWhereAllIsFoveaAndNothingOfOneFrame) {
    const Image frame = test::noise(8, 8, 1);
    RegionalChangeOverTime regional(75.0, 170.0);
    const GazedView view = gazed_screen(8, 8, 10.0, 4.0, 4.0);
    regional.add(frame, frame, view);
    EXPECT_FALSE(regional.change().fovea);
    regional.add(frame, test::noise(8, 8, 2), view);
    EXPECT_TRUE(regional.change().fovea);
    EXPECT_FALSE(regional.change().periphery);
}

TEST(Flicker, RefusesAFrameOfAnotherSizeAndTooFewFramesASecond) {
    Flicker flicker(75.0);
    flicker.add(test::noise(8, 8, 1), test::noise(8, 8, 2));
    EXPECT_THROW(flicker.add(test::noise(8, 9, 1), test::noise(8, 9, 2)), std::invalid_argument);
    EXPECT_THROW(TemporalFilters(4.0), std::invalid_argument);
}

}  // namespace
}  // namespace foverig::metrics
