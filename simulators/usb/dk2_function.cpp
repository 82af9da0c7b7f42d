#include "simulators/usb/dk2_function.h"

#include "devices/dk2/identity_reports.h"
#include "simulators/usb/descriptors.h"
#include "simulators/usb/dk2_report_descriptor.h"

namespace foverig::usb {
namespace {

constexpr std::uint8_t kHidDescriptor = 0x21, kReportDescriptor = 0x22;
constexpr std::uint8_t kFeatureReport = 3;  // high byte of wValue
constexpr std::uint8_t kFromInterface = 0x81, kClassFromInterface = 0xA1, kClassToInterface = 0x21;
constexpr std::uint8_t kGetDescriptor = 6, kGetReport = 1, kSetReport = 9, kSetIdle = 10;

std::vector<std::byte> hid_descriptor() {
    const auto size = static_cast<unsigned>(dk2_report_descriptor().size());
    return bytes_of(
        {9, kHidDescriptor, 0x10, 0x01, 0, 1, kReportDescriptor, size & 0xFFU, size >> 8U});
}

std::vector<std::byte> interface() {
    auto bytes = bytes_of({9, 4, 0, 0, 1, 3, 0, 0, 0});
    const auto hid = hid_descriptor();
    bytes.insert(bytes.end(), hid.begin(), hid.end());
    const auto endpoint = bytes_of({7, 5, 0x80U | Dk2Function::kReports, 3, 64, 0, 1});
    bytes.insert(bytes.end(), endpoint.begin(), endpoint.end());
    return bytes;
}

}  // namespace

std::string dk2_serial(Transport& device) {
    const auto bytes = device.control_get(dk2::UuidReport::kId, 0, dk2::UuidReport::kSize);
    if (!bytes) return "";
    const auto report = dk2::UuidReport::decode(*bytes);
    return report ? report->uuid : "";
}

Dk2Function::Dk2Function(Transport& device)
    : device_(device),
      descriptors_{
          .speed = Speed::full,
          .device = device_descriptor({.vendor = 0x2833, .product = 0x0021, .release = kRelease}),
          .configuration =
              configuration_descriptor({.attributes = 0xA0, .current_ma = 100}, interface()),
          .strings = {"Oculus VR, Inc.", "Rift DK2", dk2_serial(device)}} {}

std::optional<std::vector<std::byte>> Dk2Function::answer(const Setup& setup) {
    if (setup.type == kFromInterface && setup.request == kGetDescriptor) {
        if (setup.value >> 8U == kReportDescriptor) return dk2_report_descriptor();
        if (setup.value >> 8U == kHidDescriptor) return hid_descriptor();
        return std::nullopt;
    }
    const bool asks_report = setup.type == kClassFromInterface && setup.request == kGetReport &&
                             setup.value >> 8U == kFeatureReport;
    if (!asks_report) return std::nullopt;
    auto report =
        device_.control_get(static_cast<std::uint8_t>(setup.value & 0xFFU), 0, setup.length);
    if (!report) return std::nullopt;
    return std::move(report).value();
}

bool Dk2Function::take(const Setup& setup, Bytes data) {
    if (setup.type != kClassToInterface) return false;
    if (setup.request == kSetIdle) return true;  // reports come with each sample or not at all
    if (setup.request != kSetReport || setup.value >> 8U != kFeatureReport) return false;
    const auto taken = device_.control_set(static_cast<std::uint8_t>(setup.value & 0xFFU), 0, data);
    return static_cast<bool>(taken);
}

}  // namespace foverig::usb
