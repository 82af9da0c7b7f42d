#include "rig/records/elsewhere.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace foverig {
namespace {

nlohmann::json with(double others_ratio, double stolen_ratio) {
    return {{"processor_use",
             {{"own_ratio", 0.5}, {"others_ratio", others_ratio}, {"stolen_ratio", stolen_ratio}}}};
}

TEST(Elsewhere, SaysWhereTheProcessorTimeWent) {
    EXPECT_DOUBLE_EQ(*elsewhere_ratio(with(0.125, 0.25)), 0.375);
    EXPECT_EQ(elsewhere_text(with(0.12, 0.25)),
              "25 % to other guests of its host, 12 % to other programs");
    EXPECT_EQ(elsewhere_text(with(0.12, 0.0)), "12 % to other programs");
}

TEST(Elsewhere, IsSilentWhereItMovesNoTime) {
    EXPECT_NE(elsewhere_text(with(0.015, 0.016)), "");
    EXPECT_EQ(elsewhere_text(with(0.015, 0.014)), "");
}

TEST(Elsewhere, DoesNotGuess) {
    for (const auto& summary :
         {nlohmann::json::object(), nlohmann::json{{"processor_use", nullptr}}, nlohmann::json()}) {
        EXPECT_FALSE(elsewhere_ratio(summary));
        EXPECT_EQ(elsewhere_text(summary), "");
    }
}

}  // namespace
}  // namespace foverig
