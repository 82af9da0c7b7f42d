#pragma once
// A simulated DK2 on a manual clock, worn by a head that looks round.
#include <gtest/gtest.h>

#include <vector>

#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/look_head.h"

namespace foverig::test {

using dk2::InputReport11;

struct Arrived {
    HostTime at;
    InputReport11 report;
};

class Dk2Bench {
  public:
    explicit Dk2Bench(const SimulatedDk2::Settings& settings = {})
        : device(clock, look, settings) {}

    /// Everything that arrives until then.
    std::vector<Packet> packets_until(HostTime until) {
        std::vector<Packet> packets;
        while (true) {
            auto next = device.next(until);
            auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) return packets;
            packets.push_back(std::move(*packet));
        }
    }
    std::vector<Arrived> reports_until(HostTime until) {
        std::vector<Arrived> reports;
        for (const Packet& packet : packets_until(until)) {
            const auto report = InputReport11::decode(packet.bytes);
            EXPECT_TRUE(report);
            reports.push_back({packet.arrival, *report});
        }
        return reports;
    }
    template <class Report>
    Status set(const Report& report) {
        return device.control_set(Report::kId, 0, report.encode());
    }
    template <class Report>
    Report get() {
        const auto bytes = device.control_get(Report::kId, 0, Report::kSize);
        EXPECT_TRUE(bytes);
        return *Report::decode(*bytes);
    }

    ManualClock clock;
    motion::LookHead look{4};
    SimulatedDk2 device;
};

inline HostTime at(Nanoseconds t) {
    return HostTime(t);
}

/// One fault alone.
inline SimulatedDk2::Settings with(const char* kind, double value, std::uint64_t seed = 0) {
    FaultSettings faults;
    EXPECT_TRUE(set_fault(faults, "dk2", kind, value));
    return {.faults = faults.dk2, .seed = seed};
}

}  // namespace foverig::test
