#include "rig/live/recent_frames.h"

#include "rig/records/columns.h"

namespace foverig {

void RecentFrames::add(const FrameRecord& frame) {
    if (frame_ms_.size() == kShown) frame_ms_.erase(frame_ms_.begin());
    frame_ms_.push_back(static_cast<float>(foverig::frame_time_ms(frame)));
    motion_to_photon_ms_ = foverig::motion_to_photon_ms(frame);
    warp_to_photon_ms_ = foverig::warp_to_photon_ms(frame);
    gaze_to_photon_ms_ = foverig::gaze_to_photon_ms(frame);
    see_through_to_photon_ms_ = foverig::see_through_to_photon_ms(frame);
    // This one took the VSync of the frame before, which nobody saw then.
    if (last_vsync_ && frame.shown_vsync == last_vsync_) ++dropped_;
    last_vsync_ = frame.shown_vsync;
    repeated_ += frame.missed_vsyncs;
    gaze_ = frame.gaze_direction;
}

}  // namespace foverig
