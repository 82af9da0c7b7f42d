#pragma once
// Any camera over a transport, for its picture alone: nothing is set up, and only the newest frame
// is of interest.
#include "devices/camera/frame_count.h"
#include "devices/camera/rgb_image.h"

namespace foverig::camera {

class VideoCamera {
  public:
    /// `transport` outlives the camera.
    explicit VideoCamera(Transport& transport) : transport_(transport) {}

    /// Takes all frames that arrived by `deadline`; true: newest() is another one.
    bool read_until(HostTime deadline);

    struct Frame {
        HostTime stamp{};    ///< of its first packet, as the kernel saw it
        HostTime arrival{};  ///< when it was all there
    };
    /// Absent before the first, and while the camera is unplugged.
    const std::optional<Frame>& newest() const { return newest_; }
    /// Of the newest frame, converted when it is asked for. Null: there is none, or it is broken,
    /// which then counts as rejected.
    const RgbImage* image();

    /// Samples are all frames that came, converted or not.
    SourceCounts counts() const;

  private:
    void take(Packet packet);

    Transport& transport_;
    FrameCount count_;
    bool was_gone_ = false;
    std::optional<Frame> newest_;
    FrameHeader header_;
    BytePool::Held packet_;  // empty: image_ is of the newest frame
    RgbImage image_;
    bool good_ = false;  // image_ is whole
    std::uint64_t broken_ = 0;
};

}  // namespace foverig::camera
