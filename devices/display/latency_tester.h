#pragma once
// The DK2's built-in latency tester (DEVICES.md 1.7): a grey of eight in the corner pixel of each
// frame comes back in report 11 one or two frames later, with the vsync at which it was scanned
// out.
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "devices/time.h"

namespace foverig {

constexpr int kLatencyLevels = 8;
constexpr int kIdleLevel = 0;

/// 32 i + 16; index 0 (16) is idle.
constexpr std::uint8_t grey_of_level(int index) {
    return static_cast<std::uint8_t>(32 * index + 16);
}
/// The level whose grey is less than 10 away.
std::optional<int> level_of_grey(std::uint8_t grey);

/// What the host knows of a frame when it draws the corner pixel.
struct LatencyMark {
    std::uint64_t frame_id = 0;
    HostTime imu_sample{};  ///< newest sample that the frame's pose used
    HostTime submit{};
    HostTime predicted_scan_out{};  ///< vsync for which the pose was predicted
};

/// Motion to start of scan-out, measured through the panel.
struct LatencyReading {
    std::uint64_t frame_id = 0;
    Nanoseconds motion_to_scan_out{};  ///< scan-out - imu_sample
    Nanoseconds submit_to_scan_out{};
    Nanoseconds prediction_error{};  ///< scan-out - predicted_scan_out
};

class LatencyTester {
  public:
    /// Remembers the frame and gives the grey to draw: levels 1..7 in turn.
    std::uint8_t mark(const LatencyMark& mark);

    /// A read-back triple of report 11, its vsync stamp mapped to host time. A reading appears once
    /// the vsync before its frame's first was seen without it, and two read-backs in a row match
    /// marks in order; lost reads cost readings, never give wrong ones.
    std::vector<LatencyReading> read_back(std::uint16_t frame_count, HostTime scan_out,
                                          std::uint8_t grey);

    /// Median of the last 12 of submit to scan-out; nothing with fewer than 4 (OVR05: more than 3).
    std::optional<Nanoseconds> post_present() const;

  private:
    struct Pending {
        int level;
        std::uint64_t order;
        LatencyMark mark;
        bool read;
    };
    /// The read-back before: what it showed, and the mark that it matched.
    struct Seen {
        std::uint16_t frame_count;
        HostTime scan_out;
        int level;
        std::optional<std::uint64_t> order;
        std::optional<LatencyReading> unconfirmed;
    };

    Pending* find(int level, HostTime scan_out);

    std::deque<Pending> pending_;
    std::optional<Seen> last_;
    std::deque<Nanoseconds> post_present_;
    std::uint64_t marks_ = 0;
};

}  // namespace foverig
