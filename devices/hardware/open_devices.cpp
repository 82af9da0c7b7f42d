#include "devices/hardware/open_devices.h"

#include <fmt/format.h>

#include <algorithm>

#include "devices/dk2/feature_reports.h"
#include "devices/hardware/found_cameras.h"
#include "devices/hardware/hid_link.h"
#include "devices/hardware/usb_link.h"
#include "devices/hardware/video_link.h"

namespace foverig::hardware {
namespace {

/// The device that is opened now is the one that is opened again.
template <class Find, class OpenFound>
Result<std::unique_ptr<LiveTransport>> open_chosen(const Clock& clock, const std::string& serial,
                                                   const LiveTransport::Settings& settings,
                                                   Find find, OpenFound open_found) {
    const Result<FoundDevice> chosen = find(serial);
    if (!chosen) return chosen.error();
    const std::string same = chosen->serial;
    return LiveTransport::open(
        clock,
        [find, open_found, same]() -> Result<std::unique_ptr<Link>> {
            const Result<FoundDevice> device = find(same);
            if (!device) return device.error();
            return open_found(*device);
        },
        settings);
}

/// Report 10's; empty where the headset does not tell it. Opens it for a moment.
std::string factory_number_of(const FoundDevice& headset) {
    const auto link = HidLink::open(headset);
    if (!link) return "";
    const auto bytes = (*link)->control_get(dk2::SerialReport::kId, 0, dk2::SerialReport::kSize);
    if (!bytes) return "";
    const auto report = dk2::SerialReport::decode(*bytes);
    return report ? report->serial : "";
}

}  // namespace

Result<FoundDevice> choose_headset(const std::string& serial) {
    const auto found = find_headsets();
    const auto chosen =
        choose(found, serial, "headset",
               fmt::format("Rift DK2, USB {}, among the hidraw devices", text_of(kDk2)));
    if (chosen || chosen.error().code != ErrorCode::not_found) return chosen;
    const auto named = std::find_if(found.begin(), found.end(), [&](const FoundDevice& d) {
        return factory_number_of(d) == serial;
    });
    if (named != found.end()) return *named;
    // One that cannot be asked may be the one that is meant.
    for (const FoundDevice& device : found) {
        if (device.problem) return *device.problem;
    }
    return chosen;
}

Result<FoundDevice> choose_gaze_tracker(const UsbId& id, const std::string& serial) {
    return choose(find_gaze_trackers(id), serial, "gaze tracker",
                  fmt::format("USB device {} that speaks SGZ1", text_of(id)));
}

Result<FoundDevice> choose_tracker_camera(const std::string& serial) {
    return choose(
        find_cameras_of(kDk2Camera), serial, "tracker camera",
        fmt::format("DK2's camera, USB {}, among the video4linux devices", text_of(kDk2Camera)));
}

Result<std::unique_ptr<LiveTransport>> open_tracker_camera(const Clock& clock,
                                                           const std::string& serial) {
    return open_chosen(
        clock, serial, {.queue_capacity = kTrackerFrames}, &choose_tracker_camera,
        [](const FoundDevice& device) { return VideoLink::open(device, tracker_modes()); });
}

Result<std::unique_ptr<LiveTransport>> open_video_camera(const Clock& clock,
                                                         const std::string& which,
                                                         const VideoWish& wish) {
    const LiveTransport::Settings settings{.queue_capacity = 64};
    const auto open_found = [wish](const FoundDevice& device) {
        return VideoLink::open(device, wish);
    };
    const auto id = usb_id_of(which);
    if (id) {
        const auto find = [id = *id](const std::string& serial) {
            return choose(find_cameras_of(id), serial, "camera",
                          fmt::format("USB device {} among the video4linux devices", text_of(id)));
        };
        return open_chosen(clock, "", settings, find, open_found);
    }
    return LiveTransport::open(
        clock,
        [which, open_found] {
            return open_found(FoundDevice{.path = which, .serial = {}, .problem = {}});
        },
        settings);
}

Result<std::unique_ptr<LiveTransport>> open_headset(const Clock& clock, const std::string& serial,
                                                    const LiveTransport::Settings& settings) {
    return open_chosen(clock, serial, settings, &choose_headset, &HidLink::open);
}

Result<std::unique_ptr<LiveTransport>> open_gaze_tracker(const Clock& clock, const UsbId& id,
                                                         const std::string& serial,
                                                         const LiveTransport::Settings& settings) {
    const auto find = [id](const std::string& wanted) { return choose_gaze_tracker(id, wanted); };
    return open_chosen(clock, serial, settings, find, &UsbLink::open);
}

}  // namespace foverig::hardware
