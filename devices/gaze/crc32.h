#pragma once
// CRC-32/ISO-HDLC (reflected 0xEDB88320, init and final XOR 0xFFFFFFFF; DEVICES.md 4.5.2).
#include <cstdint>

#include "devices/bytes.h"

namespace foverig::gaze {

/// Of "123456789": 0xCBF43926.
std::uint32_t crc32(Bytes bytes);

}  // namespace foverig::gaze
