#include "simulators/camera/camera_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "devices/camera/led_matcher.h"

namespace foverig {
namespace {

constexpr double kPeakAt1m = 200.0, kDim = 0.5, kSpot_px = 1.0;
constexpr float kBlack = 10.0F;
constexpr float kReadNoise = 1.5F;    // levels
constexpr float kShotNoise2 = 0.04F;  // levels^2 a level: 25 electrons each
constexpr std::size_t kNoiseTable = std::size_t{1} << 16;
constexpr double kReach = 5.0;  // standard deviations that a spot is drawn to

/// What the sensor makes of light (levels) and a draw of its noise.
std::byte developed(float light, float noise) {
    const float sigma = std::sqrt(kReadNoise * kReadNoise + kShotNoise2 * light);
    const float level = kBlack + light + noise * sigma;
    return static_cast<std::byte>(static_cast<int>(std::min(255.0F, std::max(0.0F, level + 0.5F))));
}

enum Stream : std::uint64_t { kLampStream = 700, kTableStream, kRowStream };

}  // namespace

CameraScene::CameraScene(std::vector<dk2::Led> leds, const camera::Lens& lens,
                         const CameraFaults& faults, std::uint64_t seed)
    : leds_(std::move(leds)),
      lens_(lens),
      draws_(seed, kRowStream),
      light_(static_cast<std::size_t>(kCameraWidth_px) * kCameraHeight_px),
      lit_(kCameraHeight_px) {
    const motion::Draws lamps(seed, kLampStream);
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(faults.spots); ++i) {
        lamps_.push_back({.pixel = {lamps.uniform(4 * i, 0, kCameraWidth_px),
                                    lamps.uniform(4 * i + 1, 0, kCameraHeight_px)},
                          .peak = lamps.uniform(4 * i + 2, 60, 600),
                          .sigma_px = lamps.log_normal(4 * i + 3, 2.0, 0.8)});
    }
    if (faults.noise <= 0.0) {
        noise_.assign(kCameraWidth_px, 0.0F);
    } else {
        const motion::Draws table(seed, kTableStream);
        for (std::uint64_t i = 0; i < kNoiseTable + kCameraWidth_px; ++i)
            noise_.push_back(static_cast<float>(faults.noise) *
                             static_cast<float>(table.normal(i % kNoiseTable)));
    }
    for (const float noise : noise_) dark_.push_back(developed(0.0F, noise));
}

std::vector<CameraScene::Spot> CameraScene::spots(const Exposure& exposure) const {
    std::vector<Spot> spots = lamps_;
    if (exposure.covered || exposure.share <= 0.0) return spots;
    for (const dk2::Led& led : leds_) {
        const auto pixel = camera::pixel_of(led, exposure.camera_from_imu, lens_);
        if (!pixel) continue;
        const dvec3 place_m = exposure.camera_from_imu * led.position_m;
        const double distance_m = glm::length(place_m);
        const double cosine =
            glm::dot(exposure.camera_from_imu.rotation * led.normal, -place_m / distance_m);
        const bool bright =
            exposure.pattern >= dk2::kPatternFrames || (led.code >> exposure.pattern & 1) != 0;
        spots.push_back({.pixel = *pixel,
                         .peak = kPeakAt1m * exposure.share * cosine * (bright ? 1.0 : kDim) /
                                 (distance_m * distance_m),
                         .sigma_px = kSpot_px});
    }
    return spots;
}

void CameraScene::add(const Spot& spot) {
    const double reach_px = kReach * spot.sigma_px;
    const int left = std::max(0, static_cast<int>(spot.pixel.x - reach_px));
    const int right = std::min(kCameraWidth_px - 1, static_cast<int>(spot.pixel.x + reach_px));
    const int top = std::max(0, static_cast<int>(spot.pixel.y - reach_px));
    const int bottom = std::min(kCameraHeight_px - 1, static_cast<int>(spot.pixel.y + reach_px));
    const double scale = -0.5 / (spot.sigma_px * spot.sigma_px);
    for (int y = top; y <= bottom; ++y) {
        Span& lit = lit_[static_cast<std::size_t>(y)];
        lit = {std::min(lit.begin, left), std::max(lit.end, right + 1)};
        const double dy = y - spot.pixel.y;
        for (int x = left; x <= right; ++x) {
            const double dx = x - spot.pixel.x;
            light_[static_cast<std::size_t>(y) * kCameraWidth_px + static_cast<std::size_t>(x)] +=
                static_cast<float>(spot.peak * std::exp(scale * (dx * dx + dy * dy)));
        }
    }
}

void CameraScene::develop(std::uint64_t index, std::span<std::byte> image) {
    // Most of the sensor sees nothing: its rows are pieces of one developed beforehand.
    const std::size_t places = noise_.size() - kCameraWidth_px;
    for (std::size_t y = 0; y < kCameraHeight_px; ++y) {
        float* light = light_.data() + y * kCameraWidth_px;
        std::byte* out = image.data() + y * kCameraWidth_px;
        const std::size_t at = places == 0 ? 0 : draws_.bits(index * kCameraHeight_px + y) % places;
        std::memcpy(out, dark_.data() + at, kCameraWidth_px);
        const Span lit = std::exchange(lit_[y], Span{});
        for (int x = lit.begin; x < lit.end; ++x)
            out[x] =
                developed(std::exchange(light[x], 0.0F), noise_[at + static_cast<std::size_t>(x)]);
    }
}

void CameraScene::render(const Exposure& exposure, std::span<std::byte> image) {
    for (const Spot& spot : spots(exposure)) add(spot);
    develop(exposure.index, image);
}

}  // namespace foverig
