#pragma once
// A HID device made through /dev/uhid: the kernel's hid core and hidraw above it, no USB below.
#include <atomic>
#include <string>
#include <thread>

#include "devices/transport.h"
#include "simulators/usb/face.h"
#include "simulators/usb/file_handle.h"

struct uhid_event;

namespace foverig::usb {

struct HidIdentity {
    std::uint16_t vendor = 0, product = 0, release = 0;
    std::string name, serial;
    std::vector<std::byte> report_descriptor;
};

/// One thread of its own answers feature reports, which the kernel waits for.
class UhidFace final : public Face {
  public:
    static constexpr const char* kNode = "/dev/uhid";

    /// `device` gives and takes feature reports; it outlives the face and is safe for threads.
    /// Errors: not_found (no such module), forbidden, io.
    static Result<std::unique_ptr<Face>> plug_in(Transport& device, const HidIdentity& identity);
    ~UhidFace() override;

    /// Dropped while no program has the device open.
    void send(std::vector<std::byte> packet) override;
    bool connected() const override { return connected_; }

  private:
    UhidFace(FileHandle uhid, Transport& device);

    void serve(const std::stop_token& stop);
    void handle(const uhid_event& event);
    void give_report(const uhid_event& asked);
    void take_report(const uhid_event& given);
    bool write(const uhid_event& event, std::size_t size) const;

    FileHandle uhid_;
    Transport& device_;
    std::atomic<bool> connected_{true}, opened_{false};
    std::jthread thread_;  // last: stops first
};

}  // namespace foverig::usb
