#pragma once
// What a device is to its host: descriptors, and answers to control requests.
#include <array>
#include <optional>
#include <string>

#include "simulators/usb/usbip.h"

namespace foverig::usb {

enum class Speed : std::uint8_t { full = 2, high = 3 };  ///< as the kernel numbers them

struct Descriptors {
    Speed speed = Speed::high;
    std::vector<std::byte> device;         ///< 18 bytes
    std::vector<std::byte> configuration;  ///< with all that belongs to it
    std::array<std::string, 3> strings;    ///< 1 manufacturer, 2 product, 3 serial; ASCII
};

class UsbFunction {
  public:
    virtual ~UsbFunction() = default;

    virtual const Descriptors& descriptors() const = 0;
    /// A class or vendor request, or one to an interface. Nothing: it stalls. What is longer than
    /// `setup.length` is cut.
    virtual std::optional<std::vector<std::byte>> answer(const Setup& setup) = 0;
    /// The same with data to the device; false: it stalls.
    virtual bool take(const Setup& setup, Bytes data) = 0;
    /// What goes over for one packet of the model, transfer by transfer: itself, or its parts.
    virtual std::vector<std::vector<std::byte>> transfers(std::vector<std::byte> packet) {
        std::vector<std::vector<std::byte>> one;
        one.push_back(std::move(packet));
        return one;
    }
};

}  // namespace foverig::usb
