#include "devices/display/edid.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "devices/display/connectors.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;

/// The first block, as VESA lays it out: maker OVR (15, 22, 18 in five bits each: 3E D2), product
/// 3, a descriptor with the name.
std::array<std::uint8_t, 128> dk2_edid() {
    std::array<std::uint8_t, 128> e{0, 255, 255, 255, 255, 255, 255, 0, 0x3E, 0xD2, 3, 0};
    const std::array<std::uint8_t, 18> name{0,   0,   0,   0xFC, 0,    'R', 'i', 'f', 't',
                                            ' ', 'D', 'K', '2',  '\n', ' ', ' ', ' ', ' '};
    std::copy(name.begin(), name.end(), e.begin() + 72);
    unsigned sum = 0;
    for (const std::uint8_t b : e) sum += b;
    e[127] = static_cast<std::uint8_t>(256U - sum % 256U);
    return e;
}

TEST(Edid, NamesTheHeadset) {
    const auto bytes = dk2_edid();
    const auto edid = parse_edid(std::as_bytes(std::span(bytes)));
    ASSERT_TRUE(edid) << edid.error().text;
    EXPECT_EQ(edid->maker, "OVR");
    EXPECT_EQ(edid->product, 3);
    EXPECT_EQ(edid->name, "Rift DK2");
    EXPECT_TRUE(is_oculus(*edid));
}

TEST(Edid, RefusesWhatIsNone) {
    const auto good = dk2_edid();
    EXPECT_FALSE(parse_edid({}));
    EXPECT_FALSE(parse_edid(std::as_bytes(std::span(good).first(127))));
    for (const std::size_t spoilt : {0U, 7U, 50U, 127U}) {
        auto bytes = good;
        bytes[spoilt] ^= 0x10U;
        EXPECT_FALSE(parse_edid(std::as_bytes(std::span(bytes)))) << spoilt;
    }
}

class ConnectorsTest : public testing::Test {
  protected:
    void SetUp() override {
        drm_ = fs::path(testing::TempDir()) / ("connectors_test_" + std::to_string(getpid()));
        fs::remove_all(drm_);
        fs::create_directories(drm_ / "card0");
        fs::create_directories(drm_ / "renderD128");
    }
    void TearDown() override { fs::remove_all(drm_); }
    void add(const std::string& name, const char* status, const char* enabled,
             std::span<const std::uint8_t> edid) const {
        fs::create_directories(drm_ / name);
        std::ofstream(drm_ / name / "status") << status << "\n";
        std::ofstream(drm_ / name / "enabled") << enabled << "\n";
        std::ofstream(drm_ / name / "edid", std::ios::binary)
            .write(reinterpret_cast<const char*>(edid.data()),
                   static_cast<std::streamsize>(edid.size()));
    }
    fs::path drm_;
};

TEST_F(ConnectorsTest, ListsWhatIsPluggedIn) {
    add("card0-HDMI-A-1", "connected", "disabled", dk2_edid());
    add("card0-DP-1", "disconnected", "disabled", {});
    const auto found = list_connectors(drm_);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].name, "DP-1");
    EXPECT_FALSE(found[0].connected);
    EXPECT_FALSE(found[0].edid);
    EXPECT_EQ(found[1].name, "HDMI-A-1");
    EXPECT_TRUE(found[1].connected);
    EXPECT_FALSE(found[1].enabled);
    ASSERT_TRUE(found[1].edid);
    EXPECT_TRUE(is_oculus(*found[1].edid));
}

TEST_F(ConnectorsTest, IsEmptyWithoutAGraphicsCard) {
    EXPECT_TRUE(list_connectors(drm_ / "none").empty());
}

}  // namespace
}  // namespace foverig
