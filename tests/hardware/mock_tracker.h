#pragma once
#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>

#include "devices/bytes.h"
#include "devices/result.h"
#include "tests/hardware/mock_bed.h"

namespace foverig::test {

/// A gaze tracker as libusb sees one in usbfs: one vendor interface with bulk endpoint 0x81.
class MockTracker : public IoctlNode {
  public:
    struct Request {
        std::uint8_t type, id;
        std::uint16_t value, index;
        std::vector<std::byte> data;
    };
    /// What is answered to a request to the host; nullopt: the device stalls.
    std::function<std::optional<std::vector<std::byte>>(const Request&)> answer;
    bool claimed_by_another = false;
    std::atomic<bool> stays_halted = false;

    explicit MockTracker(MockBed& bed) : bed_(bed) {
        bed.add(
            fmt::format("P: {0}\nN: bus/usb/001/002\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
                        "E: DEVNAME={1}\nE: BUSNUM=001\nE: DEVNUM=002\n"
                        "A: busnum=1\\n\nA: devnum=2\\n\nA: bConfigurationValue=1\\n\n"
                        "A: speed=480\\n\nH: descriptors={2}\n",
                        kPath, kNode, kDescriptors));
        attach(bed, kNode);
    }
    ~MockTracker() override { detach(bed_, kNode); }

    static constexpr const char* kNode = "/dev/bus/usb/001/002";

    /// Ends the oldest transfer that waits for a frame; false where none waits or the
    /// endpoint is halted.
    bool send(std::span<const std::byte> frame) {
        const std::lock_guard lock(mutex_);
        if (halted_ || waiting_.empty()) return false;
        finish(waiting_.front(), 0, frame);
        waiting_.pop_front();
        return true;
    }
    /// The endpoint halts: the oldest transfer ends so, and each that is given to it until somebody
    /// clears it.
    bool halt() {
        const std::lock_guard lock(mutex_);
        if (waiting_.empty()) return false;
        halted_ = true;
        finish(waiting_.front(), -EPIPE, {});
        waiting_.pop_front();
        return true;
    }
    int clears() const {
        const std::lock_guard lock(mutex_);
        return clears_;
    }
    std::size_t waiting() const {
        const std::lock_guard lock(mutex_);
        return waiting_.size();
    }
    std::vector<Request> requests() const {
        const std::lock_guard lock(mutex_);
        return requests_;
    }
    void unplug() {
        {
            // A kernel ends the transfers first; they can still be reaped.
            const std::lock_guard lock(mutex_);
            for (const Urb& u : waiting_) finish(u, -ESHUTDOWN, {});
            waiting_.clear();
            gone_ = true;
        }
        umockdev_testbed_remove_device(bed_.get(), (std::string("/sys") + kPath).c_str());
    }

  private:
    struct Urb {
        UMockdevIoctlData* urb;
        UMockdevIoctlData* buffer;
        gulong address;
    };

    static usbdevfs_urb& fields(const Urb& u) {
        return *reinterpret_cast<usbdevfs_urb*>(u.urb->data);
    }

    void finish(const Urb& u, int status, std::span<const std::byte> data, std::size_t at = 0) {
        if (!data.empty()) write_to(u.buffer, at, data);
        const int length = static_cast<int>(data.size());
        write_to(u.urb, offsetof(usbdevfs_urb, status), std::as_bytes(std::span(&status, 1)));
        write_to(u.urb, offsetof(usbdevfs_urb, actual_length),
                 std::as_bytes(std::span(&length, 1)));
        done_.push_back(u);
    }

    void control(const Urb& u) {
        const auto bytes = read_from(u.buffer);
        Request request{
            read_u8(bytes, 0), read_u8(bytes, 1), read_u16(bytes, 2), read_u16(bytes, 4), {}};
        const bool to_host = (request.type & 0x80) != 0;
        if (!to_host) {
            request.data.assign(bytes.begin() + 8, bytes.end());
            requests_.push_back(request);
            const int length = static_cast<int>(request.data.size());
            finish(u, 0, {});
            return write_to(u.urb, offsetof(usbdevfs_urb, actual_length),
                            std::as_bytes(std::span(&length, 1)));
        }
        requests_.push_back(request);
        const bool is_serial = request.type == 0x80 && request.id == 6;
        const auto reply = is_serial ? string_descriptor(request.value & 0xFFU)
                           : answer  ? answer(request)
                                     : std::nullopt;
        if (!reply) return finish(u, -EPIPE, {});
        const std::size_t room = bytes.size() - 8;
        finish(u, 0, std::span(*reply).first(std::min(room, reply->size())), 8);
    }

