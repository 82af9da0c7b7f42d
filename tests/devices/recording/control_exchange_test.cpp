#include "devices/recording/control_exchange.h"

#include <gtest/gtest.h>

namespace foverig {
namespace {

TEST(ControlExchange, EveryRefusalReadsBack) {
    for (int code = 0; code <= static_cast<int>(ErrorCode::not_asked); ++code) {
        const ControlExchange refused{.kind = ControlExchange::Kind::get,
                                      .id = 3,
                                      .value = 0xBEEF,
                                      .asked_size = 69,
                                      .error = static_cast<ErrorCode>(code),
                                      .data = {std::byte{'n'}, std::byte{'o'}}};
        const auto again = ControlExchange::decode(refused.encode());
        ASSERT_TRUE(again) << code;
        EXPECT_EQ(*again, refused) << code;
        EXPECT_EQ(again->text(), "no");
    }
}

TEST(ControlExchange, ACodeThatIsNoneIsRefused) {
    std::vector<std::byte> bytes = ControlExchange{}.encode();
    ASSERT_TRUE(ControlExchange::decode(bytes));
    bytes[8] = static_cast<std::byte>(2 + static_cast<int>(ErrorCode::not_asked));
    EXPECT_FALSE(ControlExchange::decode(bytes));
}

}  // namespace
}  // namespace foverig
