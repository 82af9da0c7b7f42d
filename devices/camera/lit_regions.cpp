#include <algorithm>

#include "devices/camera/detail/lit_regions.h"

namespace foverig::camera::detail {
namespace {

constexpr int kBlock_px = 32;

struct Run {
    int first = 0, last = 0;
    std::size_t region = 0;
};

/// Nearly all of an image is dark: whole blocks are passed over by their highest level.
void runs_of_row(const std::uint8_t* row, int width_px, int threshold, std::vector<Run>& runs) {
    runs.clear();
    bool in_run = false;
    for (int x = 0; x < width_px;) {
        if (!in_run && x + kBlock_px <= width_px) {
            std::uint8_t most = 0;
            for (int i = 0; i < kBlock_px; ++i) most = std::max(most, row[x + i]);
            if (most <= threshold) {
                x += kBlock_px;
                continue;
            }
        }
        const int end = std::min(x + kBlock_px, width_px);
        for (; x < end; ++x) {
            const bool lit = row[x] > threshold;
            if (lit && !in_run) runs.push_back({.first = x});
            if (lit) runs.back().last = x;
            in_run = lit;
        }
    }
}

class Regions {
  public:
    void add(Run& run, std::span<const Run> above, const std::uint8_t* row, int y) {
        bool joined = false;
        for (const Run& other : above) {
            if (other.first > run.last + 1) break;
            if (other.last + 1 < run.first) continue;
            if (joined) {
                merge(run.region, other.region);
            } else {
                run.region = root(other.region);
                joined = true;
            }
        }
        if (!joined) {
            run.region = all_.size();
            parent_.push_back(run.region);
            all_.push_back({.left = run.first, .right = run.last, .top = y, .bottom = y});
        }
        Region& region = all_[root(run.region)];
        region.left = std::min(region.left, run.first);
        region.right = std::max(region.right, run.last);
        region.bottom = y;
        region.area_px += run.last - run.first + 1;
        for (int x = run.first; x <= run.last; ++x) {
            region.peak = std::max(region.peak, static_cast<int>(row[x]));
        }
    }

    std::vector<Region> take() const {
        std::vector<Region> out;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (parent_[i] == i) out.push_back(all_[i]);
        }
        return out;
    }

  private:
    std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void merge(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return;
        const std::size_t kept = std::min(a, b), gone = std::max(a, b);
        parent_[gone] = kept;
        Region& into = all_[kept];
        const Region& from = all_[gone];
        into.left = std::min(into.left, from.left);
        into.right = std::max(into.right, from.right);
        into.top = std::min(into.top, from.top);
        into.bottom = std::max(into.bottom, from.bottom);
        into.area_px += from.area_px;
        into.peak = std::max(into.peak, from.peak);
    }

    std::vector<Region> all_;
    std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<Region> lit_regions(const GreyView& image, int threshold) {
    Regions regions;
    std::vector<Run> above, here;
    for (int y = 0; y < image.height_px; ++y) {
        const std::uint8_t* row = image.row(y);
        runs_of_row(row, image.width_px, threshold, here);
        for (Run& run : here) regions.add(run, above, row, y);
        std::swap(above, here);
    }
    return regions.take();
}

}  // namespace foverig::camera::detail
