#pragma once
// Runs as a machine makes them: a scene whose cost changes as the camera flies, a cold start,
// frames that depend on the one before, late ones, runs that differ as wholes, and a machine that
// drifts.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "rig/report/run_data.h"
#include "simulators/motion/random.h"

namespace foverig::compare::test {

struct Machine {
    std::uint64_t seed = 1;
    double run_sigma = 0.005;   ///< of whole runs
    double drift = 0.0;         ///< from the first run to the last, share
    double frame_sigma = 0.03;  ///< of frames, autocorrelation 0.6
    double late_share = 0.02;   ///< of frames that take up to four times as long
};

/// The `turn`-th of `turns` runs on that machine, of a program that takes `slower` times as long.
inline report::RunData run_on(const Machine& machine, int turn, int turns, double slower) {
    const motion::Draws draws(machine.seed, static_cast<std::uint64_t>(turn));
    const double share = static_cast<double>(turn) / turns;
    const double level = 12.0 * slower * (1.0 + machine.drift * share) *
                         std::exp(machine.run_sigma * draws.normal(1'000'000));
    report::RunData run;
    run.folder = "run-" + std::to_string(turn);
    run.frames.frames = 300;
    run.frames.order = {"frame", "frame_time_ms", "pass.trace_ms"};
    double noise = 0.0;
    for (std::uint64_t i = 0; i < run.frames.frames; ++i) {
        const auto at = static_cast<double>(i);
        noise = 0.6 * noise + 0.8 * draws.normal(4 * i);
        double ms = level * (1.0 + 0.15 * std::sin(2.0 * std::numbers::pi * at / 90.0)) *
                    (1.0 + machine.frame_sigma * noise) * (1.0 + std::exp(-at));
        if (draws.uniform(4 * i + 1) < machine.late_share) ms *= draws.uniform(4 * i + 2, 1.0, 4.0);
        run.frames.columns["frame"].push_back(at);
        run.frames.columns["frame_time_ms"].push_back(ms);
        run.frames.columns["pass.trace_ms"].push_back(0.7 * ms);
    }
    return run;
}

struct Sides {
    std::vector<report::RunData> base, fresh;
};

/// As many runs a side, in turns: base new new base base new ...
inline Sides in_turns(const Machine& machine, int runs, double slower) {
    Sides sides;
    for (int turn = 0; turn < 2 * runs; ++turn) {
        const bool is_base = turn % 4 == 0 || turn % 4 == 3;
        (is_base ? sides.base : sides.fresh)
            .push_back(run_on(machine, turn, 2 * runs, is_base ? 1.0 : slower));
    }
    return sides;
}

}  // namespace foverig::compare::test
