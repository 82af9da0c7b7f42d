#pragma once
// A simulated tracker on a clock of its own, and what came out of it.
#include <variant>
#include <vector>

#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/scan_eye.h"

namespace foverig::test {

class GazeBench {
  public:
    struct Arrived {
        HostTime at;
        gaze::SampleFrame frame;
    };

    explicit GazeBench(const SimulatedGaze::Settings& settings = {})
        : device(clock, scan, settings) {}

    Status order(std::uint8_t id, std::uint16_t value = 0, Bytes data = {}) {
        return device.control_set(id, value, data);
    }
    std::vector<Packet> packets_until(HostTime until) {
        std::vector<Packet> packets;
        while (true) {
            auto next = device.next(until);
            auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) return packets;
            packets.push_back(std::move(*packet));
        }
    }
    std::vector<Arrived> samples_until(HostTime until) {
        std::vector<Arrived> samples;
        for (const Packet& packet : packets_until(until)) {
            const auto frame = gaze::decode_frame(packet.bytes);
            if (!frame) {
                ++broken;
            } else if (const auto* sample = std::get_if<gaze::SampleFrame>(&*frame)) {
                samples.push_back({packet.arrival, *sample});
            } else {
                ++heartbeats;
            }
        }
        return samples;
    }

    ManualClock clock;
    motion::ScanEye scan{6};
    SimulatedGaze device;
    int broken = 0, heartbeats = 0;
};

inline HostTime at(Nanoseconds t) {
    return HostTime(t);
}

}  // namespace foverig::test
