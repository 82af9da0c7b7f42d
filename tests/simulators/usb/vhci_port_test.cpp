#include "simulators/usb/vhci_port.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace foverig::usb {
namespace {

namespace fs = std::filesystem;
using ::testing::TempDir;

// As Linux 6.1 prints it, shortened: port 0 in use (6), 2 on its way (5).
constexpr const char* kStatus =
    "hub port sta spd dev      sockfd local_busid\n"
    "hs  0000 006 002 00010001 000003 1-1\n"
    "hs  0001 004 000 00000000 000000 0-0\n"
    "hs  0002 005 003 00010003 000005 0-0\n"
    "hs  0010 004 000 00000000 000000 0-0\n"
    "ss  0015 004 000 00000000 000000 0-0\n";

/// A folder in the controller's place.
class FakeSysfs {
  public:
    explicit FakeSysfs(const std::string& status)
        : folder(TempDir() + "vhci_" + std::to_string(::getpid())) {
        fs::create_directories(folder);
        std::ofstream(folder / "status") << status;
        std::ofstream(folder / "attach");
        std::ofstream(folder / "detach");
    }
    ~FakeSysfs() { fs::remove_all(folder); }
    std::string text(const char* file) const {
        std::ifstream in(folder / file);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    fs::path folder;
};

TEST(VhciPort, FindsTheFreePortsForHighSpeed) {
    EXPECT_EQ(free_ports(kStatus), (std::vector<int>{1, 10}));
    EXPECT_TRUE(free_ports("").empty());
}

TEST(VhciPort, AttachesToTheFirstFreePortAndDetachesAtItsEnd) {
    const FakeSysfs sysfs(kStatus);
    {
        auto plugged_in = VhciPort::plug_in(Speed::full, sysfs.folder);
        ASSERT_TRUE(plugged_in);
        const std::string attached = sysfs.text("attach");
        EXPECT_EQ(attached.substr(0, 2), "1 ");                 // port
        EXPECT_EQ(attached.substr(attached.size() - 2), " 2");  // full speed, as the kernel counts
        EXPECT_EQ(sysfs.text("detach"), "");
    }
    EXPECT_EQ(sysfs.text("detach"), "1");
}

TEST(VhciPort, SaysWhatToTypeWhereTheModuleIsMissing) {
    const auto plugged_in = VhciPort::plug_in(Speed::high, TempDir() + "no_such_controller");
    ASSERT_FALSE(plugged_in);
    EXPECT_EQ(plugged_in.error().code, ErrorCode::not_found);
    EXPECT_NE(plugged_in.error().text.find("sudo modprobe vhci-hcd"), std::string::npos);
}

TEST(VhciPort, SaysThatEveryPortIsTaken) {
    const FakeSysfs sysfs("hs  0000 006 002 00010001 000003 1-1\n");
    const auto plugged_in = VhciPort::plug_in(Speed::high, sysfs.folder);
    ASSERT_FALSE(plugged_in);
    EXPECT_EQ(plugged_in.error().code, ErrorCode::busy);
}

}  // namespace
}  // namespace foverig::usb
