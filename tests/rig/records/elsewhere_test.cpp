#include "rig/records/elsewhere.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace foverig {
namespace {

nlohmann::json with(double others, double stolen) {
    return {{"processor_use",
             {{"processors", 64}, {"own", 1.0}, {"others", others}, {"stolen", stolen}}}};
}

TEST(Elsewhere, SaysWhoHadTheProcessors) {
    EXPECT_DOUBLE_EQ(*elsewhere_processors(with(0.125, 0.25)), 0.375);
    EXPECT_EQ(elsewhere_text(with(0.62, 1.2)),
              "1.8 of 64 processors: 1.2 to other guests of its host, 0.6 to other programs");
    EXPECT_EQ(elsewhere_text(with(1.0, 0.0)), "1.0 of 64 processors: 1.0 to other programs");
}

TEST(Elsewhere, GoesByProcessorsHoweverManyTheMachineHas) {
    EXPECT_NE(elsewhere_text(with(0.05, 0.06)), "");
    EXPECT_EQ(elsewhere_text(with(0.05, 0.04)), "");
}

TEST(Elsewhere, DoesNotGuess) {
    for (const auto& summary :
         {nlohmann::json::object(), nlohmann::json{{"processor_use", nullptr}}, nlohmann::json()}) {
        EXPECT_FALSE(elsewhere_processors(summary));
        EXPECT_EQ(elsewhere_text(summary), "");
    }
}

}  // namespace
}  // namespace foverig
