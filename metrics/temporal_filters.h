#pragma once
#include <vector>

namespace foverig::metrics {

/// The eye's two channels over time as filters of frames, the newest first (Mantiuk et al. 2021,
/// "FovVideoVDP", 4.2): sustained (low pass, sums to 1) and transient (its derivative, about 5 Hz,
/// next to nothing of a still picture). They reach a quarter of a second back.
struct TemporalFilters {
    /// Of frames at that rate, at least 8 Hz. Throws std::invalid_argument below.
    explicit TemporalFilters(double frames_per_s);

    std::vector<double> sustained, transient;
};

}  // namespace foverig::metrics
