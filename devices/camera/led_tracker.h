#pragma once
// From an image to the headset's pose before the camera: spots, then LEDs (by a pose that is nearly
// known, or else by how they blink), then perspective-n-point. One image at a time, in order.
#include <cstdint>
#include <optional>
#include <vector>

#include "devices/camera/led_matcher.h"
#include "devices/camera/pose_solver.h"

namespace foverig::camera {

struct LedTrackerConfig {
    BlobConfig blobs{};
    BlobTracksConfig tracks{};
    SolverConfig solver{};
    double match_gate_px = 12.0;   ///< of LEDs from where the expected pose puts them ...
    double settled_gate_px = 3.0;  ///< ... and from where a pose of this image does
    double most_rms_px = 1.0;
    /// Shares of matched LEDs whose blinking must not tell of another LED, and of those that must
    /// be seen: a wrong pose explains few of the spots that it asks for.
    double most_contradicted = 0.25, least_explained = 0.5;
};

struct LedTrackerCounts {
    std::uint64_t images = 0, poses = 0, acquired = 0, contradicted = 0;
    std::uint64_t crowded =
        0;  ///< images with more spots than BlobConfig::most_blobs: not searched
};

class LedTracker {
  public:
    LedTracker(std::vector<dk2::Led> leds, const Lens& lens, const LedTrackerConfig& config = {});
    LedTracker(const LedTracker&) = delete;
    LedTracker& operator=(const LedTracker&) = delete;

    /// `exposure` is the running number of exposures, `pattern` the frame of the blink pattern that
    /// was shown in it. `expected` is where the headset should be, if anyone knows.
    std::optional<SolvedPose> see(const GreyView& image, int exposure, std::uint8_t pattern,
                                  const std::optional<RigidPose>& expected);

    /// Of the last image; none of one that was crowded.
    const std::vector<TrackedBlob>& spots() const { return spots_; }
    const LedTrackerCounts& counts() const { return counts_; }

  private:
    std::optional<SolvedPose> near(const RigidPose& expected, double gate_px) const;
    std::optional<SolvedPose> by_blinking() const;
    bool contradicted(std::span<const Match> matches) const;
    std::optional<SolvedPose> settled(const RigidPose& pose);

    std::vector<dk2::Led> leds_;
    Lens lens_;
    LedTrackerConfig config_;
    BlobTracks tracks_;
    std::vector<TrackedBlob> spots_;
    LedTrackerCounts counts_;
};

}  // namespace foverig::camera
