#pragma once
// A DK2 panel that is not there (DEVICES.md 1.7, 2.3): vsyncs on the host clock, the frame that
// each of them shows, rolling light from right to left, and the corner pixel read back.
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "devices/display/display.h"
#include "simulators/dk2/panel_sensor.h"
#include "simulators/faults/faults.h"
#include "simulators/motion/random.h"

namespace foverig {

/// One thread may present while another reads.
class VirtualPanel final : public Display, public PanelSensor {
  public:
    struct Settings {
        PanelTiming timing{};
        HostTime first_vsync{};
        PanelFaults faults{};
        std::uint64_t seed = 0;
    };
    struct Counts {
        std::uint64_t presented = 0;
        std::uint64_t replaced = 0;  ///< never seen, as a later frame came before their vsync
        std::uint64_t repeated = 0;  ///< vsyncs between the first frame and the newest that showed
                                     ///< an old frame again
    };
    /// A column's light while a frame is lit on it; dark between these.
    struct Light {
        HostTime from{}, to{};
        std::uint64_t frame_id = 0;
        std::uint8_t latency_level = 16;
    };
    /// Frames that are remembered.
    static constexpr std::size_t kHistory = 512;

    VirtualPanel() : VirtualPanel(Settings{}) {}
    explicit VirtualPanel(const Settings& settings);

    const PanelTiming& timing() const override { return settings_.timing; }
    HostTime next_vsync(HostTime at) const override { return vsync(first_vsync_from(at)); }
    Presentation present(const FrameOnPanel& frame, HostTime submit) override;

    std::optional<Reading> reading_at(HostTime t, bool read_pixel) const override;

    /// Start of the scan-out with this number, counted from 0.
    HostTime vsync(std::uint64_t number) const;
    /// What an eye at column `x_px` (landscape, 0 is left) sees between two instants; only vsyncs
    /// that have a frame give light.
    std::vector<Light> lights(double x_px, HostTime from, HostTime to) const;
    Counts counts() const;

  private:
    struct Shown {
        std::uint64_t vsync_number;
        FrameOnPanel frame;
    };
    std::uint64_t first_vsync_from(HostTime at) const;
    std::optional<FrameOnPanel> shown_at(std::uint64_t vsync_number) const;

    Settings settings_;
    motion::Draws jitter_, lost_reads_;
    mutable std::mutex mutex_;  // guards what follows
    std::deque<Shown> shown_;
    Counts counts_;
};

}  // namespace foverig
