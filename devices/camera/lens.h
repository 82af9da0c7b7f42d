#pragma once
// A camera's lens: a pinhole with Brown's distortion, as the tracker camera's EEPROM holds it
// (DEVICES.md 1.8.4) and OpenCV calibrates it. Camera frame: x right, y down, z ahead; pixel (0, 0)
// is a pixel's centre.
#include <optional>
#include <vector>

#include "devices/bytes.h"
#include "devices/math.h"
#include "devices/result.h"

namespace foverig::camera {

struct Lens {
    double fx_px = 536.98, fy_px = 536.98;  ///< 70 degrees across 752 pixels, the design's target
    double cx_px = 375.5, cy_px = 239.5;
    double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;

    /// Nothing for points behind the camera, or so far out that the distortion folds back.
    std::optional<dvec2> project(const dvec3& camera_m) const;
    /// The inverse: the direction that falls on a pixel, with z = 1. Nothing where none does.
    std::optional<dvec3> ray_at(const dvec2& pixel) const;
    /// The tangent of the angle from the axis at which the distortion first folds back; infinite
    /// where it does not.
    double fold_tangent() const;
    bool operator==(const Lens&) const = default;
};

/// Without distortion: a field of view across the picture's width, the axis in its middle.
Lens ideal_lens(int width_px, int height_px, double fov_deg);

/// The EEPROM's calibration block. The polynomial of its CRC is not known: the CRC is not checked,
/// and written as 0; magic, length, version and entry lengths are.
inline constexpr std::size_t kLensBlockSize = 122;
Result<Lens> decode_lens_block(Bytes block);
std::vector<std::byte> encode_lens_block(const Lens& lens);

}  // namespace foverig::camera
