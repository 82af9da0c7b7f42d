#include "rig/session/recorded_gaze.h"

#include <algorithm>
#include <vector>

#include "devices/gaze/gaze_source.h"
#include "devices/gaze/requests.h"
#include "simulators/replay/replayed_device.h"

namespace foverig {
namespace {

constexpr Nanoseconds kStep{10'000'000};
constexpr Nanoseconds kLongestGap{50'000'000};

struct Seen {
    HostTime time;
    std::array<dvec3, 2> direction;
};

}  // namespace

class RecordedGaze::Reader {
  public:
    Reader(const Recording& recording, HostTime start)
        : device_(recording, "gaze", clock_, {.momentary_request = gaze::request::get_time}) {
        clock_.sleep_until(start);
        auto opened = gaze::GazeSource::open(device_, clock_, {.rate_hz = 0});
        if (opened) source_ = std::move(opened).value();
    }

    /// In order of time, up to the first that is not before `time`, or all there are.
    const std::vector<Seen>& seen_until(HostTime time) {
        while (source_ && (seen_.empty() || seen_.back().time < time) && !device_.at_end() &&
               !device_.damage()) {
            read_on();
        }
        return seen_;
    }

  private:
    void read_on() {
        const HostTime until = clock_.now() + kStep;
        const auto next = source_->next(until);
        const auto* sample = std::get_if<GazeSample>(&next);
        if (sample == nullptr) {
            clock_.sleep_until(until);
            return;
        }
        const bool in_order = seen_.empty() || sample->host_time > seen_.back().time;
        if (in_order && sample->left.ray.valid && sample->right.ray.valid)
            seen_.push_back(
                {sample->host_time, {sample->left.ray.direction, sample->right.ray.direction}});
    }

    ManualClock clock_;
    ReplayedDevice device_;
    std::optional<gaze::GazeSource> source_;  // none: the recording's tracker cannot be opened
    std::vector<Seen> seen_;
};

RecordedGaze::RecordedGaze(const Recording& recording, HostTime start, bool loop)
    : reader_(std::make_unique<Reader>(recording, start)),
      first_(recording.first()),
      round_(loop ? std::optional(recording.round()) : std::nullopt) {}

RecordedGaze::~RecordedGaze() = default;

std::optional<std::array<dvec3, 2>> RecordedGaze::at(HostTime time) const {
    if (round_ && time >= first_) time = first_ + (time - first_) % *round_;
    const std::vector<Seen>& seen = reader_->seen_until(time);
    const auto after = std::lower_bound(seen.begin(), seen.end(), time,
                                        [](const Seen& s, HostTime t) { return s.time < t; });
    if (after == seen.end()) return std::nullopt;
    if (after->time == time) return after->direction;
    if (after == seen.begin()) return std::nullopt;
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
