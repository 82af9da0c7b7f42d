#pragma once
// Light on the tracker camera's sensor: the LEDs of a moving headset, lamps in the room, noise.
#include <vector>

#include "devices/camera/lens.h"
#include "devices/dk2/leds.h"
#include "devices/rigid_pose.h"
#include "simulators/faults/faults.h"
#include "simulators/motion/random.h"

namespace foverig {

inline constexpr int kCameraWidth_px = 752, kCameraHeight_px = 480;

/// Own choices where no document tells: a bright LED head-on at 1 m peaks at 200 of 255 levels,
/// and shines as the cosine over the square of the distance; dim is half of it; a spot is a
/// Gaussian of 1 pixel.
class CameraScene {
  public:
    CameraScene(std::vector<dk2::Led> leds, const camera::Lens& lens, const CameraFaults& faults,
                std::uint64_t seed);

    struct Exposure {
        RigidPose camera_from_imu;
        std::uint8_t pattern = 0;  ///< frame of the blink pattern; 0xFF: all bright
        double share = 1.0;        ///< of the flash that falls into it
        bool covered = false;      ///< something stands before the LEDs
        std::uint64_t index = 0;   ///< names the noise
    };
    /// 752 x 480 grey levels in rows without padding.
    void render(const Exposure& exposure, std::span<std::byte> image);

  private:
    struct Spot {
        dvec2 pixel{0};
        double peak = 0, sigma_px = 1;
    };

    /// Lit pixels of a row, from the first to behind the last.
    struct Span {
        int begin = kCameraWidth_px, end = 0;
    };

    std::vector<Spot> spots(const Exposure& exposure) const;
    void add(const Spot& spot);
    void develop(std::uint64_t index, std::span<std::byte> image);

    std::vector<dk2::Led> leds_;
    camera::Lens lens_;
    motion::Draws draws_;
    std::vector<Spot> lamps_;
    std::vector<float> light_;     // levels above black, of the exposure in work; else 0
    std::vector<Span> lit_;        // of each row of it
    std::vector<float> noise_;     // normal draws of the noise's strength, used at random offsets
    std::vector<std::byte> dark_;  // the sensor without light, of the same draws
};

}  // namespace foverig
