#pragma once
// CRC-32/ISO-HDLC (reflected 0xEDB88320, init and final XOR 0xFFFFFFFF): of SGZ1 frames
// (DEVICES.md 4.5.2) and of MCAP files.
#include <cstdint>

#include "devices/bytes.h"

namespace foverig {

/// Of "123456789": 0xCBF43926. `before` is the CRC of what came before `bytes`, 0 at the start.
std::uint32_t crc32(Bytes bytes, std::uint32_t before = 0);

}  // namespace foverig
