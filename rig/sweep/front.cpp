#include "rig/sweep/front.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace foverig::sweep {

std::vector<std::size_t> front_of(const std::vector<Place>& places) {
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(places[a].ms, places[a].error) < std::tie(places[b].ms, places[b].error);
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || places[i].error < places[front.back()].error) front.push_back(i);
    return front;
}

std::optional<std::size_t> cheapest_within(const std::vector<Place>& places,
                                           const std::vector<std::size_t>& front, double error) {
    const auto found = std::find_if(front.begin(), front.end(),
                                    [&](std::size_t i) { return places[i].error <= error; });
    return found == front.end() ? std::nullopt : std::optional(*found);
}

}  // namespace foverig::sweep
