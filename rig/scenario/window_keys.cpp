#include "rig/scenario/window_keys.h"

#include "rig/scenario/key_makers.h"

namespace foverig {

void add_window_keys(std::vector<Key>& keys) {
    keys.push_back(integer_key(
        "window.width_px", "px", {160, 16384},
        "of a window (display.kind = window); its height is 9/16 of it, 1920 is the panel's own",
        [](auto& s) -> auto& { return s.window.width_px; }));
    keys.push_back(text_key(
        "window.monitor", "a monitor (foverig doctor)",
        "what display.kind = headset fills; empty: the one that looks like a DK2's panel",
        [](auto& s) -> auto& { return s.window.monitor; }));
    keys.push_back(flag_key(
        "window.wait_vsync", "swap interval 1: a frame waits for the monitor",
        [](auto& s) -> auto& { return s.window.wait_vsync; }));
    keys.push_back(flag_key(
        "window.late_warp", "turn the picture to the newest head pose just before it is drawn",
        [](auto& s) -> auto& { return s.window.late_warp; }));
    keys.push_back(flag_key(
        "window.hud", "show the HUD from the start (key H); its cost is in the frames",
        [](auto& s) -> auto& { return s.window.hud; }));
}

}  // namespace foverig
