#include "rig/sweep/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "rig/failure.h"
#include "rig/sweep/design.h"

namespace foverig::sweep {
namespace {

constexpr std::size_t kMostShards = 10'000;
constexpr std::uint64_t kOrderStream = 1'000'000;  // beyond those of the design

std::vector<std::size_t> order_of(const Sweep& sweep, std::size_t points, int repetition) {
    if (sweep.order == Order::random)
        return shuffled(points, sweep.seed, kOrderStream + static_cast<std::uint64_t>(repetition));
    std::vector<std::size_t> order(points);
    for (std::size_t i = 0; i < points; ++i) order[i] = repetition % 2 == 0 ? i : points - 1 - i;
    return order;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* const end = text.data() + text.size();
    const auto [slash, bad_index] = std::from_chars(text.data(), end, shard.index);
    if (bad_index == std::errc{} && slash != end && *slash == '/') {
        const auto [stop, bad_count] = std::from_chars(slash + 1, end, shard.count);
        if (bad_count == std::errc{} && stop == end && shard.index < shard.count &&
            shard.count <= kMostShards)
            return shard;
    }
    throw UsageError(
        fmt::format("--shard {}: expected i/n, as in 0/2 and 1/2 for the two halves", text));
}

std::vector<Job> jobs_of(const Sweep& sweep, const Shard& shard) {
    std::vector<std::size_t> points;
    for (std::size_t i = shard.index; i < sweep.points.size(); i += shard.count)
        points.push_back(i);
    std::vector<Job> jobs;
    for (const std::size_t point : points) jobs.push_back({.point = point});
    if (sweep.fixed_cost()) return jobs;
    for (int repetition = 0; repetition < sweep.repetitions; ++repetition)
        for (const std::size_t i : order_of(sweep, points.size(), repetition))
            jobs.push_back({points[i], repetition});
    return jobs;
}

}  // namespace foverig::sweep
