#pragma once
#include <memory>
#include <string>

#include "devices/hardware/found_device.h"
#include "devices/hardware/live_transport.h"
#include "devices/hardware/video_modes.h"

namespace foverig::hardware {

/// The device to open; `serial` may be empty: the only one there is. Errors: not_found, and
/// invalid_data where several are there. A headset's is that of USB (its UUID, 20 characters), and
/// its factory number (report 10, 12 characters) names it too.
Result<FoundDevice> choose_headset(const std::string& serial);
Result<FoundDevice> choose_gaze_tracker(const UsbId& id, const std::string& serial);

Result<FoundDevice> choose_tracker_camera(const std::string& serial);

/// A DK2 on the desk. Errors: as choosing, and forbidden, busy, io. `clock` as LiveTransport wants
/// it.
Result<std::unique_ptr<LiveTransport>> open_headset(const Clock& clock, const std::string& serial,
                                                    const LiveTransport::Settings& settings = {});

/// Frames of the tracker camera that wait: 3 s of it, 64 MiB. A session that records takes them on
/// its frames' thread, and a slow frame must not tear a hole into the recording.
inline constexpr std::size_t kTrackerFrames = (std::size_t{64} << 20) / (752 * 480);

/// The DK2's tracker camera; its packets are camera/frame.h's, and the newest kTrackerFrames are
/// kept.
Result<std::unique_ptr<LiveTransport>> open_tracker_camera(const Clock& clock,
                                                           const std::string& serial);

/// Any camera, for its picture: a node ("/dev/video0") or the only one of a USB identifier
/// ("046d:0825"). Of what it offers the nearest to `wish`; its packets are camera/frame.h's, and
/// the newest 64 are kept.
Result<std::unique_ptr<LiveTransport>> open_video_camera(const Clock& clock,
                                                         const std::string& which,
                                                         const VideoWish& wish);

/// A gaze tracker that speaks SGZ1.
Result<std::unique_ptr<LiveTransport>> open_gaze_tracker(
    const Clock& clock, const UsbId& id, const std::string& serial,
    const LiveTransport::Settings& settings = {});

}  // namespace foverig::hardware
