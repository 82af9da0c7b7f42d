#include "devices/hardware/found_cameras.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace foverig::hardware {
namespace {

namespace fs = std::filesystem;

/// The folders that sysfs and /dev would have.
class FoundCameras : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / fmt::format("found_cameras_{}", getpid());
        fs::create_directories(root_ / "class");
        fs::create_directories(root_ / "dev");
    }
    void TearDown() override { fs::remove_all(root_); }

    static void write(const fs::path& file, const std::string& text) {
        std::ofstream(file) << text << "\n";
    }
    void add(const std::string& node, const std::string& usb, const std::string& vendor,
             const std::string& product, const std::string& index) {
        const fs::path device = root_ / "devices" / usb, interface = device / (usb + ":1.0");
        const fs::path video = interface / "video4linux" / node;
        fs::create_directories(video);
        write(device / "idVendor", vendor);
        write(device / "idProduct", product);
        write(device / "serial", "S-" + usb);
        write(device / "speed", "480");
        write(video / "index", index);
        write(video / "name", "Camera of " + usb);
        fs::create_directory_symlink(interface, video / "device");
        fs::create_directory_symlink(video, root_ / "class" / node);
        write(root_ / "dev" / node, "");
    }
    std::vector<FoundCamera> found() const {
        return find_cameras((root_ / "class").string(), (root_ / "dev").string());
    }
    fs::path root_;
};

TEST_F(FoundCameras, AreKnownByTheirUsbDevice) {
    add("video0", "1-2", "2833", "0201", "0");
    add("video1", "1-2", "2833", "0201", "1");  // its metadata
    add("video2", "1-4", "046d", "0825", "0");
    const auto cameras = found();
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0].id, kDk2Camera);
    EXPECT_EQ(cameras[0].device.serial, "S-1-2");
    EXPECT_EQ(cameras[0].usb_mbit_s, 480);
    EXPECT_TRUE(cameras[0].device.path.ends_with("/dev/video0"));
    EXPECT_EQ(text_of(cameras[1].id), "046d:0825");
    EXPECT_EQ(cameras[1].name, "Camera of 1-4");
}

TEST_F(FoundCameras, ANodeThatIsGoneIsSaidToBe) {
    add("video0", "1-2", "2833", "0201", "0");
    fs::remove(root_ / "dev" / "video0");
    const auto cameras = found();
    ASSERT_EQ(cameras.size(), 1u);
    ASSERT_TRUE(cameras[0].device.problem);
    EXPECT_EQ(cameras[0].device.problem->code, ErrorCode::closed);
}

TEST_F(FoundCameras, AreNoneWithoutAClassOfThem) {
    EXPECT_TRUE(find_cameras((root_ / "nothing").string(), "/dev").empty());
}

}  // namespace
}  // namespace foverig::hardware
