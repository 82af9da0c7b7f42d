#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

namespace foverig {

/// Time and rays by launch name, summed over one frame. Names are string literals, compared by
/// address first: one table a thread, merged at the frame's end.
class PassTable {
  public:
    struct Entry {
        std::string_view name;
        std::int64_t ns = 0;
        std::uint64_t launches = 0;
        std::uint64_t rays = 0;
    };

    void add(std::string_view name, std::int64_t ns, std::uint64_t rays = 0) {
        Entry& e = entry(name);
        e.ns += ns;
        e.launches += 1;
        e.rays += rays;
    }
    void merge(const PassTable& other) {
        for (const Entry& o : other.entries_) {
            Entry& e = entry(o.name);
            e.ns += o.ns;
            e.launches += o.launches;
            e.rays += o.rays;
        }
    }
    void clear() { entries_.clear(); }
    const std::vector<Entry>& entries() const { return entries_; }

  private:
    Entry& entry(std::string_view name) {
        for (Entry& e : entries_)
            if (e.name.data() == name.data() || e.name == name) return e;
        return entries_.emplace_back(Entry{name, 0, 0, 0});
    }

    std::vector<Entry> entries_;
};

}  // namespace foverig
