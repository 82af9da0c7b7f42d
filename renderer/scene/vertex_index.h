#pragma once
#include <bit>
#include <cstdint>
#include <vector>

namespace foverig::scene_import {

/// Finds a vertex again by the three indices that OBJ gives each corner. Open addressing: a map of
/// nodes takes most of the time of reading an OBJ file.
class VertexIndex {
  public:
    struct Key {
        std::uint32_t position = 0;
        std::int64_t texcoord = -1;
        std::int64_t normal = -1;
        bool operator==(const Key&) const = default;
    };

    /// The number stored for `key`; stores `fresh` where there is none.
    std::uint32_t find_or_add(const Key& key, std::uint32_t fresh) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        Slot& slot = slot_for(key);
        if (slot.used) return slot.value;
        slot = {key, fresh, true};
        ++count_;
        return fresh;
    }

  private:
    struct Slot {
        Key key;
        std::uint32_t value = 0;
        bool used = false;
    };

    static std::uint64_t hash(const Key& key) {
        std::uint64_t h = key.position * 0x9E3779B97F4A7C15U;
        h = (h ^ (h >> 32U) ^ static_cast<std::uint64_t>(key.texcoord)) * 0xBF58476D1CE4E5B9U;
        h = (h ^ (h >> 32U) ^ static_cast<std::uint64_t>(key.normal)) * 0x94D049BB133111EBU;
        return h ^ (h >> 32U);
    }

    Slot& slot_for(const Key& key) {
        std::size_t i = hash(key) & (slots_.size() - 1);
        while (slots_[i].used && !(slots_[i].key == key)) i = (i + 1) & (slots_.size() - 1);
        return slots_[i];
    }

    void grow() {
        std::vector<Slot> old(slots_.empty() ? 1024 : slots_.size() * 2);
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.used) slot_for(slot.key) = slot;
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

}  // namespace foverig::scene_import
