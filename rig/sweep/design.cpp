#include "rig/sweep/design.h"

#include <cmath>
#include <numeric>

#include "simulators/motion/random.h"

namespace foverig::sweep {
namespace {

/// At a share of the knob's range or list, 0..1 exclusive.
KeyValue value_at(const Knob& knob, double share) {
    if (!knob.values.empty())
        return knob
            .values[static_cast<std::size_t>(share * static_cast<double>(knob.values.size()))];
    const double value = knob.logarithmic ? knob.from * std::pow(knob.to / knob.from, share)
                                          : std::lerp(knob.from, knob.to, share);
    if (knob.key->type == KeyType::integer) return static_cast<std::int64_t>(std::llround(value));
    return value;
}

}  // namespace

std::vector<Settings> grid(const std::vector<Knob>& knobs) {
    std::vector<Settings> all{{}};
    for (const Knob& knob : knobs) {
        std::vector<Settings> longer;
        for (const Settings& settings : all)
            for (const KeyValue& value : knob.values) {
                longer.push_back(settings);
                longer.back().emplace_back(knob.key->name, value);
            }
        all = std::move(longer);
    }
    return all;
}

std::vector<Settings> latin_hypercube(const std::vector<Knob>& knobs, std::size_t count,
                                      std::uint64_t seed) {
    std::vector<Settings> all(count);
    for (std::size_t k = 0; k < knobs.size(); ++k) {
        const std::vector<std::size_t> parts = shuffled(count, seed, 2 * k);
        const motion::Draws places(seed, 2 * k + 1);
        for (std::size_t i = 0; i < count; ++i) {
            const double share =
                (static_cast<double>(parts[i]) + places.uniform(i)) / static_cast<double>(count);
            all[i].emplace_back(knobs[k].key->name, value_at(knobs[k], share));
        }
    }
    return all;
}

std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed, std::uint64_t stream) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    const motion::Draws draws(seed, stream);
    for (std::size_t i = count; i-- > 1;) std::swap(numbers[i], numbers[draws.bits(i) % (i + 1)]);
    return numbers;
}

}  // namespace foverig::sweep