    static std::vector<std::byte> string_descriptor(unsigned index) {
        const std::string text = index == 0 ? "\x09\x04" : "0123456789ABCDEF";
        std::vector<std::byte> out{std::byte{0}, std::byte{3}};
        for (const char c : text) {
            out.push_back(static_cast<std::byte>(c));
            if (index != 0) out.push_back(std::byte{0});
        }
        out[0] = static_cast<std::byte>(out.size());
        return out;
    }

    void handle(UMockdevIoctlClient* client, unsigned long request,
                UMockdevIoctlData* argument) override {
        const auto end = [client](glong result, int error = 0) {
            umockdev_ioctl_client_complete(client, result, error);
        };
        const std::lock_guard lock(mutex_);
        if (gone_ && done_.empty()) return end(-1, ENODEV);
        switch (request) {
            case USBDEVFS_GET_CAPABILITIES: {
                const std::uint32_t none = 0;
                write_to(follow(argument, 0, 4), 0, std::as_bytes(std::span(&none, 1)));
                return end(0);
            }
            case USBDEVFS_CLAIMINTERFACE:
                return claimed_by_another ? end(-1, EBUSY) : end(0);
            case USBDEVFS_RELEASEINTERFACE:
                return end(0);
            case USBDEVFS_CLEAR_HALT: {
                const auto endpoint = read_u32(read_from(follow(argument, 0, 4)), 0);
                if (endpoint != 0x81) return end(-1, EINVAL);
                if (!waiting_.empty()) return end(-1, EBUSY);  // a kernel only warns
                ++clears_;
                halted_ = stays_halted;
                return end(0);
            }
            case USBDEVFS_SUBMITURB:
                submit(argument);
                return end(0);
            case USBDEVFS_DISCARDURB:
                return end(discard(argument) ? 0 : -1, EINVAL);
            case USBDEVFS_REAPURB:
            case USBDEVFS_REAPURBNDELAY: {
                if (done_.empty()) return end(-1, EAGAIN);
                umockdev_ioctl_data_set_ptr(follow(argument, 0, sizeof(void*)), 0,
                                            done_.front().urb);
                done_.pop_front();
                return end(0);
            }
            default:
                return end(-1, ENOTTY);
        }
    }

    void submit(UMockdevIoctlData* argument) {
        Urb u{};
        u.urb = follow(argument, 0, sizeof(usbdevfs_urb));
        u.buffer = follow(u.urb, offsetof(usbdevfs_urb, buffer),
                          static_cast<std::size_t>(fields({u.urb, nullptr, 0}).buffer_length));
        u.address = u.urb->client_addr;
        umockdev_ioctl_data_ref(u.urb);
        if (fields(u).type == USBDEVFS_URB_TYPE_CONTROL) return control(u);
        if (halted_) return finish(u, -EPIPE, {});
        waiting_.push_back(u);
    }

    bool discard(UMockdevIoctlData* argument) {
        const gulong address = *reinterpret_cast<gulong*>(argument->data);
        const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                        [&](const Urb& u) { return u.address == address; });
        if (found == waiting_.end()) return false;
        finish(*found, -ENOENT, {});
        waiting_.erase(found);
        return true;
    }

    static constexpr const char* kPath = "/devices/pci0000:00/0000:00:14.0/usb1/1-2";
    // Device 1209:0001, serial string 3; one configuration, interface 0 (FF/47/01), bulk IN 0x81.
    static constexpr const char* kDescriptors =
        "12010002000000400912010000010102"
        "0301"
        "09021900010100803209040000"
        "01FF470100"
        "0705810200"
        "0200";

    MockBed& bed_;
    mutable std::mutex mutex_;
    std::deque<Urb> waiting_, done_;
    std::vector<Request> requests_;
    bool gone_ = false, halted_ = false;
    int clears_ = 0;
};

}  // namespace foverig::test
