#include "simulators/faults/faults.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

#include "simulators/faults/device_clock.h"

namespace foverig {
namespace {

TEST(Faults, EachNameSetsOneFieldAndNoOther) {
    std::set<double*> fields;
    FaultSettings all;
    for (const FaultInfo& info : known_faults()) {
        FaultSettings one;
        ASSERT_TRUE(set_fault(one, info.device, info.kind, info.typical)) << info.kind;
        EXPECT_EQ(info.field(one), info.typical);
        EXPECT_NE(info.typical, 0.0);
        info.field(one) = 0.0;
        const FaultSettings none;
        EXPECT_EQ(std::memcmp(&one, &none, sizeof(FaultSettings)), 0) << info.kind;
        fields.insert(&info.field(all));
    }
    // Every field of the settings has a name, as all of them are doubles.
    EXPECT_EQ(fields.size(), sizeof(FaultSettings) / sizeof(double));
    EXPECT_EQ(known_faults().size(), fields.size());
}

TEST(Faults, UnknownNamesAndValuesGetASentence) {
    FaultSettings faults;
    const auto text = [&](const char* device, const char* kind, double value) {
        const Status status = set_fault(faults, device, kind, value);
        return status ? std::string() : status.error().text;
    };
    EXPECT_NE(text("dk3", "noise", 1.0).find("expected dk2, gaze, panel or camera"),
              std::string::npos);
    EXPECT_NE(text("dk2", "nose", 1.0).find("noise"), std::string::npos);
    EXPECT_NE(text("dk2", "dropout", 1.5).find("expected 0 to 1"), std::string::npos);
    EXPECT_NE(text("dk2", "dropout", std::nan("")).find("out of range"), std::string::npos);
    EXPECT_EQ(faults.dk2.dropout, 0.0);
}

TEST(DeviceClock, DriftsByItsPartsPerMillion) {
    const SimulatedDeviceClock exact({.start_s = 2.0}, 1);
    EXPECT_EQ(exact.at_ns(HostTime(Nanoseconds(123456789))), 2123456789);
    const SimulatedDeviceClock fast({.drift_ppm = 20.0}, 1);
    EXPECT_EQ(fast.at_ns(HostTime(std::chrono::seconds(100))), 100'002'000'000);
}

TEST(DeviceClock, WandersByItsRateAndStaysMonotone) {
    const SimulatedDeviceClock clock({.wander_ppm = 5.0}, 3);
    double square = 0.0;
    std::int64_t before = clock.at_ns(HostTime{});
    EXPECT_EQ(before, 0);
    constexpr int kSeconds = 20000;
    for (int i = 1; i <= kSeconds; ++i) {
        const std::int64_t now = clock.at_ns(HostTime(std::chrono::seconds(i)));
        EXPECT_GT(now, before);
        const double ppm = 1e-3 * static_cast<double>(now - before - 1'000'000'000);
        square += ppm * ppm;
        before = now;
    }
    EXPECT_NEAR(std::sqrt(square / kSeconds), 5.0, 0.5);
}

}  // namespace
}  // namespace foverig
