#include "rig/scenario/governor_keys.h"

#include "rig/scenario/key_makers.h"

namespace foverig {

void add_governor_keys(std::vector<Key>& keys) {
    keys.push_back(text_key(
        "governor.front", "a sweep's pareto.json",
        "walk its front at run time so that frames fit a VSync; empty: no governor",
        [](auto& s) -> auto& { return s.governor.front; }));
    keys.push_back(text_key(
        "governor.settings", "\"MS: KEY = VALUE, ...; MS: ...\", cheapest first",
        "walk these settings instead of a file's",
        [](auto& s) -> auto& { return s.governor.settings; }));
    keys.push_back(number_key(
        "governor.headroom", "", {0.0, 0.9}, "share of a VSync that the governor keeps free",
        [](auto& s) -> auto& { return s.governor.headroom; }));
    keys.push_back(integer_key(
        "governor.patience_frames", "", {1, 100'000},
        "frames in a row with room for the next dearer setting before it is taken",
        [](auto& s) -> auto& { return s.governor.patience_frames; }));
}

}  // namespace foverig
