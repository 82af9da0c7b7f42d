#include "simulators/gaze/worsened_gaze.h"

#include <cmath>

#include "simulators/gaze/tracker_geometry.h"
#include "simulators/motion/eye_motion.h"
#include "simulators/motion/random.h"

namespace foverig {
namespace {

constexpr std::uint64_t kStream = 820;  // beyond those of the simulated tracker

/// By angles as motion::gaze_of has them; what was not measured stays so.
void turn(gaze::Vec3f& on_the_wire, const dvec2& by_deg) {
    const dvec3 direction(-on_the_wire[0], on_the_wire[1], -on_the_wire[2]);
    if (!std::isfinite(glm::length(direction))) return;
    on_the_wire = on_wire(motion::direction_of(motion::gaze_of(direction) + by_deg));
}

}  // namespace

NextPacket WorsenedGaze::next(HostTime deadline) {
    NextPacket got = tracker_.next(deadline - worsening_.added_latency);
    if (std::holds_alternative<Timeout>(got)) clock_.sleep_until(deadline);
    auto* packet = std::get_if<Packet>(&got);
    if (packet == nullptr) return got;
    packet->arrival += worsening_.added_latency;
    clock_.sleep_until(packet->arrival);
    packet->bytes = worsened(std::move(packet->bytes).release());
    return got;
}

std::vector<std::byte> WorsenedGaze::worsened(std::vector<std::byte> bytes) const {
    Result<gaze::Frame> decoded = gaze::decode_frame(bytes);
    if (!decoded) return bytes;
    gaze::Frame frame = std::move(decoded).value();
    return std::visit(
        [&](auto& f) {
            f.header.queued_ns += static_cast<std::uint64_t>(worsening_.added_latency.count());
            if constexpr (std::is_same_v<std::decay_t<decltype(f)>, gaze::SampleFrame>)
                add_noise(f);
            const auto encoded = f.encode();
            return std::vector<std::byte>(encoded.begin(), encoded.end());
        },
        frame);
}

void WorsenedGaze::add_noise(gaze::SampleFrame& frame) const {
    if (worsening_.added_noise_deg <= 0.0) return;
    const motion::Draws draws(worsening_.seed, kStream);
    const std::uint64_t first = std::uint64_t{4} * frame.camera_frame;
    const auto drawn = [&](std::uint64_t i) {
        return worsening_.added_noise_deg * draws.normal(first + i);
    };
    const dvec2 left(drawn(0), drawn(1));
    const dvec2 right(drawn(2), drawn(3));
    turn(frame.left.direction, left);
    turn(frame.right.direction, right);
    turn(frame.direction, 0.5 * (left + right));
}

Status WorsenedGaze::control_set(std::uint8_t id, std::uint16_t value,
                                 std::span<const std::byte> data) {
    return tracker_.control_set(id, value, data);
}

Result<std::vector<std::byte>> WorsenedGaze::control_get(std::uint8_t id, std::uint16_t value,
                                                         std::size_t size) {
    return tracker_.control_get(id, value, size);
}

}  // namespace foverig
