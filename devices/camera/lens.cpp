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

constexpr double kFarthest2 = 1e4;  // where a fold is looked for: to 89 degrees off the axis
constexpr int kInverseSteps = 50;
constexpr double kInverse_px = 1e-6;

/// How fast the radius on the sensor grows with the tangent, by its square.
double growth(const Lens& lens, double r2) {
    return 1 + r2 * (3 * lens.k1 + r2 * (5 * lens.k2 + r2 * 7 * lens.k3));
}

/// It grows from the axis to there: at the end, and where growth is least on the way.
bool grows_until(const Lens& lens, double r2) {
    if (!(growth(lens, r2) > 0)) return false;
    // Of growth's slope by the square: a + b s + c s^2.
    const double a = 3 * lens.k1, b = 10 * lens.k2, c = 21 * lens.k3;
    const double inside = b * b - 4 * a * c;
    if (inside < 0 || (b == 0 && c == 0)) return true;
    const double q = -0.5 * (b + std::copysign(std::sqrt(inside), b));
    for (const double s : {q / c, a / q}) {
        if (s > 0 && s < r2 && !(growth(lens, s) > 0)) return false;
    }
    return true;
}

Error refused(const std::string& why) {
    return {ErrorCode::invalid_data, "camera calibration refused: " + why};
}

}  // namespace

std::optional<dvec2> Lens::project(const dvec3& p) const {
    if (!(p.z > kNearest_m)) return std::nullopt;
    const double x = p.x / p.z, y = p.y / p.z, r2 = x * x + y * y;
    const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    if (!grows_until(*this, r2)) return std::nullopt;
    const double xd = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x);
    const double yd = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
    return dvec2(fx_px * xd + cx_px, fy_px * yd + cy_px);
}

// Newton's method on the distortion, with the derivatives of Brown's formulas.
std::optional<dvec3> Lens::ray_at(const dvec2& pixel) const {
    dvec2 at((pixel.x - cx_px) / fx_px, (pixel.y - cy_px) / fy_px), good(0);
    for (int i = 0; i < kInverseSteps; ++i) {
        const auto seen = project({at, 1.0});
        if (!seen) {  // a step too far, beyond the fold
            at = 0.5 * (at + good);
            continue;
        }
        good = at;
        const dvec2 off((pixel.x - seen->x) / fx_px, (pixel.y - seen->y) / fy_px);
        if (std::hypot(off.x * fx_px, off.y * fy_px) < kInverse_px) return dvec3(at, 1.0);
        const double x = at.x, y = at.y, r2 = x * x + y * y;
        const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
        const double bend = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3));  // of `radial`, by x over x
        const double xx = radial + x * x * bend + 2 * p1 * y + 6 * p2 * x;
        const double xy = x * y * bend + 2 * p1 * x + 2 * p2 * y;
        const double yy = radial + y * y * bend + 6 * p1 * y + 2 * p2 * x;
        const double size = xx * yy - xy * xy;
        if (!(size > 0)) return std::nullopt;
        at += dvec2(yy * off.x - xy * off.y, xx * off.y - xy * off.x) / size;
    }
    return std::nullopt;
}

double Lens::fold_tangent() const {
    double grows = 0, folds = kFarthest2;
    if (grows_until(*this, folds)) return HUGE_VAL;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (grows + folds);
        (grows_until(*this, middle) ? grows : folds) = middle;
    }
    return std::sqrt(grows);
}

Lens ideal_lens(int width_px, int height_px, double fov_deg) {
    const double focal_px = 0.5 * width_px / std::tan(0.5 * glm::radians(fov_deg));
    return {.fx_px = focal_px,
            .fy_px = focal_px,
            .cx_px = 0.5 * (width_px - 1),
            .cy_px = 0.5 * (height_px - 1)};
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
