#pragma once
// The tracker camera's lens: a pinhole with Brown's distortion, as its EEPROM holds it
// (DEVICES.md 1.8.4). Camera frame: x right, y down, z ahead; pixel (0, 0) is a pixel's centre.
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
    bool operator==(const Lens&) const = default;
};

/// The EEPROM's calibration block. The polynomial of its CRC is not known: the CRC is not checked,
/// and written as 0; magic, length, version and entry lengths are.
inline constexpr std::size_t kLensBlockSize = 122;
Result<Lens> decode_lens_block(Bytes block);
std::vector<std::byte> encode_lens_block(const Lens& lens);

}  // namespace foverig::camera
