#include "devices/dk2/factory_calibration.h"

#include <gtest/gtest.h>

namespace foverig::dk2 {
namespace {

TEST(FactoryCalibration, NothingStoredChangesNothing) {
    const FactoryCalibration c = FactoryCalibration::from({});
    EXPECT_EQ(c.accel({120, 98066, -55}), to_si({120, 98066, -55}));
    EXPECT_EQ(c.gyro({12, -18, 33}, 31.0), to_si({12, -18, 33}));
}

TEST(FactoryCalibration, RowsMultiplyWhatIsLeftAfterTheOffset) {
    FactoryCalibrationReport report;
    report.gyro_offset = {100, 200, 300};
    report.gyro_rows[0] = {10486, 20972, 0};  // 1 + 0.01, 0.02, 0 to within a unit
    report.gyro_rows[2] = {0, 0, -10486};
    const dvec3 w = FactoryCalibration::from(report).gyro({1100, 1200, 1300}, 25.0);
    EXPECT_NEAR(w.x, 0.1 * 1.01 + 0.1 * 0.02, 1e-6);
    EXPECT_NEAR(w.y, 0.1, 1e-12);
    EXPECT_NEAR(w.z, 0.1 * 0.99, 1e-6);
}

}  // namespace
}  // namespace foverig::dk2
