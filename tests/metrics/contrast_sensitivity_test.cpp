#include "metrics/contrast_sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/metrics/expected.h"

namespace foverig::metrics {
namespace {

class SensitivityAgainstExpected : public test::Expected {};

TEST_F(SensitivityAgainstExpected, IsThatOfFovVideoVdpsTablesWhereAnythingIsSeen) {
    int rows = 0;
    for (const auto& row : json.at("fvvdp_csf_probe").at("rows")) {
        const double expected = row[4];
        if (expected < 0.01) continue;
        const double s = contrast_sensitivity(row[1], row[0], row[2], row[3]);
        EXPECT_NEAR(s, expected, 0.02 * expected) << row;
        ++rows;
    }
    EXPECT_GT(rows, 40);
}

TEST(SensitivityTable, HoldsTheFormulaBetweenItsEntries) {
    for (const double temporal_hz : {0.0, 5.0}) {
        const SensitivityTable table(temporal_hz);
        for (const double frequency : {0.05, 0.31, 1.7, 5.3, 23.0})
            for (const double background : {0.13, 1.9, 37.0, 410.0}) {
                const double s = contrast_sensitivity(frequency, temporal_hz, background, 0.0);
                const float at = table.at(static_cast<float>(std::log2(frequency)),
                                          static_cast<float>(std::log2(background)));
                EXPECT_NEAR(double{at}, s, 0.005 * s) << frequency << " " << background;
            }
    }
}

TEST(SensitivityTable, FallsAwayFromTheGazeAsTheFormulaDoes) {
    const SensitivityTable table(5.0);
    for (const float eccentricity_deg : {3.0F, 20.0F, 50.0F}) {
        const double s = contrast_sensitivity(1.0, 5.0, 20.0, double{eccentricity_deg});
        const float at = table.at(log2_cortical_demagnification(eccentricity_deg), log2_of(20.0F));
        EXPECT_NEAR(double{at}, s, 0.005 * s) << eccentricity_deg;
    }
}

}  // namespace
}  // namespace foverig::metrics
