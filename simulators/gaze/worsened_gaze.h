#pragma once
// A gaze tracker made worse: its frames later, its directions noisier, whatever tracker it is. What
// foveation makes of a worse tracker can so be asked of a simulated one and of a recording alike.
#include <cstdint>

#include "devices/gaze/frames.h"
#include "devices/transport.h"

namespace foverig {

struct GazeWorsening {
    Nanoseconds added_latency{};   ///< between exposure and handing the frame to USB
    double added_noise_deg = 0.0;  ///< standard deviation of each eye's angles, white
    std::uint64_t seed = 0;
    bool any() const { return added_latency > Nanoseconds{} || added_noise_deg > 0.0; }
};

/// Frames keep their exposure's stamp and get a later queueing stamp, so that the clock map is none
/// the worse. Noise is drawn by camera frame; the combined ray gets the mean of the eyes', the
/// point of regard stays as it was. What is no frame passes unchanged, late.
class WorsenedGaze final : public Transport {
  public:
    /// Both outlive this.
    WorsenedGaze(Transport& tracker, Clock& clock, const GazeWorsening& worsening)
        : tracker_(tracker), clock_(clock), worsening_(worsening) {}

    NextPacket next(HostTime deadline) override;
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override;
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;

  private:
    std::vector<std::byte> worsened(std::vector<std::byte> bytes) const;
    void add_noise(gaze::SampleFrame& frame) const;

    Transport& tracker_;
    Clock& clock_;
    GazeWorsening worsening_;
};

}  // namespace foverig
