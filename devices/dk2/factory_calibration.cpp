#include "devices/dk2/factory_calibration.h"

namespace foverig::dk2 {
namespace {

dmat3 matrix(const std::array<Triple, 3>& rows) {
    dmat3 transposed;  // glm stores columns
    for (int i = 0; i < 3; ++i) {
        const Triple& row = rows[static_cast<std::size_t>(i)];
        transposed[i] = FactoryCalibrationReport::kMatrixUnit * dvec3(row.x, row.y, row.z);
        transposed[i][i] += 1;
    }
    return glm::transpose(transposed);
}

}  // namespace

FactoryCalibration FactoryCalibration::from(const FactoryCalibrationReport& report) {
    return {to_si(report.accel_offset), GyroOffsets(to_si(report.gyro_offset)),
            matrix(report.accel_rows), matrix(report.gyro_rows)};
}

}  // namespace foverig::dk2
