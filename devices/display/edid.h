#pragma once
// Who a display says it is: the first block of its EDID (VESA E-EDID 1.4).
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "devices/result.h"

namespace foverig {

struct Edid {
    std::string maker;          ///< three letters; the DK2's is OVR
    std::uint16_t product = 0;  ///< the DK2's is 3, or 4 (DEVICES.md 2.3)
    std::string name;           ///< empty: it gives none
};

/// Checks header and checksum.
Result<Edid> parse_edid(std::span<const std::byte> bytes);

/// An Oculus headset, which Linux keeps from the desktop (EDID_QUIRK_NON_DESKTOP, drm_edid.c).
inline bool is_oculus(const Edid& edid) {
    return edid.maker == "OVR";
}

}  // namespace foverig
