#include "simulators/usb/usbip.h"

#include <gtest/gtest.h>

#include "tests/devices/byte_text.h"

namespace foverig::usb {
namespace {

using test::bytes_of;

// Linux, Documentation/usb/usbip_protocol.rst: the example captured from the wire.
constexpr const char* kInterruptIn =
    "00000001 00000d05 0001000f 00000001 00000001 00000200 00000040 ffffffff 00000000 00000004 "
    "00000000 00000000";
constexpr const char* kInterruptOut =
    "00000001 00000d06 0001000f 00000000 00000001 00000000 00000040 ffffffff 00000000 00000004 "
    "00000000 00000000";
constexpr const char* kInterruptOutEnded =
    "00000003 00000d06 00000000 00000000 00000000 00000000 00000040 ffffffff 00000000 00000000 "
    "00000000 00000000";
constexpr const char* kInterruptInEnded =
    "00000003 00000d05 00000000 00000000 00000000 00000000 00000040 ffffffff 00000000 00000000 "
    "00000000 00000000 ffffffff860011a784ce5ae2123763612891b10201000004000000000000"
    "00000000000000000000000000000000000000000000000000000000000000000000";

Submit submit_of(const char* text) {
    auto header = bytes_of(text);
    const auto command = decode_command(header);
    EXPECT_TRUE(command);
    return std::get<Submit>(*command);
}

TEST(Usbip, ReadsTheDocumentedSubmits) {
    const Submit in = submit_of(kInterruptIn);
    EXPECT_EQ(in.sequence, 0xd05u);
    EXPECT_EQ(in.endpoint, 1);
    EXPECT_TRUE(in.to_host);
    EXPECT_EQ(in.length, 64u);
    EXPECT_EQ(data_size(in), 0u);

    const Submit out = submit_of(kInterruptOut);
    EXPECT_FALSE(out.to_host);
    EXPECT_EQ(data_size(out), 64u);
}

TEST(Usbip, WritesTheDocumentedAnswers) {
    const auto in = bytes_of(kInterruptInEnded);
    EXPECT_EQ(encode_submitted(submit_of(kInterruptIn), kGood, 64, Bytes(in).subspan(kHeaderSize)),
              in);
    EXPECT_EQ(encode_submitted(submit_of(kInterruptOut), kGood, 64, {}),
              bytes_of(kInterruptOutEnded));
}

TEST(Usbip, ReadsASetupInTheBytesOrderOfUsb) {
    // GET_DESCRIPTOR of string 2, 255 bytes (USB 2.0, table 9-3), little-endian in a big-endian
    // header.
    auto header = bytes_of(
        "00000001 00000007 00010002 00000001 00000000 00000200 000000ff 00000000 00000000 00000000 "
        "8006020309 04ff00");
    const auto command = decode_command(header);
    ASSERT_TRUE(command);
    EXPECT_EQ(
        std::get<Submit>(*command).setup,
        (usb::Setup{.type = 0x80, .request = 6, .value = 0x0302, .index = 0x0409, .length = 255}));
}

TEST(Usbip, ReadsAndAnswersAnUnlink) {
    const auto header = bytes_of(
        "00000002 00000011 00010002 00000000 00000000 00000010 00000000 00000000 00000000 00000000 "
        "00000000 00000000");
    const auto command = decode_command(header);
    ASSERT_TRUE(command);
    EXPECT_EQ(std::get<Unlink>(*command).victim, 0x10u);
    // The documentation's -ECONNRESET is 104 in Linux' errno.h.
    EXPECT_EQ(encode_unlinked(0x11, kUnlinked),
              bytes_of("00000004 00000011 00000000 00000000 00000000 ffffff98 00000000 00000000 "
                       "00000000 00000000 00000000 00000000"));
}

TEST(Usbip, RefusesWhatIsNoHeader) {
    auto header = bytes_of(kInterruptIn);
    const auto with = [&](std::size_t at, std::byte value) {
        auto changed = header;
        changed[at] = value;
        return decode_command(changed);
    };
    EXPECT_FALSE(with(3, std::byte{5}));      // command
    EXPECT_FALSE(with(15, std::byte{2}));     // direction
    EXPECT_FALSE(with(19, std::byte{16}));    // endpoint
    EXPECT_FALSE(with(24, std::byte{0x7F}));  // 2 GB
    EXPECT_FALSE(with(35, std::byte{9}));     // isochronous
    EXPECT_FALSE(decode_command(Bytes(header).first(47)));
}

}  // namespace
}  // namespace foverig::usb
