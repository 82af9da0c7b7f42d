#include "simulators/usb/camera_function.h"

#include <algorithm>

#include "devices/camera/esp570.h"
#include "devices/camera/frame.h"

namespace foverig::usb {
namespace {

constexpr std::uint8_t kFromInterface = 0xA1, kToInterface = 0x21;
constexpr std::uint8_t kSetCurrent = 0x01, kGetCurrent = 0x81, kGetLength = 0x85, kGetInfo = 0x86;
constexpr std::uint8_t kProbe = 1, kCommit = 2, kErrorCode = 2;
constexpr std::uint16_t kControlInterface = 0, kStreamingInterface = 1;
constexpr std::size_t kProbeSize = 26, kPayloadHeader = 2;
constexpr unsigned kReadsAndWrites = 3, kInvalidControl = 6;

/// The only stream there is, whatever is asked for (UVC 1.0, table 4-47).
std::vector<std::byte> only_stream(const CameraTraits& camera) {
    std::vector<std::byte> bytes(kProbeSize);
    write_u8(bytes, 2, 1);
    write_u8(bytes, 3, 1);
    write_u32(bytes, 4, camera.interval);
    write_u32(bytes, 18, camera.frame_bytes());
    write_u32(bytes, 22, kCameraPayload);
    return bytes;
}

std::uint8_t selector_of(const Setup& setup) {
    return static_cast<std::uint8_t>(setup.value >> 8U);
}

}  // namespace

CameraFunction::CameraFunction(Transport& device, const CameraTraits& traits)
    : device_(device),
      traits_(traits),
      descriptors_{.speed = Speed::high,
                   .device = device_descriptor({.vendor = traits.vendor,
                                                .product = traits.product,
                                                .device_class = {0xEF, 0x02, 0x01}}),
                   .configuration = configuration_descriptor({.interfaces = 2, .current_ma = 500},
                                                             camera_interfaces(traits)),
                   .strings = traits.strings} {}

bool CameraFunction::is_extension(const Setup& setup) const {
    return traits_.extension_unit &&
           setup.index == (camera::kExtensionUnit << 8U | kControlInterface);
}

std::optional<std::vector<std::byte>> CameraFunction::answer(const Setup& setup) {
    if (setup.type != kFromInterface) return std::nullopt;
    if (setup.index == kStreamingInterface) {
        if (selector_of(setup) != kProbe && selector_of(setup) != kCommit) return std::nullopt;
        if (setup.request == kGetLength) return bytes_of({kProbeSize, 0});
        if (setup.request == kGetInfo) return bytes_of({kReadsAndWrites});
        return only_stream(traits_);
    }
    if (setup.index == kControlInterface && selector_of(setup) == kErrorCode) {
        return bytes_of({kInvalidControl});  // the kernel asks why a request stalled
    }
    return is_extension(setup) ? answer_unit(setup) : std::nullopt;
}

std::optional<std::vector<std::byte>> CameraFunction::answer_unit(const Setup& setup) {
    const std::uint16_t size = extension_size(selector_of(setup));
    if (size == 0) return std::nullopt;
    switch (setup.request) {
        case kGetLength:
            return bytes_of({size, 0});
        case kGetInfo:
            return bytes_of({kReadsAndWrites});
        case kGetCurrent: {
            auto data = device_.control_get(selector_of(setup), camera::kExtensionUnit, size);
            if (!data) return std::nullopt;
            return std::move(data).value();
        }
        default:
            return std::vector<std::byte>(size);
    }
}

bool CameraFunction::take(const Setup& setup, Bytes data) {
    if (setup.type != kToInterface || setup.request != kSetCurrent) return false;
    if (setup.index == kStreamingInterface) {
        if (selector_of(setup) == kCommit) streams_ = true;
        return selector_of(setup) == kProbe || selector_of(setup) == kCommit;
    }
    return is_extension(setup) &&
           device_.control_set(selector_of(setup), camera::kExtensionUnit, data);
}

std::vector<std::vector<std::byte>> CameraFunction::transfers(std::vector<std::byte> packet) {
    constexpr std::uint8_t kEndOfHeader = 0x80, kEndOfFrame = 0x02;
    std::vector<std::vector<std::byte>> payloads;
    const auto header = camera::decode_any_header(packet);
    if (!streams_ || !header) return payloads;
    Bytes image = Bytes(packet).subspan(camera::FrameHeader::kSize, header->image_bytes);
    frame_id_ ^= 1;
    while (!image.empty()) {
        const std::size_t size =
            std::min<std::size_t>(image.size(), kCameraPayload - kPayloadHeader);
        const bool last = size == image.size();
        std::vector<std::byte> payload(kPayloadHeader + size);
        write_u8(payload, 0, kPayloadHeader);
        write_u8(payload, 1,
                 static_cast<std::uint8_t>(kEndOfHeader | frame_id_ | (last ? kEndOfFrame : 0)));
        std::copy_n(image.begin(), size, payload.begin() + kPayloadHeader);
        payloads.push_back(std::move(payload));
        image = image.subspan(size);
    }
    return payloads;
}

}  // namespace foverig::usb
