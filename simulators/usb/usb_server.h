#pragma once
// A USB device at one end of a socket, at whose other end a kernel's vhci-hcd is the host.
#include <atomic>
#include <map>
#include <mutex>
#include <thread>

#include "simulators/usb/control_endpoint.h"
#include "simulators/usb/file_handle.h"
#include "simulators/usb/in_queue.h"

namespace foverig::usb {

/// One thread of its own answers the host; any other may send.
class UsbServer {
  public:
    /// `socket` is a stream. `function` and `clock` outlive the server; any thread may read the
    /// clock.
    UsbServer(FileHandle socket, UsbFunction& function, const Clock& clock);
    /// Hangs up.
    ~UsbServer();

    /// A packet for the host on IN endpoint `endpoint` (1 to 15).
    void send(std::uint8_t endpoint, std::vector<std::byte> packet);
    /// False once the host has hung up.
    bool connected() const { return connected_; }
    /// Packets that nobody asked for.
    std::uint64_t unheard() const;

  private:
    void serve();
    bool read_exactly(std::span<std::byte> bytes);
    void handle(const Submit& submit, Bytes data);
    void handle(const Unlink& unlink);
    void control(const Submit& submit, Bytes data);
    void finish(const InQueue::Ended& ended);
    void write(Bytes message);

    FileHandle socket_;
    const Clock& clock_;
    ControlEndpoint control_;
    std::atomic<bool> connected_{true};
    // One mutex over taking a transfer from its queue and sending its end: an answer to an unlink
    // may not overtake the end that makes it late, or the kernel drops the device.
    mutable std::mutex mutex_;
    std::map<std::uint8_t, InQueue> queues_;
    std::thread thread_;
};

}  // namespace foverig::usb
