#pragma once
// One plugged-in device, as a kernel knows it: plugged in when made, unplugged at its end.
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "devices/result.h"

namespace foverig::usb {

class Face {
  public:
    virtual ~Face() = default;
    /// An input report or a frame, as its model made it.
    virtual void send(std::vector<std::byte> packet) = 0;
    /// Packets, or their parts, that the kernel did not ask for in time.
    virtual std::uint64_t unheard() const { return 0; }
    /// False once the kernel's side has hung up: somebody detached the device there.
    virtual bool connected() const = 0;
};

using PlugIn = std::function<Result<std::unique_ptr<Face>>()>;

}  // namespace foverig::usb
