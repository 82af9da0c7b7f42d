#include "simulators/panel/virtual_panel.h"

#include <algorithm>
#include <cmath>

namespace foverig {
namespace {

constexpr std::uint8_t kIdleGrey = 16;  // what the corner holds before the first frame
constexpr double kJitterLimit = 3.0;    // standard deviations
// A lost read leaves the triple of an earlier frame; more in a row than this do not happen.
constexpr std::uint64_t kLongestLoss = 16;

}  // namespace

VirtualPanel::VirtualPanel(const Settings& settings)
    : settings_(settings), jitter_(settings.seed, 700), lost_reads_(settings.seed, 701) {}

HostTime VirtualPanel::vsync(std::uint64_t number) const {
    // From the number each time: adding rounded periods would drift.
    double since_s = static_cast<double>(number) / settings_.timing.refresh_hz;
    if (settings_.faults.vsync_jitter > 0.0) {
        since_s += 1e-6 * settings_.faults.vsync_jitter *
                   std::clamp(jitter_.normal(number), -kJitterLimit, kJitterLimit);
    }
    return settings_.first_vsync + from_seconds(since_s);
}

std::uint64_t VirtualPanel::first_vsync_from(HostTime at) const {
    const double periods = to_seconds(at - settings_.first_vsync) * settings_.timing.refresh_hz;
    // Jitter is far below a period, so the search starts two vsyncs early.
    auto number = static_cast<std::uint64_t>(std::max(0.0, std::floor(periods) - 2.0));
    while (vsync(number) < at) ++number;
    return number;
}

Presentation VirtualPanel::present(const FrameOnPanel& frame, HostTime submit) {
    const std::uint64_t number = first_vsync_from(submit);
    const std::lock_guard lock(mutex_);
    ++counts_.presented;
    const bool replaced = !shown_.empty() && shown_.back().vsync_number == number;
    if (replaced) {
        shown_.back().frame = frame;
        ++counts_.replaced;
    } else {
        if (!shown_.empty()) counts_.repeated += number - shown_.back().vsync_number - 1;
        shown_.push_back({number, frame});
        if (shown_.size() > kHistory) shown_.pop_front();
    }
    return {frame.frame_id, number, vsync(number), replaced};
}

std::optional<FrameOnPanel> VirtualPanel::shown_at(std::uint64_t vsync_number) const {
    const auto next =
        std::upper_bound(shown_.begin(), shown_.end(), vsync_number,
                         [](std::uint64_t n, const Shown& s) { return n < s.vsync_number; });
    if (next == shown_.begin()) return std::nullopt;
    return (next - 1)->frame;
}

std::optional<PanelSensor::Reading> VirtualPanel::reading_at(HostTime t, bool read_pixel) const {
    const std::uint64_t next = first_vsync_from(t + Nanoseconds(1));
    if (next == 0) return std::nullopt;
    std::uint64_t number = next - 1;
    if (!read_pixel)
        return Reading{static_cast<std::uint16_t>(number), vsync(number), std::nullopt};
    // The answer to the read before this vsync; where it was lost, the one before that still
    // stands.
    for (std::uint64_t loss = 0;; ++loss) {
        if (number == 0) return std::nullopt;
        --number;
        if (loss == kLongestLoss || lost_reads_.uniform(number) >= settings_.faults.lost_readback) {
            break;
        }
    }
    const std::lock_guard lock(mutex_);
    const auto frame = shown_at(number);
    return Reading{static_cast<std::uint16_t>(number), vsync(number),
                   frame ? frame->latency_level : kIdleGrey};
}

std::vector<VirtualPanel::Light> VirtualPanel::lights(double x_px, HostTime from,
                                                      HostTime to) const {
    const PanelTiming& timing = settings_.timing;
    // Light that began up to two periods earlier may still be on.
    std::uint64_t number = first_vsync_from(from - 2 * timing.period());
    std::vector<Light> seen;
    const std::lock_guard lock(mutex_);
    for (;; ++number) {
        const HostTime on = timing.written(vsync(number), x_px) + timing.pixel_settle;
        if (on >= to) return seen;
        const HostTime off = on + timing.persistence();
        const auto frame = shown_at(number);
        if (!frame || off <= from) continue;
        seen.push_back(
            {std::max(on, from), std::min(off, to), frame->frame_id, frame->latency_level});
    }
}

VirtualPanel::Counts VirtualPanel::counts() const {
    const std::lock_guard lock(mutex_);
    return counts_;
}

}  // namespace foverig
