#include "rig/sweep/search.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace foverig::sweep {
namespace {

class Walk {
  public:
    Walk(const std::vector<std::size_t>& sizes, double budget_ms,
         const std::function<Place(const GridPlace&)>& measure)
        : sizes_(sizes), budget_ms_(budget_ms), measure_(measure) {}

    void begin(const GridPlace& start) {
        best_place_ = start;
        best_ = found(start);
        steps_.back().better = true;
    }

    std::size_t knobs() const { return sizes_.size(); }

    /// As long as it helps. Returns whether it did.
    bool go(std::size_t knob, int way) {
        bool helped = false;
        while (const auto next = beside(best_place_, knob, way)) {
            if (!accept_if_better(*next)) break;
            helped = true;
        }
        return helped;
    }

    /// A step that is too dear for what it is worth, paid for by others. Returns whether it helped.
    bool exchange(std::size_t knob, int way) {
        const auto wish = beside(best_place_, knob, way);
        if (!wish) return false;
        const Place wished = found(*wish);
        if (wished.error >= best_.error || wished.ms <= budget_ms_) return false;
        for (std::size_t other = 0; other < sizes_.size(); ++other)
            for (const int back : {-1, 1})
                if (other != knob && pay(*wish, wished.ms, other, back)) return true;
        return false;
    }

    SearchResult result() const {
        return {steps_, static_cast<std::size_t>(asked_at(best_place_) - steps_.begin())};
    }

  private:
    bool is_better(const Place& a, const Place& b) const {
        const bool a_fits = a.ms <= budget_ms_;
        const bool b_fits = b.ms <= budget_ms_;
        if (a_fits != b_fits) return a_fits;
        return a_fits ? std::tie(a.error, a.ms) < std::tie(b.error, b.ms) : a.ms < b.ms;
    }

    std::optional<GridPlace> beside(GridPlace place, std::size_t knob, int way) const {
        if (way < 0 ? place[knob] == 0 : place[knob] + 1 == sizes_[knob]) return std::nullopt;
        place[knob] += static_cast<std::size_t>(way);
        return place;
    }

    /// Steps of a knob for as long as they save, until the place fits the budget.
    bool pay(GridPlace place, double ms, std::size_t knob, int way) {
        while (const auto next = beside(place, knob, way)) {
            const Place there = found(*next);
            if (there.ms >= ms) return false;
            if (there.ms <= budget_ms_) return accept_if_better(*next);
            place = *next;
            ms = there.ms;
        }
        return false;
    }

    Place found(const GridPlace& place) {
        const auto known = known_.find(place);
        if (known != known_.end()) return known->second;
        const Place measured = measure_(place);
        known_[place] = measured;
        steps_.push_back({place, measured, false});
        return measured;
    }

    bool accept_if_better(const GridPlace& place) {
        const Place there = found(place);
        if (!is_better(there, best_)) return false;
        best_ = there;
        best_place_ = place;
        steps_[static_cast<std::size_t>(asked_at(place) - steps_.begin())].better = true;
        return true;
    }

    std::vector<SearchStep>::const_iterator asked_at(const GridPlace& place) const {
        return std::find_if(steps_.begin(), steps_.end(),
                            [&](const SearchStep& step) { return step.place == place; });
    }

    const std::vector<std::size_t>& sizes_;
    double budget_ms_;
    const std::function<Place(const GridPlace&)>& measure_;
    std::map<GridPlace, Place> known_;
    std::vector<SearchStep> steps_;
    GridPlace best_place_;
    Place best_;
};

bool single_steps(Walk& walk) {
    bool helped = false;
    for (std::size_t knob = 0; knob < walk.knobs(); ++knob)
        for (const int way : {1, -1}) helped |= walk.go(knob, way);
    return helped;
}

bool exchanges(Walk& walk) {
    for (std::size_t knob = 0; knob < walk.knobs(); ++knob)
        for (const int way : {1, -1})
            if (walk.exchange(knob, way)) return true;
    return false;
}

}  // namespace

SearchResult search(const std::vector<std::size_t>& sizes, const GridPlace& start, double budget_ms,
                    const std::function<Place(const GridPlace&)>& measure) {
    Walk walk(sizes, budget_ms, measure);
    walk.begin(start);
    while (single_steps(walk) || exchanges(walk)) {
    }
    return walk.result();
}

}  // namespace foverig::sweep
