#pragma once
// Opening what is on the (virtual) desk with the program's own drivers.
#include <gtest/gtest.h>

#include <thread>

#include "devices/hardware/open_devices.h"

namespace foverig::test {

inline constexpr hardware::UsbId kSecondTracker{0x1209, 0x0002};
inline constexpr Nanoseconds kSecond{1'000'000'000};

/// The kernel needs a moment from plugging in to the node; generous, as only success ends it early.
template <class Open>
std::unique_ptr<hardware::LiveTransport> opened(Open open) {
    constexpr int kTries = 6000;
    std::string text;
    for (int i = 0; i < kTries; ++i) {
        auto transport = open();
        if (transport) return std::move(transport).value();
        text = transport.error().text;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    ADD_FAILURE() << text;
    return nullptr;
}

inline std::unique_ptr<hardware::LiveTransport> headset(const Clock& clock) {
    return opened([&] { return hardware::open_headset(clock, ""); });
}
inline std::unique_ptr<hardware::LiveTransport> tracker(
    const Clock& clock, const hardware::UsbId& id = hardware::kGazeTracker) {
    return opened([&] { return hardware::open_gaze_tracker(clock, id, ""); });
}

/// Whatever comes until then.
inline std::vector<Packet> packets_until(Transport& transport, HostTime until) {
    std::vector<Packet> packets;
    while (true) {
        auto next = transport.next(until);
        auto* packet = std::get_if<Packet>(&next);
        if (packet == nullptr) {
            EXPECT_TRUE(std::holds_alternative<Timeout>(next)) << "a fault";
            return packets;
        }
        packets.push_back(std::move(*packet));
    }
}

}  // namespace foverig::test
