#include "simulators/usb/camera_descriptors.h"

#include <string_view>
#include <utility>

#include "devices/camera/esp570.h"

namespace foverig::usb {
namespace {

constexpr unsigned kClassInterface = 0x24;
constexpr unsigned kInputTerminal = 1, kOutputTerminal = 3;

constexpr std::string_view kUnitGuid("foverig eSP570  ", 16);
// USB Video Class, Uncompressed Payload 1.0, table 2-1.
constexpr std::string_view kYuy2Guid("YUY2\x00\x00\x10\x00\x80\x00\x00\xAA\x00\x38\x9B\x71", 16);

unsigned byte_of(std::uint32_t value, int index) {
    return value >> (8 * index) & 0xFFU;
}

void append(std::vector<std::byte>& out, const std::vector<std::byte>& bytes) {
    out.insert(out.end(), bytes.begin(), bytes.end());
}

void append(std::vector<std::byte>& out, std::string_view guid) {
    for (const char c : guid) out.push_back(static_cast<std::byte>(c));
}

/// A class header and what follows it; the header's wTotalLength lies at `length_at`.
std::vector<std::byte> with_total_length(std::vector<std::byte> all, std::size_t length_at) {
    all[length_at] = static_cast<std::byte>(byte_of(static_cast<std::uint32_t>(all.size()), 0));
    all[length_at + 1] = static_cast<std::byte>(byte_of(static_cast<std::uint32_t>(all.size()), 1));
    return all;
}

std::vector<std::byte> video_control(const CameraTraits& camera) {
    auto all = bytes_of({13, kClassInterface, 1, 0x00, 0x01, 0, 0, 0x80, 0x8D, 0x5B, 0x00, 1, 1});
    append(all, bytes_of({18, kClassInterface, 2, kInputTerminal, 0x01, 0x02, 0, 0, 0, 0, 0, 0, 0,
                          0, 3, 0, 0, 0}));
    unsigned source = kInputTerminal;
    if (camera.extension_unit) {  // controls 2, 3 and 5 of the bridge chip
        append(all, bytes_of({26, kClassInterface, 6, camera::kExtensionUnit}));
        append(all, kUnitGuid);
        append(all, bytes_of({3, 1, kInputTerminal, 1, 0x16, 0}));
        source = camera::kExtensionUnit;
    }
    append(all, bytes_of({9, kClassInterface, 3, kOutputTerminal, 0x01, 0x01, 0, source, 0}));
    return with_total_length(std::move(all), 5);
}

/// A format of one frame size, and the subtype of its frame descriptor (UVC 1.0, Uncompressed
/// Payload, table 3-1; MJPEG Payload, table 3-1).
std::pair<std::vector<std::byte>, unsigned> stream_format(const CameraTraits& camera) {
    if (camera.jpeg) return {bytes_of({11, kClassInterface, 6, 1, 1, 0, 1, 0, 0, 0, 0}), 7};
    auto format = bytes_of({27, kClassInterface, 4, 1, 1});
    append(format, kYuy2Guid);
    append(format, bytes_of({16, 1, 0, 0, 0, 0}));
    return {format, 5};
}

std::vector<std::byte> video_streaming(const CameraTraits& camera) {
    auto all = bytes_of({14, kClassInterface, 1, 1, 0, 0, 0x80U | kCameraFrames, 0, kOutputTerminal,
                         0, 0, 0, 1, 0});
    const auto [format, frame_subtype] = stream_format(camera);
    append(all, format);
    constexpr std::uint64_t kUnits_s = 10'000'000;  // of an interval
    const auto bits_s =
        static_cast<std::uint32_t>(camera.frame_bytes() * 8U * kUnits_s / camera.interval);
    auto frame = bytes_of({30, kClassInterface, frame_subtype, 1, 0, byte_of(camera.width_px, 0),
                           byte_of(camera.width_px, 1), byte_of(camera.height_px, 0),
                           byte_of(camera.height_px, 1)});
    const auto append_word = [&](std::uint32_t word) {
        for (int i = 0; i < 4; ++i) frame.push_back(static_cast<std::byte>(byte_of(word, i)));
    };
    append_word(bits_s);
    append_word(bits_s);
    append_word(camera.frame_bytes());
    append_word(camera.interval);
    frame.push_back(std::byte{1});
    append_word(camera.interval);
    append(all, frame);
    return with_total_length(std::move(all), 4);
}

}  // namespace

std::uint16_t extension_size(std::uint8_t selector) {
    switch (selector) {
        case camera::i2c::kSelector:
            return static_cast<std::uint16_t>(std::tuple_size_v<camera::i2c::Buffer>);
        case 3:  // of two words whose meaning is not known; 3 or 4: the driver has to ask
            return 3;
        case camera::eeprom::kSelector:
            return static_cast<std::uint16_t>(std::tuple_size_v<camera::eeprom::Buffer>);
        default:
            return 0;
    }
}

CameraTraits dk2_camera() {
    return {.vendor = 0x2833,
            .product = 0x0201,
            .strings = {"Oculus VR, Inc.", "Positional Tracker DK2", "FOVERIGSIMCAMERA"},
            .width_px = 376,
            .height_px = 480,
            .interval = 166'667,
            .extension_unit = true};
}

CameraTraits room_camera() {
    return {.vendor = 0x1209,
            .product = 0x0003,
            .strings = {"LS Open", "foverig room camera", "FOVERIGSIMROOM"},
            .width_px = 640,
            .height_px = 480,
            .interval = 333'333};
}

std::vector<std::byte> camera_interfaces(const CameraTraits& camera) {
    constexpr unsigned kVideo = 0x0E;
    auto all = bytes_of({8, 0x0B, 0, 2, kVideo, 3, 0, 0});  // the two belong together
    append(all, bytes_of({9, 4, 0, 0, 0, kVideo, 1, 0, 0}));
    append(all, video_control(camera));
    append(all, bytes_of({9, 4, 1, 0, 1, kVideo, 2, 0, 0}));
    append(all, video_streaming(camera));
    append(all, bytes_of({7, 5, 0x80U | kCameraFrames, 2, 0x00, 0x02, 0}));
    return all;
}

}  // namespace foverig::usb
