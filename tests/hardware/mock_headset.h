#pragma once
#include <fmt/format.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <thread>

#include "devices/bytes.h"
#include "tests/hardware/mock_bed.h"

namespace foverig::test {

/// A DK2 as hidapi's hidraw back end sees one: input reports over a pty, feature reports by ioctl.
class MockHeadset : public IoctlNode {
  public:
    explicit MockHeadset(MockBed& bed, int number = 0,
                         const std::string& serial = "A1B2C3D4E5F6G7H8I9J0")
        : bed_(bed), number_(number) {
        const std::string usb =
            fmt::format("/devices/pci0000:00/0000:00:14.0/usb1/1-{}", number + 1);
        const std::string name = fmt::format("0003:2833:0021.000{}", number + 1);
        const std::string hid = fmt::format("{}/1-{}:1.0/{}", usb, number + 1, name);
        bed.add(fmt::format(
            "P: {}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: idVendor=2833\nA: idProduct=0021\n"
            "A: manufacturer=Oculus VR, Inc.\nA: product=Rift DK2\nA: bcdDevice=0212\n\n"
            "P: {}/1-{}:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
            "A: bInterfaceNumber=00\n\n",
            usb, usb, number + 1));
        bed.add(
            fmt::format("P: {}\nE: SUBSYSTEM=hid\nE: HID_ID=0003:00002833:00000021\n"
                        "E: HID_NAME=Oculus VR, Inc. Rift DK2\nE: HID_UNIQ={}\n\n",
                        hid, serial));
        const std::string hidraw = fmt::format("{}/hidraw/hidraw{}", hid, number);
        paths_ = {hidraw, hid, fmt::format("{}/1-{}:1.0", usb, number + 1), usb};
        bed.add(
            fmt::format("P: {}\nN: hidraw{}\nE: SUBSYSTEM=hidraw\nE: DEVNAME={}\n"
                        "L: device=../../../{}\n",
                        hidraw, number, node(), name));
        attach(bed, node());
    }

    ~MockHeadset() override { detach(bed_, node()); }

    std::string node() const { return fmt::format("/dev/hidraw{}", number_); }

    void send(std::span<const std::byte> report) {
        const int pty = umockdev_testbed_get_dev_fd(bed_.get(), node().c_str());
        ASSERT_EQ(::write(pty, report.data(), report.size()), static_cast<ssize_t>(report.size()));
    }
    void answer(std::vector<std::byte> report) {
        const std::lock_guard lock(mutex_);
        const auto id = read_u8(report, 0);
        features_[id] = std::move(report);
    }
    std::vector<std::vector<std::byte>> sets() const {
        const std::lock_guard lock(mutex_);
        return sets_;
    }
    /// From now on a report that is set runs out of time after `takes`.
    void let_sets_run_out_of_time(std::chrono::milliseconds takes) {
        const std::lock_guard lock(mutex_);
        sets_take_ = takes;
    }
    /// When the sets that ran out of time began, each before the one after it.
    std::vector<std::chrono::steady_clock::time_point> lost_sets() const {
        const std::lock_guard lock(mutex_);
        return lost_sets_;
    }
    /// The kernel hangs the node up and takes it away. (The bed can give its name to no other one.)
    void unplug() {
        ::close(umockdev_testbed_get_dev_fd(bed_.get(), node().c_str()));
        for (const std::string& path : paths_) {
            umockdev_testbed_remove_device(bed_.get(), ("/sys" + path).c_str());
        }
    }

  private:
    void handle(UMockdevIoctlClient* client, unsigned long request,
                UMockdevIoctlData* argument) override {
        const std::size_t size = _IOC_SIZE(request);
        UMockdevIoctlData* data = follow(argument, 0, size);
        const std::lock_guard lock(mutex_);
        switch (_IOC_NR(request)) {
            case _IOC_NR(HIDIOCGRDESCSIZE): {
                const int length = kDescriptorSize;
                write_to(data, 0, std::as_bytes(std::span(&length, 1)));
                return umockdev_ioctl_client_complete(client, 0, 0);
            }
            case _IOC_NR(HIDIOCGRDESC):
                return umockdev_ioctl_client_complete(client, 0, 0);
            case _IOC_NR(HIDIOCSFEATURE(0)):
                if (sets_take_ > std::chrono::milliseconds{0}) {
                    lost_sets_.push_back(std::chrono::steady_clock::now());
                    std::this_thread::sleep_for(sets_take_);
                    return umockdev_ioctl_client_complete(client, -1, ETIMEDOUT);
                }
                sets_.push_back(read_from(data));
                return umockdev_ioctl_client_complete(client, static_cast<glong>(size), 0);
            case _IOC_NR(HIDIOCGFEATURE(0)): {
                const auto found = features_.find(data->data[0]);
                if (found == features_.end())
                    return umockdev_ioctl_client_complete(client, -1, EPIPE);
                const auto& report = found->second;
                const auto given = std::span(report).first(std::min(size, report.size()));
                write_to(data, 0, given);
                return umockdev_ioctl_client_complete(client, static_cast<glong>(given.size()), 0);
            }
            default:
                return umockdev_ioctl_client_complete(client, -1, EINVAL);
        }
    }

    static constexpr int kDescriptorSize = 10;

    MockBed& bed_;
    int number_;
    std::vector<std::string> paths_;  // children first
    mutable std::mutex mutex_;
    std::map<std::uint8_t, std::vector<std::byte>> features_;
    std::vector<std::vector<std::byte>> sets_;
    std::chrono::milliseconds sets_take_{0};
    std::vector<std::chrono::steady_clock::time_point> lost_sets_;
};

}  // namespace foverig::test
