#include "devices/hardware/usb_bus.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

namespace foverig::hardware {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The folders that sysfs would have.
class UsbBus : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / fmt::format("usb_bus_{}", getpid());
        fs::create_directories(root_ / "bus");
        for (const char* driver : {"usbfs", "usbhid"}) {
            fs::create_directories(root_ / "drivers" / driver);
        }
    }
    void TearDown() override { fs::remove_all(root_); }

    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file) << text << "\n";
    }
    /// Returns the folder of its interface 0.
    fs::path add(const std::string& usb, const std::string& product, const std::string& driver) {
        const fs::path device = root_ / "devices" / usb, interface = device / (usb + ":1.0");
        fs::create_directories(interface);
        write(device / "idVendor", "2833");
        write(device / "idProduct", product);
        write(device / "serial", "S-" + usb);
        write(device / "busnum", "1");
        write(device / "devnum", "14");
        if (!driver.empty())
            fs::create_directory_symlink(root_ / "drivers" / driver, interface / "driver");
        fs::create_directory_symlink(device, root_ / "bus" / usb);
        return interface;
    }
    std::vector<FoundDevice> found() const {
        return find_without_node(kDk2, "hidraw", (root_ / "bus").string());
    }

    fs::path root_;
};

TEST_F(UsbBus, SaysNothingOfADeviceThatHasItsNode) {
    fs::create_directories(add("1-1", "0021", "usbhid") / "0003:2833:0021.0001/hidraw/hidraw0");
    add("1-2", "0201", "usbfs");
    EXPECT_TRUE(found().empty());
}

TEST_F(UsbBus, SaysThatAProgramTookTheHeadset) {
    add("1-1", "0021", "usbfs");
    const auto devices = found();
    ASSERT_EQ(devices.size(), 1U);
    EXPECT_EQ(devices[0].path, "/dev/bus/usb/001/014");
    EXPECT_EQ(devices[0].serial, "S-1-1");
    ASSERT_TRUE(devices[0].problem);
    EXPECT_EQ(devices[0].problem->code, ErrorCode::busy);
    EXPECT_THAT(devices[0].problem->text, HasSubstr("no hidraw of it meanwhile"));
}

TEST_F(UsbBus, SaysThatNoDriverHasIt) {
    add("1-1", "0021", "");
    add("1-3", "0021", "usbhid");
    const auto devices = found();
    ASSERT_EQ(devices.size(), 2U);
    EXPECT_EQ(devices[0].problem->code, ErrorCode::io);
    EXPECT_THAT(devices[0].problem->text, HasSubstr("plug it in again"));
    EXPECT_THAT(devices[1].problem->text, HasSubstr("driver usbhid makes no hidraw"));
}

/// What a kernel does at an unplug, while the thread that reads looks for the device. One walk of
/// some hundred met a folder that had just gone.
TEST_F(UsbBus, IsLookedThroughWhileTheKernelTakesADeviceAway) {
    const fs::path interface = add("1-1", "0021", "usbhid");
    std::atomic<bool> done = false;
    std::jthread kernel([&] {
        while (!done) {
            fs::create_directories(interface / "0003:2833:0021.0001/input/capabilities/event");
            fs::remove_all(interface / "0003:2833:0021.0001");
        }
    });
    for (int i = 0; i < 5000; ++i) EXPECT_EQ(found().size(), 1U);
    done = true;
}

TEST_F(UsbBus, IsEmptyWhereThereIsNoUsb) {
    EXPECT_TRUE(find_without_node(kDk2, "hidraw", (root_ / "nothing").string()).empty());
}

}  // namespace
}  // namespace foverig::hardware
