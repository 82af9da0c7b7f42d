#include "rig/scenario/see_through_keys.h"

#include <algorithm>
#include <cmath>

#include "devices/hardware/identity.h"
#include "rig/scenario/key_makers.h"

namespace foverig {
namespace {

Key which_camera_key() {
    Key key = text_key(
        "see_through.camera", "sim, a node as /dev/video0, a USB identifier as 046d:0825, or empty",
        "camera on the headset whose picture a window shows where rays met nothing; empty: none",
        [](auto& s) -> auto& { return s.see_through.camera; });
    key.set = [expected = key.expected](Scenario& s,
                                        const KeyValue& v) -> std::optional<std::string> {
        const auto& text = std::get<std::string>(v);
        if (!text.empty() && text != "sim" && !text.starts_with("/") && !hardware::usb_id_of(text))
            return expected;
        s.see_through.camera = text;
        return std::nullopt;
    };
    return key;
}

/// `count` finite numbers, or none.
Key exactly(std::size_t count, Key key) {
    key.set = [count, set = key.set, expected = key.expected](
                  Scenario& s, const KeyValue& v) -> std::optional<std::string> {
        const auto& numbers = std::get<std::vector<double>>(v);
        const bool finite = std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
        if (numbers.size() > count || !finite) return expected;
        return set(s, v);
    };
    return key;
}

Key intrinsics_key() {
    Key key = exactly(4, numbers_key(
                             "see_through.lens_px", 4,
                             "four numbers [fx, fy, cx, cy] (px), fx and fy above 0, or []",
                             "its focal lengths and centre, at width_px and height_px (other sizes "
                             "in proportion); []: by fov_deg, in the middle",
                             [](auto& s) -> auto& { return s.see_through.lens_px; }));
    key.set = [set = key.set, expected = key.expected](
                  Scenario& s, const KeyValue& v) -> std::optional<std::string> {
        const auto& px = std::get<std::vector<double>>(v);
        if (px.size() >= 2 && !(px[0] > 0.0 && px[1] > 0.0)) return expected;
        return set(s, v);
    };
    return key;
}

}  // namespace

void add_see_through_keys(std::vector<Key>& keys) {
    keys.push_back(which_camera_key());
    keys.push_back(number_key(
        "see_through.fov_deg", "deg", {1.0, 170.0},
        "its horizontal field of view before distortion, where lens_px tells nothing",
        [](auto& s) -> auto& { return s.see_through.fov_deg; }));
    keys.push_back(intrinsics_key());
    keys.push_back(
        exactly(5, numbers_key(
                       "see_through.distortion", 5, "five numbers [k1, k2, p1, p2, k3], or []",
                       "its lens' distortion (Brown, in OpenCV's order); []: none",
                       [](auto& s) -> auto& { return s.see_through.distortion; })));
    keys.push_back(
        exactly(4, numbers_key(
                       "see_through.fisheye", 4, "four numbers [k1, k2, k3, k4], or []",
                       "the distortion of a fisheye (OpenCV's model; [0, 0, 0, 0]: equidistant); "
                       "[]: it is none",
                       [](auto& s) -> auto& { return s.see_through.fisheye; })));
    keys.push_back(number_key(
        "see_through.latency_ms", "ms", {0.0, 1000.0},
        "from the middle of its exposure to the kernel's stamp, which no clock shows",
        [](auto& s) -> auto& { return s.see_through.latency_ms; }));
    keys.push_back(integer_key(
        "see_through.width_px", "px", {16, 16384},
        "asked of it; the nearest that it offers is taken",
        [](auto& s) -> auto& { return s.see_through.width_px; }));
    keys.push_back(integer_key(
        "see_through.height_px", "px", {16, 16384}, "the same",
        [](auto& s) -> auto& { return s.see_through.height_px; }));
    keys.push_back(integer_key(
        "see_through.rate_hz", "Hz", {1, 1000}, "the same",
        [](auto& s) -> auto& { return s.see_through.rate_hz; }));
}

}  // namespace foverig
