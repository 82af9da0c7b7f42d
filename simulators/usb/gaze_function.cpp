#include "simulators/usb/gaze_function.h"

#include "devices/gaze/requests.h"

namespace foverig::usb {
namespace {

constexpr std::uint8_t kVendorFromInterface = 0xC1, kVendorToInterface = 0x41;

std::string serial_of(Transport& device) {
    const auto bytes = device.control_get(gaze::request::get_info, 0, gaze::Info::kSize);
    if (!bytes) return "";
    const auto info = gaze::Info::decode(*bytes);
    return info ? info->serial : "";
}

}  // namespace

GazeFunction::GazeFunction(Transport& device, const DeviceIdentity& identity)
    : device_(device),
      descriptors_{.speed = Speed::high,
                   .device = device_descriptor(identity),
                   .configuration = configuration_descriptor(
                       {}, bytes_of({9, 4, 0, 0, 1, 0xFF, 0x47, 0x01, 0,  //
                                     7, 5, 0x80U | kFrames, 2, 0x00, 0x02, 0})),
                   .strings = {"LS Open", "SGZ1 gaze tracker", serial_of(device)}} {}

std::optional<std::vector<std::byte>> GazeFunction::answer(const Setup& setup) {
    if (setup.type != kVendorFromInterface || setup.index != 0) return std::nullopt;
    auto data = device_.control_get(setup.request, setup.value, setup.length);
    if (!data) return std::nullopt;
    return std::move(data).value();
}

bool GazeFunction::take(const Setup& setup, Bytes data) {
    if (setup.type != kVendorToInterface || setup.index != 0) return false;
    return static_cast<bool>(device_.control_set(setup.request, setup.value, data));
}

}  // namespace foverig::usb
