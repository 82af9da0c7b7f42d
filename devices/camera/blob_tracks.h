#pragma once
// Spots followed from frame to frame, and which LED each is by how it blinks (DEVICES.md 1.8.5):
// ten frames, bright or dim, give ten bits; two LEDs' codes differ in three or more, so that one
// wrong bit is mended.
#include <array>
#include <optional>
#include <span>

#include "devices/camera/blobs.h"
#include "devices/dk2/leds.h"

namespace foverig::camera {

/// Levels of light by pattern frame, most recent cycle, as logarithms.
struct BlinkHistory {
    struct Seen {
        double log_brightness = 0;
        int frame = -1'000'000;  ///< running number of the frame it was seen in
    };
    std::array<Seen, dk2::kPatternFrames> seen{};
};

/// The ten bits, once each frame of the pattern was seen within the last twenty frames; nothing
/// where bright and dim do not differ by 10 %. A slow change of all levels (a head that comes
/// nearer) is taken off.
std::optional<std::uint16_t> code_of(const BlinkHistory& history, int newest_frame);

/// Index of the LED with this code, but for at most one bit.
std::optional<std::size_t> led_of(std::uint16_t code, std::span<const dk2::Led> leds);

struct TrackedBlob {
    Blob blob;
    std::optional<std::size_t> led;  ///< by its blinking
};

struct BlobTracksConfig {
    double gate_px = 8.0;  ///< from where it was expected by its own speed
    int forget_after = 3;  ///< frames without a spot
};

class BlobTracks {
  public:
    /// `leds` outlives the tracks.
    explicit BlobTracks(std::span<const dk2::Led> leds, const BlobTracksConfig& config = {})
        : leds_(leds), config_(config) {}

    /// The next frame's spots, in their order. `frame` counts exposures; `pattern` is the frame of
    /// the pattern that was shown: beyond 9, no blinking is read from it.
    std::vector<TrackedBlob> follow(std::span<const Blob> blobs, int frame, std::uint8_t pattern);

  private:
    struct Track {
        dvec2 place_px{0}, speed_px{0};  ///< speed in pixels a frame
        int last_frame = 0;
        BlinkHistory history;
        std::optional<std::size_t> led;

        dvec2 expected_px(int frame) const {
            return place_px + speed_px * static_cast<double>(frame - last_frame);
        }
    };

    std::vector<std::optional<std::size_t>> pair_up(std::span<const Blob> blobs, int frame) const;

    std::span<const dk2::Led> leds_;
    BlobTracksConfig config_;
    std::vector<Track> tracks_;
};

}  // namespace foverig::camera
