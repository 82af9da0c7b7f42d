#include "simulators/usb/usbip.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig::usb {
namespace {

constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinkedAnswer = 4;
constexpr std::uint32_t kNoPackets = 0xFFFFFFFF;
// The kernel asks for no transfer larger than this; a header beyond it is not one.
constexpr std::uint32_t kLargestTransfer = 16U << 20U;

std::uint32_t word(Bytes header, std::size_t index) {
    const std::uint32_t little = read_u32(header, 4 * index);
    return little >> 24U | (little >> 8U & 0xFF00U) | (little << 8U & 0xFF0000U) | little << 24U;
}

void write_word(std::span<std::byte> header, std::size_t index, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        header[4 * index + i] = static_cast<std::byte>(value >> (24 - 8 * i) & 0xFFU);
    }
}

Error strange(const char* what, std::uint32_t value) {
    return {
        ErrorCode::invalid_data,
        fmt::format("USB/IP: {} {} in a header; the kernel speaks another protocol", what, value)};
}

}  // namespace

Result<Command> decode_command(Bytes header) {
    if (header.size() != kHeaderSize) return strange("size", kHeaderSize);
    const std::uint32_t command = word(header, 0), sequence = word(header, 1);
    if (command == kUnlink) return Command(Unlink{.sequence = sequence, .victim = word(header, 5)});
    if (command != kSubmit) return strange("command", command);
    if (word(header, 3) > 1) return strange("direction", word(header, 3));
    if (word(header, 4) > 15) return strange("endpoint", word(header, 4));
    if (word(header, 6) > kLargestTransfer) return strange("length", word(header, 6));
    const std::uint32_t packets = word(header, 8);
    if (packets != 0 && packets != kNoPackets) return strange("isochronous packets", packets);
    return Command(Submit{.sequence = sequence,
                          .endpoint = static_cast<std::uint8_t>(word(header, 4)),
                          .to_host = word(header, 3) == 1,
                          .length = word(header, 6),
                          .start_frame = word(header, 7),
                          .packets = packets,
                          .setup = {.type = read_u8(header, 40),
                                    .request = read_u8(header, 41),
                                    .value = read_u16(header, 42),
                                    .index = read_u16(header, 44),
                                    .length = read_u16(header, 46)}});
}

std::size_t data_size(const Command& command) {
    const auto* submit = std::get_if<Submit>(&command);
    return submit != nullptr && !submit->to_host ? submit->length : 0;
}

std::vector<std::byte> encode_submitted(const Submit& submit, std::int32_t status,
                                        std::size_t length, Bytes data) {
    std::vector<std::byte> message(kHeaderSize + data.size());
    write_word(message, 0, kSubmitted);
    write_word(message, 1, submit.sequence);
    write_word(message, 5, static_cast<std::uint32_t>(status));
    write_word(message, 6, static_cast<std::uint32_t>(length));
    write_word(message, 7, submit.start_frame);
    write_word(message, 8, submit.packets);
    std::copy(data.begin(), data.end(), message.begin() + kHeaderSize);
    return message;
}

std::vector<std::byte> encode_unlinked(std::uint32_t sequence, std::int32_t status) {
    std::vector<std::byte> message(kHeaderSize);
    write_word(message, 0, kUnlinkedAnswer);
    write_word(message, 1, sequence);
    write_word(message, 5, static_cast<std::uint32_t>(status));
    return message;
}

}  // namespace foverig::usb
