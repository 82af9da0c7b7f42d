#include "rig/session/recorded_gaze.h"

#include <algorithm>

#include "devices/gaze/gaze_source.h"
#include "devices/gaze/requests.h"
#include "simulators/replay/replayed_device.h"

namespace foverig {
namespace {

constexpr Nanoseconds kStep{10'000'000};
constexpr Nanoseconds kLongestGap{50'000'000};

}  // namespace

RecordedGaze::RecordedGaze(const Recording& recording, HostTime start, bool loop)
    : first_(recording.first()), round_(loop ? std::optional(recording.round()) : std::nullopt) {
    ManualClock clock;
    clock.sleep_until(start);
    ReplayedDevice device(recording, "gaze", clock, {.momentary_request = gaze::request::get_time});
    auto opened = gaze::GazeSource::open(device, clock);
    if (!opened) return;
    gaze::GazeSource source = std::move(opened).value();
    while (!device.at_end() && !device.damage()) {
        const HostTime until = clock.now() + kStep;
        const auto next = source.next(until);
        const auto* sample = std::get_if<GazeSample>(&next);
        if (sample == nullptr) {
            clock.sleep_until(until);
            continue;
        }
        const bool in_order = seen_.empty() || sample->host_time > seen_.back().time;
        if (in_order && sample->left.ray.valid && sample->right.ray.valid)
            seen_.push_back(
                {sample->host_time, {sample->left.ray.direction, sample->right.ray.direction}});
    }
}

std::optional<std::array<dvec3, 2>> RecordedGaze::at(HostTime time) const {
    if (round_ && time >= first_) time = first_ + (time - first_) % *round_;
    const auto after = std::lower_bound(seen_.begin(), seen_.end(), time,
                                        [](const Seen& s, HostTime t) { return s.time < t; });
    if (after == seen_.end()) return std::nullopt;
    if (after->time == time) return after->direction;
    if (after == seen_.begin()) return std::nullopt;
    const Seen& before = *(after - 1);
    if (after->time - before.time > kLongestGap) return std::nullopt;
    const double share = to_seconds(time - before.time) / to_seconds(after->time - before.time);
    std::array<dvec3, 2> directions;
    for (std::size_t eye = 0; eye < 2; ++eye)
        directions[eye] =
            glm::normalize(glm::mix(before.direction[eye], after->direction[eye], share));
    return directions;
}

}  // namespace foverig
