#include "devices/camera/blob_tracks.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foverig::camera {
namespace {

constexpr int kOldest_frames = 20;
constexpr double kLeastRatio = 1.1;  // OUVRT's: less is no edge
constexpr int kRounds = 3;           // split into bright and dim, take the common slope off, again
constexpr double kFastest_px = 40.0;

/// Means of both classes and the slope over time that they share.
double common_slope(const std::array<double, dk2::kPatternFrames>& level,
                    const std::array<double, dk2::kPatternFrames>& time, std::uint32_t bits) {
    double slope_top = 0, slope_bottom = 0;
    for (const bool bright : {false, true}) {
        double n = 0, mean_t = 0, mean_l = 0;
        for (std::size_t i = 0; i < level.size(); ++i) {
            if ((bits >> i & 1u) != bright) continue;
            n += 1;
            mean_t += time[i];
            mean_l += level[i];
        }
        if (n < 2) continue;
        for (std::size_t i = 0; i < level.size(); ++i) {
            if ((bits >> i & 1u) != bright) continue;
            slope_top += (time[i] - mean_t / n) * (level[i] - mean_l / n);
            slope_bottom += (time[i] - mean_t / n) * (time[i] - mean_t / n);
        }
    }
    return slope_bottom > 0 ? slope_top / slope_bottom : 0;
}

}  // namespace

std::optional<std::uint16_t> code_of(const BlinkHistory& history, int newest_frame) {
    std::array<double, dk2::kPatternFrames> level{}, time{};
    for (std::size_t i = 0; i < level.size(); ++i) {
        const auto& seen = history.seen[i];
        if (newest_frame - seen.frame >= kOldest_frames) return std::nullopt;
        level[i] = seen.log_brightness;
        time[i] = seen.frame - newest_frame;
    }
    std::uint32_t bits = 0;
    double slope = 0, gap = 0;
    for (int round = 0; round < kRounds; ++round) {
        auto flat = level;
        for (std::size_t i = 0; i < flat.size(); ++i) flat[i] -= slope * time[i];
        const auto [low, high] = std::minmax_element(flat.begin(), flat.end());
        const double middle = 0.5 * (*low + *high);
        double highest_dim = *low, lowest_bright = *high;
        bits = 0;
        for (std::size_t i = 0; i < flat.size(); ++i) {
            if (flat[i] > middle) {
                bits |= 1u << i;
                lowest_bright = std::min(lowest_bright, flat[i]);
            } else {
                highest_dim = std::max(highest_dim, flat[i]);
            }
        }
        gap = lowest_bright - highest_dim;
        slope = common_slope(level, time, bits);
    }
    if (gap < std::log(kLeastRatio)) return std::nullopt;
    return static_cast<std::uint16_t>(bits);
}

std::optional<std::size_t> led_of(std::uint16_t code, std::span<const dk2::Led> leds) {
    for (std::size_t i = 0; i < leds.size(); ++i) {
        if (std::popcount(static_cast<unsigned>(code ^ leds[i].code)) <= 1) return i;
    }
    return std::nullopt;
}

std::vector<std::optional<std::size_t>> BlobTracks::pair_up(std::span<const Blob> blobs,
                                                            int frame) const {
    // Both must be each other's nearest: spots that cross are left alone for a frame.
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> nearest_blob(tracks_.size(), kNone);
    std::vector<std::size_t> nearest_track(blobs.size(), kNone);
    std::vector<double> blob_gap(blobs.size(), config_.gate_px);
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
        double track_gap = config_.gate_px;
        for (std::size_t b = 0; b < blobs.size(); ++b) {
            const double gap = glm::distance(tracks_[t].expected_px(frame), blobs[b].center_px);
            if (gap < track_gap) {
                track_gap = gap;
                nearest_blob[t] = b;
            }
            if (gap < blob_gap[b]) {
                blob_gap[b] = gap;
                nearest_track[b] = t;
            }
        }
    }
    std::vector<std::optional<std::size_t>> track_of(blobs.size());
    for (std::size_t b = 0; b < blobs.size(); ++b) {
        const std::size_t t = nearest_track[b];
        if (t != kNone && nearest_blob[t] == b) track_of[b] = t;
    }
    return track_of;
}

std::vector<TrackedBlob> BlobTracks::follow(std::span<const Blob> blobs, int frame,
                                            std::uint8_t pattern) {
    const auto track_of = pair_up(blobs, frame);
    std::vector<TrackedBlob> out;
    for (std::size_t b = 0; b < blobs.size(); ++b) {
        std::size_t t = 0;
        if (track_of[b]) {
            t = *track_of[b];
            Track& track = tracks_[t];
            const double frames = std::max(1, frame - track.last_frame);
            const dvec2 speed_px = (blobs[b].center_px - track.place_px) / frames;
            track.speed_px = glm::length(speed_px) < kFastest_px ? speed_px : dvec2(0);
        } else {
            t = tracks_.size();
            tracks_.emplace_back();
        }
        Track& track = tracks_[t];
        track.place_px = blobs[b].center_px;
        track.last_frame = frame;
        if (pattern < dk2::kPatternFrames && blobs[b].brightness > 0) {
            track.history.seen[pattern] = {std::log(blobs[b].brightness), frame};
            const auto code = code_of(track.history, frame);
            track.led = code ? led_of(*code, leds_) : std::nullopt;
        }
        out.push_back({blobs[b], track.led});
    }
    std::erase_if(tracks_, [&](const Track& track) {
        return frame - track.last_frame > config_.forget_after;
    });
    return out;
}

}  // namespace foverig::camera
