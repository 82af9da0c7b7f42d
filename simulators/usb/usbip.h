#pragma once
// USB/IP messages between a kernel's vhci-hcd and a device (Linux,
// Documentation/usb/usbip_protocol.rst): headers of 48 bytes, big-endian, with data behind them.
// Pure bytes; no isochronous transfers.
#include <cstdint>
#include <variant>
#include <vector>

#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig::usb {

inline constexpr std::size_t kHeaderSize = 48;

/// A transfer's outcome, as the kernel's errno.
inline constexpr std::int32_t kGood = 0, kStalled = -32 /* EPIPE */, kTooLong = -75 /* EOVERFLOW */,
                              kUnlinked = -104 /* ECONNRESET */;

/// The eight bytes that begin a control transfer (USB 2.0, 9.3).
struct Setup {
    std::uint8_t type = 0, request = 0;
    std::uint16_t value = 0, index = 0, length = 0;

    bool to_host() const { return (type & 0x80U) != 0; }
    bool operator==(const Setup&) const = default;
};

/// The host waits for a transfer.
struct Submit {
    std::uint32_t sequence = 0;
    std::uint8_t endpoint = 0;  ///< 0 to 15
    bool to_host = false;
    std::uint32_t length = 0;
    /// 0, or 2^32 - 1, as nothing is isochronous; the answer repeats them.
    std::uint32_t start_frame = 0, packets = 0;
    Setup setup{};  ///< of endpoint 0
};

/// The host waits no longer for the transfer `victim`.
struct Unlink {
    std::uint32_t sequence = 0, victim = 0;
};

using Command = std::variant<Submit, Unlink>;

/// Of a header; an error means that what follows cannot be understood either.
Result<Command> decode_command(Bytes header);
/// How much data follows the header.
std::size_t data_size(const Command& command);

/// The end of a transfer. `length` is how much went over; `data` only where it went to the host.
std::vector<std::byte> encode_submitted(const Submit& submit, std::int32_t status,
                                        std::size_t length, Bytes data);
/// `status`: kUnlinked, or 0 where the transfer had ended already.
std::vector<std::byte> encode_unlinked(std::uint32_t sequence, std::int32_t status);

}  // namespace foverig::usb
