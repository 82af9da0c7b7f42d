// FovVideoVDP against what its authors' program says of the shared pictures.
#include "metrics/fovvideovdp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/metrics/expected.h"
#include "tests/metrics/pictures.h"

namespace foverig::metrics {
namespace {

using Json = nlohmann::json;

class FovVideoVdpAgainstExpected : public test::Expected {
  protected:
    static ScreenLight light_of(const Json& row) {
        // 250 lux on a screen that reflects 0.5 % of them.
        if (row.at("display") == "standard_4k" || row.at("display") == "standard_fhd")
            return {200.0, 0.2 + 250.0 / M_PI * 0.005};
        return {100.0, 0.1};
    }

    static double ppd_of(const Json& row, const Image& image) {
        if (row.contains("ppd")) return row.at("ppd");
        if (row.at("display") == "standard_4k") return 75.402449;
        // The diagonal spans 100 degrees.
        const double focal_px =
            0.5 * std::hypot(image.width_px, image.height_px) / std::tan(50.0 * M_PI / 180.0);
        return 1.0 / (2.0 * 180.0 / M_PI * std::atan(0.5 / focal_px));
    }

    static GazedView view_of(const Image& image, double ppd, double gaze_x_px, double gaze_y_px) {
        return gazed_screen(image.width_px, image.height_px, ppd, gaze_x_px, gaze_y_px);
    }

    double still(const Json& row) {
        const Image& reference = image(row.at("ref"));
        const Image& other = image(row.at("test"));
        const bool foveated = row.value("foveated", false);
        const Json at = row.value("fixation", Json::array({0, 0}));
        FovVideoVdp vdp(light_of(row), std::nullopt);
        vdp.add(
            reference, other,
            view_of(reference, ppd_of(row, reference), at[0].get<double>(), at[1].get<double>()),
            foveated);
        bands_ = vdp.band_differences();
        return vdp.jod();
    }

    double video(const Json& row) {
        const auto reference = test::frames_of(image(row.at("ref")), 128);
        const auto other = test::frames_of(image(row.at("test")), 128);
        FovVideoVdp vdp(light_of(row), row.at("fps").get<double>());
        const double last = static_cast<double>(reference.size() - 1);
        for (std::size_t i = 0; i < reference.size(); ++i) {
            const double t = static_cast<double>(i) / last;
            vdp.add(
                reference[i], other[i],
                view_of(reference[i], ppd_of(row, reference[i]), 20.0 + 120.0 * t, 20.0 + 88.0 * t),
                row.at("foveated").get<bool>());
        }
        return vdp.jod();
    }

    std::vector<double> bands_;
};

TEST_F(FovVideoVdpAgainstExpected, SaysOfStillsWhatItsAuthorsProgramSays) {
    int rows = 0;
    for (const Json& row : json.at("fvvdp")) {
        if (row.at("metric") != "fvvdp" || row.contains("fps")) continue;
        EXPECT_NEAR(still(row), row.at("jod").get<double>(), tolerance("fvvdp_jod")) << row;
        ++rows;
    }
    EXPECT_EQ(rows, 24);
}

TEST_F(FovVideoVdpAgainstExpected, HasItsDifferencesBandByBand) {
    int rows = 0;
    for (const Json& row : json.at("fvvdp")) {
        if (row.at("metric") != "fvvdp_Q_per_band") continue;
        still(row);
        ASSERT_EQ(bands_.size(), row.at("Q").size());
        for (std::size_t i = 0; i < bands_.size(); ++i) {
            const double expected = row.at("Q")[i];
            EXPECT_NEAR(bands_[i], expected, 0.04 * expected) << "band " << i;
        }
        ++rows;
    }
    EXPECT_EQ(rows, 1);
}

TEST_F(FovVideoVdpAgainstExpected, SaysOfVideosWhatItsAuthorsProgramSays) {
    int rows = 0;
    for (const Json& row : json.at("fvvdp")) {
        if (!row.contains("fps")) continue;
        EXPECT_NEAR(video(row), row.at("jod").get<double>(), tolerance("fvvdp_jod")) << row;
        ++rows;
    }
    EXPECT_EQ(rows, 6);
}

TEST_F(FovVideoVdpAgainstExpected, HasThePublishedValueOfTheBlurredFacade) {
    for (const Json& row : json.at("published"))
        if (row.at("metric") == "fvvdp" && row.at("ref") == "wavy_facade.png") {
            EXPECT_NEAR(still(row), row.at("jod_published").get<double>(), tolerance("fvvdp_jod"));
        }
}

Image greyer(const Image& image) {
    Image out = image;
    for (vec3& p : out.pixels) p = 0.9F * p + 0.05F;
    return out;
}

TEST(FovVideoVdp, FindsNothingBetweenEqualFrames) {
    FovVideoVdp vdp({}, 75.0);
    EXPECT_EQ(vdp.jod(), 10.0);
    const GazedView view = gazed_screen(64, 48, 10.0, 10.0, 40.0);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Image frame = test::noise(64, 48, i);
        vdp.add(frame, frame, view, true);
    }
    EXPECT_EQ(vdp.jod(), 10.0);
}

TEST(FovVideoVdp, SeesAFineFaintErrorBetterWhereTheGazeIs) {
    const Image grey = test::flat(128, 128, vec3(0.2F));
    const Image grain = test::noise(128, 128, 1);
    Image grainy = grey;
    for (int y = 48; y < 80; ++y)
        for (int x = 8; x < 40; ++x) grainy.at(x, y) += vec3(0.1F * (grain.at(x, y).x - 0.5F));
    FovVideoVdp at({}, std::nullopt), beside({}, std::nullopt), everywhere({}, std::nullopt);
    at.add(grey, grainy, gazed_screen(128, 128, 20.0, 24.0, 64.0), true);
    beside.add(grey, grainy, gazed_screen(128, 128, 20.0, 120.0, 64.0), true);
    everywhere.add(grey, grainy, gazed_screen(128, 128, 20.0, 120.0, 64.0), false);
    EXPECT_LT(at.jod(), beside.jod() - 0.1);
    EXPECT_LT(everywhere.jod(), beside.jod() - 0.1);
}

TEST(FovVideoVdp, SeesAnErrorOnADarkScreenLess) {
    const Image frame = test::noise(64, 64, 3);
    FovVideoVdp bright({500.0, 0.5}, std::nullopt), dark({1.0, 0.001}, std::nullopt);
    const GazedView view = gazed_screen(64, 64, 20.0, 32.0, 32.0);
    bright.add(frame, greyer(frame), view, false);
    dark.add(frame, greyer(frame), view, false);
    EXPECT_LT(bright.jod(), dark.jod());
}

TEST(FovVideoVdp, RefusesAFrameOfAnotherSize) {
    FovVideoVdp vdp({}, 75.0);
    vdp.add(test::noise(16, 16, 1), test::noise(16, 16, 1), gazed_screen(16, 16, 10.0, 8, 8), true);
    EXPECT_THROW(vdp.add(test::noise(16, 17, 1), test::noise(16, 17, 1),
                         gazed_screen(16, 17, 10.0, 8, 8), true),
                 std::invalid_argument);
    EXPECT_THROW(FovVideoVdp({}, 4.0), std::invalid_argument);
}

}  // namespace
}  // namespace foverig::metrics
