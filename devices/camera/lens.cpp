#include "devices/camera/lens.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>

namespace foverig::camera {
namespace {

constexpr std::uint32_t kMagic = 0xE2978900;
constexpr std::uint16_t kVersion = 1, kCoefficients = 9, kEntrySize = 12;
constexpr std::size_t kHeaderSize = 14;
constexpr double kNearest_m = 1e-3;

// Of entry i: 4 bytes of id and length, then the double.
constexpr std::size_t value_at(std::size_t i) {
    return kHeaderSize + i * kEntrySize + 4;
}

Error refused(const std::string& why) {
    return {ErrorCode::invalid_data, "camera calibration refused: " + why};
}

}  // namespace

std::optional<dvec2> Lens::project(const dvec3& p) const {
    if (!(p.z > kNearest_m)) return std::nullopt;
    const double x = p.x / p.z, y = p.y / p.z, r2 = x * x + y * y;
    const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    // The radius on the sensor must grow with the angle.
    if (1 + r2 * (3 * k1 + r2 * (5 * k2 + r2 * 7 * k3)) <= 0) return std::nullopt;
    const double xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
    const double yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
    return dvec2(fx_px * xd + cx_px, fy_px * yd + cy_px);
}

Result<Lens> decode_lens_block(Bytes b) {
    if (b.size() < kLensBlockSize) return refused(fmt::format("only {} bytes", b.size()));
    if (read_u32(b, 0) != kMagic || read_u16(b, 4) != kLensBlockSize ||
        read_u16(b, 6) != kVersion || read_u16(b, 8) != kCoefficients) {
        return refused(fmt::format("magic {:#010x}, length {}, version {}, {} coefficients",
                                   read_u32(b, 0), read_u16(b, 4), read_u16(b, 6), read_u16(b, 8)));
    }
    std::array<double, kCoefficients> v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (read_u16(b, value_at(i) - 2) != kEntrySize) {
            return refused(fmt::format("entry {} is not of 12 bytes", i));
        }
        v[i] = std::bit_cast<double>(read_u64(b, value_at(i)));
        if (!std::isfinite(v[i])) return refused(fmt::format("entry {} is no number", i));
    }
    if (v[0] <= 0 || v[1] <= 0) return refused("a focal length is not above 0");
    return Lens{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]};
}

std::vector<std::byte> encode_lens_block(const Lens& lens) {
    std::vector<std::byte> b(kLensBlockSize);
    write_u32(b, 0, kMagic);
    write_u16(b, 4, kLensBlockSize);
    write_u16(b, 6, kVersion);
    write_u16(b, 8, kCoefficients);
    const std::array values{lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px, lens.k1,
                            lens.k2,    lens.p1,    lens.p2,    lens.k3};
    for (std::size_t i = 0; i < values.size(); ++i) {
        write_u16(b, value_at(i) - 4, static_cast<std::uint16_t>(i));
        write_u16(b, value_at(i) - 2, kEntrySize);
        write_u64(b, value_at(i), std::bit_cast<std::uint64_t>(values[i]));
    }
    return b;
}

}  // namespace foverig::camera
