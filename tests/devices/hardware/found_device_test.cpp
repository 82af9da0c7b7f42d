#include "devices/hardware/found_device.h"

#include <gmock/gmock.h>
#include <sys/fsuid.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace foverig::hardware {
namespace {

using testing::HasSubstr;

TEST(UsbId, IsWrittenAsLsusbWritesIt) {
    EXPECT_EQ(text_of(kDk2), "2833:0021");
    EXPECT_EQ(usb_id_of("1209:0001"), kGazeTracker);
    EXPECT_EQ(usb_id_of("2833:0021"), kDk2);
    for (const char* wrong : {"", "1209", "1209:001", "1209:00001", "12g9:0001", "1209-0001"}) {
        EXPECT_FALSE(usb_id_of(wrong)) << wrong;
    }
}

/// umockdev cannot refuse an open, so that a plain file stands for the node.
TEST(OpeningProblem, TellsForbiddenFromGone) {
    const std::string node = testing::TempDir() + "foverig_node_" + std::to_string(getpid());
    { std::ofstream(node) << "x"; }
    EXPECT_FALSE(opening_problem(node));
    ASSERT_EQ(::chmod(node.c_str(), 0), 0);
    const int user = setfsuid(65534);  // of this thread, so that root is refused too
    const auto problem = opening_problem(node);
    setfsuid(static_cast<uid_t>(user));
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->code, ErrorCode::forbidden);
    EXPECT_THAT(problem->text, HasSubstr(node));
    EXPECT_THAT(problem->text, HasSubstr(kUdevRuleFile));
    std::remove(node.c_str());
    EXPECT_EQ(opening_problem(node)->code, ErrorCode::closed);
}

TEST(Choose, NeedsASerialOnlyAmongSeveral) {
    const FoundDevice a{.path = "/dev/hidraw0", .serial = "A", .problem = {}};
    const FoundDevice b{.path = "/dev/hidraw1", .serial = "B", .problem = {}};
    EXPECT_EQ(choose({a}, "", "headset", "Rift")->path, a.path);
    EXPECT_EQ(choose({a, b}, "B", "headset", "Rift")->path, b.path);
    const auto none = choose({}, "", "headset", "Rift DK2, USB 2833:0021");
    EXPECT_EQ(none.error().code, ErrorCode::not_found);
    EXPECT_THAT(none.error().text, HasSubstr("2833:0021"));
    EXPECT_EQ(choose({a}, "B", "headset", "Rift").error().code, ErrorCode::not_found);
    const auto which = choose({a, b}, "", "headset", "Rift");
    EXPECT_EQ(which.error().code, ErrorCode::invalid_data);
    EXPECT_THAT(which.error().text, HasSubstr("A, B"));
}

TEST(UdevRules, NameTheDevicesThatAreDriven) {
    std::ostringstream text;
    text << std::ifstream(std::string(FOVERIG_SOURCE_DIR) + "/" + kUdevRuleFile).rdbuf();
    EXPECT_THAT(text.str(), HasSubstr(R"(SUBSYSTEM=="hidraw", ATTRS{idVendor}=="2833", )"
                                      R"(ATTRS{idProduct}=="0021")"));
    EXPECT_THAT(text.str(), HasSubstr(R"(SUBSYSTEM=="video4linux", ATTRS{idVendor}=="2833", )"
                                      R"(ATTRS{idProduct}=="0201")"));
    EXPECT_THAT(text.str(), HasSubstr(R"(SUBSYSTEM=="usb", ATTR{idVendor}=="2833", MODE)"));
    EXPECT_THAT(text.str(), HasSubstr(R"(SUBSYSTEM=="usb", ATTR{idVendor}=="1209", )"
                                      R"(ATTR{idProduct}=="0001")"));
}

}  // namespace
}  // namespace foverig::hardware
