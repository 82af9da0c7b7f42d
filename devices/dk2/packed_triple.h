#pragma once
// Three signed 21-bit values in one big-endian 64-bit word (DEVICES.md 1.2.1).
#include <cstdint>

#include "devices/bytes.h"
#include "devices/math.h"

namespace foverig::dk2 {

/// Raw units: 1e-4 m/s^2, 1e-4 rad/s, or matrix elements, by context.
struct Triple {
    std::int32_t x = 0, y = 0, z = 0;
    bool operator==(const Triple&) const = default;
};

constexpr std::int32_t kTripleMin = -1048576;
constexpr std::int32_t kTripleMax = 1048575;
constexpr std::size_t kTripleSize = 8;
constexpr double kTripleUnit = 1e-4;  ///< m/s^2 or rad/s for one step

/// `b` has at least at + 8 bytes.
Triple read_triple(Bytes b, std::size_t at);
/// Saturates each value to 21 bits, as the sensor's own range would.
void write_triple(std::span<std::byte> b, std::size_t at, const Triple& t);

/// In m/s^2 or rad/s.
inline dvec3 to_si(const Triple& t) {
    return kTripleUnit * dvec3(t.x, t.y, t.z);
}
/// Nearest representable triple, saturated; NaN gives 0.
Triple from_si(const dvec3& v);

}  // namespace foverig::dk2
