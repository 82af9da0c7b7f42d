#include "renderer/trace/build/binned_sah.h"

#include <algorithm>
#include <numeric>

namespace foverig {
namespace {

constexpr int kBins = 32;

struct Bin {
    Box box;
    std::size_t count = 0;

    void add(const Bin& other) {
        box.grow(other.box);
        count += other.count;
    }
    float cost() const { return box.half_area_m2() * static_cast<float>(count); }
};

struct Range {
    std::size_t node;
    std::size_t begin;
    std::size_t end;
    int level;
};

class Builder {
  public:
    Builder(std::span<const Box> boxes, int sah_levels) : boxes_(boxes), sah_levels_(sah_levels) {
        order_.resize(boxes.size());
        std::iota(order_.begin(), order_.end(), 0U);
        middles_.reserve(boxes.size());
        for (const Box& box : boxes) middles_.push_back(box.empty() ? vec3(0.0F) : box.middle_m());
    }

    BinaryBvh build() {
        if (boxes_.empty()) return {};
        nodes_.reserve(2 * boxes_.size() - 1);
        nodes_.emplace_back();
        std::vector<Range> open{{0, 0, boxes_.size(), 0}};
        while (!open.empty()) {
            const Range range = open.back();
            open.pop_back();
            bound(range);
            if (range.end - range.begin == 1) {
                nodes_[range.node].primitive = order_[range.begin];
                continue;
            }
            const std::size_t middle = split(range);
            const std::size_t child = nodes_.size();
            nodes_[range.node].first_child = static_cast<std::uint32_t>(child);
            nodes_.resize(child + 2);
            open.push_back({child + 1, middle, range.end, range.level + 1});
            open.push_back({child, range.begin, middle, range.level + 1});
        }
        return std::move(nodes_);
    }

  private:
    void bound(const Range& range) {
        Box& box = nodes_[range.node].box;
        middles_box_ = {};
        for (std::size_t i = range.begin; i < range.end; ++i) {
            box.grow(boxes_[order_[i]]);
            middles_box_.grow(middles_[order_[i]]);
        }
    }

    int bin_of(std::uint32_t primitive, int axis, float bins_per_m) const {
        const float at = (middles_[primitive][axis] - middles_box_.min_m[axis]) * bins_per_m;
        return static_cast<int>(clamp_to(at, 0.0F, kBins - 1.0F));
    }

    /// First of the range's second half.
    std::size_t split(const Range& range) {
        const vec3 extent = middles_box_.max_m - middles_box_.min_m;
        int best_axis = -1;
        int best_bin = 0;
        float best_cost = std::numeric_limits<float>::infinity();
        for (int axis = 0; axis < 3 && range.level < sah_levels_; ++axis) {
            const float bins_per_m = kBins / extent[axis];
            if (!(extent[axis] > 0.0F) || !(bins_per_m < 3.0e38F)) continue;
            std::array<Bin, kBins> bins;
            for (std::size_t i = range.begin; i < range.end; ++i)
                bins[static_cast<std::size_t>(bin_of(order_[i], axis, bins_per_m))].add(
                    {boxes_[order_[i]], 1});
            std::array<float, kBins> right_cost{};
            Bin sum;
            for (std::size_t b = kBins - 1; b > 0; --b) {
                sum.add(bins[b]);
                right_cost[b] = sum.cost();
            }
            sum = {};
            for (std::size_t b = 1; b < kBins; ++b) {
                sum.add(bins[b - 1]);
                const float cost = sum.cost() + right_cost[b];
                if (cost < best_cost && sum.count > 0 && sum.count < range.end - range.begin) {
                    best_cost = cost;
                    best_axis = axis;
                    best_bin = static_cast<int>(b);
                }
            }
        }
        if (best_axis < 0) return halve(range, extent);
        const float bins_per_m = kBins / extent[best_axis];
        const auto second = std::stable_partition(at(range.begin), at(range.end), [&](auto p) {
            return bin_of(p, best_axis, bins_per_m) < best_bin;
        });
        return static_cast<std::size_t>(second - order_.begin());
    }

    std::size_t halve(const Range& range, const vec3& extent) {
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const std::size_t middle = (range.begin + range.end) / 2;
        std::nth_element(at(range.begin), at(middle), at(range.end), [&](auto a, auto b) {
            const float x = middles_[a][axis];
            const float y = middles_[b][axis];
            return x < y || (x == y && a < b);
        });
        return middle;
    }

    std::vector<std::uint32_t>::iterator at(std::size_t i) {
        return order_.begin() + static_cast<std::ptrdiff_t>(i);
    }

    std::span<const Box> boxes_;
    int sah_levels_;
    std::vector<std::uint32_t> order_;
    std::vector<vec3> middles_;
    Box middles_box_;  ///< of the range at hand
    BinaryBvh nodes_;
};

}  // namespace

BinaryBvh build_binned(std::span<const Box> boxes, int sah_levels) {
    return Builder(boxes, sah_levels).build();
}

BinaryBvh build_binned_triangles(std::span<const Corners> triangles) {
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const Corners& corners : triangles) boxes.push_back(box_of(corners));
    return build_binned(boxes);
}

}  // namespace foverig
