#pragma once
#include <gtest/gtest.h>

#include "simulators/replay/replayed_device.h"

namespace foverig::test {

/// What a device sent, of a recording.
inline std::vector<Packet> recorded_packets(const std::string& file, const std::string& device) {
    std::vector<Packet> packets;
    const auto recording = Recording::open(file);
    EXPECT_TRUE(recording) << (recording ? "" : recording.error().text);
    if (!recording) return packets;
    ManualClock clock;
    clock.sleep_until(recording->last());
    ReplayedDevice replayed(*recording, device, clock, {});
    while (true) {
        auto next = replayed.next(recording->last());
        if (auto* packet = std::get_if<Packet>(&next)) {
            packets.push_back(std::move(*packet));
        } else if (!std::holds_alternative<Fault>(next) || replayed.damage()) {
            return packets;
        }
    }
}

}  // namespace foverig::test
