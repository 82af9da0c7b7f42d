#include "devices/dk2/packed_triple.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/devices/byte_text.h"

namespace foverig::dk2 {
namespace {

using test::bytes_of;
using test::copy_of;

struct Vector {
    Triple triple;
    const char* hex;
};

// DEVICES.md 1.2.1.
const Vector kVectors[] = {
    {{1, 0, 0}, "00 00 08 00 00 00 00 00"},
    {{0, 1, 0}, "00 00 00 00 00 40 00 00"},
    {{0, 0, 1}, "00 00 00 00 00 00 00 02"},
    {{-1, -1, -1}, "FF FF FF FF FF FF FF FE"},
    {{0, 98066, 0}, "00 00 00 5F C4 80 00 00"},
    {{1048575, -1048576, 12345}, "7F FF FC 00 00 00 60 72"},
    {{-2617, 17453, -349}, "FF AE 38 11 0B 7F FD 46"},
};

TEST(PackedTriple, ReadsTheTestVectors) {
    for (const Vector& v : kVectors) EXPECT_EQ(read_triple(bytes_of(v.hex), 0), v.triple) << v.hex;
}

TEST(PackedTriple, WritesTheTestVectors) {
    for (const Vector& v : kVectors) {
        std::array<std::byte, 8> b{};
        write_triple(b, 0, v.triple);
        EXPECT_EQ(copy_of(b), bytes_of(v.hex)) << v.hex;
    }
}

TEST(PackedTriple, RoundTripsEveryValueOfARange) {
    test::Random random(1);
    const auto value = [&] {
        return static_cast<std::int32_t>(random.bits() % (1u << 21)) + kTripleMin;
    };
    for (int i = 0; i < 20000; ++i) {
        const Triple t{value(), value(), value()};
        std::array<std::byte, 8> b{};
        write_triple(b, 0, t);
        ASSERT_EQ(read_triple(b, 0), t);
    }
}

TEST(PackedTriple, SaturatesBeyond21Bits) {
    std::array<std::byte, 8> b{};
    write_triple(b, 0, {2000000, -2000000, 1 << 21});
    EXPECT_EQ(read_triple(b, 0), (Triple{kTripleMax, kTripleMin, kTripleMax}));
}

TEST(PackedTriple, ConvertsToTheNearestStep) {
    EXPECT_EQ(from_si({9.80668, -0.00004, 0.00006}), (Triple{98067, 0, 1}));
    EXPECT_EQ(from_si({1e9, -1e9, std::numeric_limits<double>::quiet_NaN()}),
              (Triple{kTripleMax, kTripleMin, 0}));
    EXPECT_DOUBLE_EQ(to_si({0, 98066, 0}).y, 9.8066);
}

}  // namespace
}  // namespace foverig::dk2
