#include "devices/hardware/holders.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>

#include "tests/devices/hardware/other_program.h"

namespace foverig::hardware {
namespace {

using testing::HasSubstr;

class Holders : public testing::Test {
  protected:
    void SetUp() override { std::ofstream(node_) << "x"; }
    void TearDown() override { std::remove(node_.c_str()); }

    std::string node_ = testing::TempDir() + "foverig_held_" + std::to_string(getpid());
};

TEST_F(Holders, AreOtherProcessesAndNeverThisOne) {
    std::ifstream ours(node_);
    EXPECT_TRUE(holders_of(node_).empty());
    const test::OtherProgram other(node_);
    const auto holders = holders_of(node_);
    ASSERT_EQ(holders.size(), 1U);
    EXPECT_EQ(holders[0].pid, other.pid());
    const Error error = busy(node_);
    EXPECT_EQ(error.code, ErrorCode::busy);
    EXPECT_THAT(error.text, HasSubstr(fmt::format("(pid {}); end that program", other.pid())));
}

TEST_F(Holders, AreFoundUnderAnotherNameOfTheNode) {
    const std::string link = node_ + "_link";
    ASSERT_EQ(::symlink(node_.c_str(), link.c_str()), 0);
    const test::OtherProgram other(node_);
    EXPECT_EQ(holders_of(link).size(), 1U);
    std::remove(link.c_str());
}

TEST_F(Holders, AreNoneOfWhatIsNotThere) {
    EXPECT_TRUE(holders_of(node_ + "_gone").empty());
    EXPECT_TRUE(holders_of(node_, "/nothing").empty());
    EXPECT_THAT(busy(node_, {}).text, HasSubstr("sudo fuser " + node_));
    EXPECT_THAT(busy(node_, {{7, "steam"}, {8, "ouvrt"}}).text,
                HasSubstr("held by steam (pid 7) and ouvrt (pid 8)"));
}

}  // namespace
}  // namespace foverig::hardware
