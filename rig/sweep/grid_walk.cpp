#include "rig/sweep/grid_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "rig/failure.h"

namespace foverig::sweep {
namespace {

std::optional<double> number_of(const KeyValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    return std::nullopt;
}

/// Equal, else the nearest number, else the first.
std::size_t nearest_value(const Knob& knob, const KeyValue& current) {
    std::size_t nearest = 0;
    double distance = INFINITY;
    for (std::size_t i = 0; i < knob.values.size(); ++i) {
        if (knob.values[i] == current) return i;
        const auto a = number_of(knob.values[i]);
        const auto b = number_of(current);
        if (!a || !b || std::abs(*a - *b) >= distance) continue;
        distance = std::abs(*a - *b);
        nearest = i;
    }
    return nearest;
}

/// Of what is no number any order will do.
bool is_in_order(const Knob& knob) {
    std::vector<double> numbers;
    for (const KeyValue& value : knob.values)
        if (const auto number = number_of(value)) numbers.push_back(*number);
    return std::is_sorted(numbers.begin(), numbers.end()) ||
           std::is_sorted(numbers.rbegin(), numbers.rend());
}

}  // namespace

GridWalk::GridWalk(const Sweep& sweep) : sweep_(sweep) {
    for (const Knob& knob : sweep.knobs) {
        if (!is_in_order(knob))
            throw UsageError(fmt::format(
                "{}: the values of {} go up and down; expected them in rising or falling order, as "
                "the search goes from one to the next",
                sweep.name, knob.key->name));
        sizes_.push_back(knob.values.size());
    }
    const std::size_t points = sweep.points.size() - sweep.price_points.size();
    first_ = points - std::min(points, count());
    if (count() == 0 || points > count() + 1 || !holds_all())
        throw UsageError(fmt::format(
            "{}: a search needs design.kind = \"grid\" and knobs that are lists of values",
            sweep.name));
}

/// A Latin hypercube of lists may have as many points as the grid.
bool GridWalk::holds_all() const {
    for (std::size_t index = 0; index < count(); ++index) {
        if (first_ + index >= sweep_.points.size()) return false;
        std::size_t left = index;
        for (std::size_t knob = sizes_.size(); knob-- > 0; left /= sizes_[knob]) {
            const KeyValue& value = sweep_.knobs[knob].values[left % sizes_[knob]];
            if (!(sweep_.points[first_ + index].settings[knob].second == value)) return false;
        }
    }
    return true;
}

std::size_t GridWalk::count() const {
    return std::accumulate(sizes_.begin(), sizes_.end(), std::size_t{1}, std::multiplies<>());
}

GridPlace GridWalk::start() const {
    GridPlace place;
    for (const Knob& knob : sweep_.knobs)
        place.push_back(nearest_value(knob, knob.key->get(sweep_.base)));
    return place;
}

std::size_t GridWalk::point_at(const GridPlace& place) const {
    std::size_t index = 0;
    for (std::size_t knob = 0; knob < place.size(); ++knob)
        index = index * sizes_[knob] + place[knob];
    return first_ + index;
}

}  // namespace foverig::sweep
