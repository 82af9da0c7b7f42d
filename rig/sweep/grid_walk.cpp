#include "rig/sweep/grid_walk.h"

#include <fmt/format.h>

#include <cmath>

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

}  // namespace

GridWalk::GridWalk(const Sweep& sweep) : sweep_(sweep) {
    std::size_t count = 1;
    for (const Knob& knob : sweep.knobs) {
        sizes_.push_back(knob.values.size());
        count *= knob.values.size();
    }
    const std::size_t points = sweep.points.size() - sweep.price_points.size();
    if (count == 0 || (points != count && points != count + 1))
        throw UsageError(fmt::format(
            "{}: a search needs design.kind = \"grid\" and knobs that are lists of values",
            sweep.name));
    first_ = points - count;
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
