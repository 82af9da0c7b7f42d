#pragma once
// What a sweep asks for: a base scenario, knobs, the points to try, how often and against what.
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rig/scenario/keys.h"

namespace foverig::sweep {

/// A scenario key and what it is set to: a list of values or, for a Latin hypercube, a range.
struct Knob {
    const Key* key = nullptr;
    std::vector<KeyValue> values;  ///< empty: the range
    double from = 0.0, to = 0.0;
    bool logarithmic = false;  ///< equal ratios instead of equal steps
};

using Settings = std::vector<std::pair<std::string, KeyValue>>;

struct Point {
    Settings settings;  ///< every knob, in their order; of a case: what differs from the base
    Scenario scenario;  ///< base with these
    std::size_t of_case = 0;
    std::string variant{};  ///< its name, where there are cases
};

/// What is shown, where a sweep shows several things: a scene and its light. Every case has the
/// same variants and a reference of its own.
struct Case {
    std::string name;
    std::string note;  ///< what stands in for what, or empty
    RenderSettings reference;
};

/// Which frames of the flight are shown: all, or stretches that are spread over it evenly. Each
/// begins with a warm-up of its own.
struct Stretches {
    std::size_t count = 1;
    std::size_t frames = 0;  ///< of each, warm-up included; 0: all of the flight
};

enum class Order {
    abba,   ///< forward, backward, forward, ...: a machine that drifts steadily harms no point
    random  ///< shuffled anew for each repetition
};

struct Sweep {
    std::string name;  ///< of the file, without .toml
    Scenario base;     ///< the current default
    RenderSettings reference;
    std::vector<Knob> knobs;
    std::vector<Case> cases;  ///< empty: the base alone, and knobs
    std::vector<Point> points;
    std::optional<std::size_t> default_point;  ///< the one that is `base`; with cases none is
    int repetitions = 3;                       ///< runs of each point
    Order order = Order::abba;
    std::uint64_t seed = 1;          ///< of a random order and of a Latin hypercube
    std::size_t warm_up_frames = 3;  ///< of every run: kept in the record, left out of the result
    std::string error = "acuity";    ///< of error_names(): the vertical axis
    bool errors_at_truth = false;    ///< where the eyes looked, not where the tracker said
    std::vector<std::string> over;   ///< knobs to draw the error over, a chart each
    std::vector<double> within;      ///< errors for which to name the cheapest setting
    Stretches stretches;
    nlohmann::json paper;  ///< what a paper found of the same, checked (read_paper.h); null: none
    bool prices = false;   ///< also the base without each of its effects
    /// The points of those, by effect; behind all others (prices.h).
    std::map<std::string, std::size_t> price_points;

    /// Frames cost what the scenario says: times are modelled and nothing depends on the machine.
    bool fixed_cost() const { return base.cost != "measured"; }
    const RenderSettings& reference_of(const Point& point) const {
        return cases.empty() ? reference : cases[point.of_case].reference;
    }
};

/// The base with those settings. Throws UsageError where a value cannot be, or where they do not
/// fit each other; the text begins with the settings.
Scenario with_settings(const Scenario& base, const Settings& settings);

/// "foveation.p_min = 0.05, lighting.ao_samples = 4".
std::string text_of(const Settings& settings);

}  // namespace foverig::sweep
