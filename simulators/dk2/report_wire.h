#pragma once
// The way from the device's endpoint to the host: what is lost, what comes late (DEVICES.md 3.2).
#include <cstdint>
#include <deque>
#include <optional>

#include "devices/transport.h"
#include "simulators/faults/faults.h"
#include "simulators/motion/random.h"

namespace foverig {

/// Packets in order of arrival.
class ReportWire {
  public:
    ReportWire(const Dk2Faults& faults, std::uint64_t seed);

    /// A report leaves the device at `at`.
    void send(std::vector<std::byte> bytes, HostTime at);
    /// The oldest packet that arrived by `deadline`.
    std::optional<Packet> take(HostTime deadline);
    std::optional<HostTime> first_arrival() const;

  private:
    bool lost();

    Dk2Faults faults_;
    motion::Draws loss_, delay_;
    std::uint64_t index_ = 0;
    bool losing_ = false;
    HostTime last_arrival_{HostTime::min()};
    std::deque<Packet> arriving_;
};

}  // namespace foverig
