#include "devices/crc32.h"

namespace foverig {
namespace {

constexpr std::size_t kSlice = 8;
using Table = std::array<std::uint32_t, 256>;

/// tables[k] steps a byte over k more bytes of zeros, so that eight bytes take one step (Kounavis
/// and Berry 2005, slicing by 8).
constexpr std::array<Table, kSlice> make_tables() {
    std::array<Table, kSlice> tables{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t rest = i;
        for (int bit = 0; bit < 8; ++bit)
            rest = (rest >> 1) ^ ((rest & 1u) != 0 ? 0xEDB88320u : 0u);
        tables[0][i] = rest;
    }
    for (std::size_t k = 1; k < kSlice; ++k) {
        for (std::size_t i = 0; i < 256; ++i) {
            const std::uint32_t one_less = tables[k - 1][i];
            tables[k][i] = (one_less >> 8) ^ tables[0][one_less & 0xFFu];
        }
    }
    return tables;
}

constexpr std::array<Table, kSlice> kTables = make_tables();

}  // namespace

std::uint32_t crc32(Bytes bytes, std::uint32_t before) {
    std::uint32_t crc = before ^ 0xFFFFFFFFu;
    std::size_t at = 0;
    for (; at + kSlice <= bytes.size(); at += kSlice) {
        const std::uint64_t mixed = read_u64(bytes, at) ^ crc;
        crc = 0;
        for (std::size_t i = 0; i < kSlice; ++i) {
            crc ^= kTables[kSlice - 1 - i][(mixed >> (8 * i)) & 0xFFu];
        }
    }
    for (; at < bytes.size(); ++at) {
        crc = (crc >> 8) ^ kTables[0][(crc ^ read_u8(bytes, at)) & 0xFFu];
    }
    return crc ^ 0xFFFFFFFFu;
}

}  // namespace foverig
