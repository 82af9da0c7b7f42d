#include "devices/camera/head_camera.h"

namespace foverig::camera {
namespace {

constexpr Nanoseconds kFlash{350'000};  // what Dk2ImuSource asks for

}  // namespace

Result<std::unique_ptr<HeadCamera>> HeadCamera::open(Transport& transport,
                                                     std::vector<dk2::Led> leds) {
    auto source = TrackerCamera::open(transport, Sync::headset);
    if (!source) return source.error();
    return std::unique_ptr<HeadCamera>(new HeadCamera(std::move(source).value(), std::move(leds)));
}

HeadCamera::HeadCamera(TrackerCamera source, std::vector<dk2::Led> leds)
    : source_(std::move(source)), pairing_(kFlash), tracker_(std::move(leds), source_.lens()) {}

void HeadCamera::add(std::span<const dk2::LedExposure> exposures) {
    for (const dk2::LedExposure& exposure : exposures) pairing_.add(exposure);
}

Next<PoseFix> HeadCamera::next(HostTime deadline, const Expected& expected) {
    while (true) {
        auto got = source_.next(deadline);
        if (const auto* frame = std::get_if<CameraFrame>(&got)) {
            if (const auto fix = fix_of(*frame, expected)) return *fix;
        } else if (auto* fault = std::get_if<Fault>(&got)) {
            return std::move(*fault);
        } else if (std::holds_alternative<Timeout>(got)) {
            return Timeout{};
        } else {
            return EndOfStream{};
        }
    }
}

std::optional<PoseFix> HeadCamera::fix_of(const CameraFrame& frame, const Expected& expected) {
    const auto shown = pairing_.of(frame.stamp);
    if (!shown) {
        ++unpaired_;
        return std::nullopt;
    }
    auto guess = expected(shown->middle_device);
    if (!guess) guess = last_pose_;
    last_pose_.reset();
    const auto solved = tracker_.see(frame.image(), shown->number, shown->pattern, guess);
    if (!solved) return std::nullopt;
    last_pose_ = solved->camera_from_imu;
    return PoseFix{.taken_device = shown->middle_device,
                   .taken = shown->middle,
                   .arrival = frame.arrival,
                   .camera_from_imu = solved->camera_from_imu,
                   .covariance = solved->covariance,
                   .rms_px = solved->rms_px,
                   .points = static_cast<int>(solved->inliers.size())};
}

}  // namespace foverig::camera
