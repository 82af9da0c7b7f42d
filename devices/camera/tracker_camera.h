#pragma once
// The tracker camera over a transport: Source<CameraFrame>. Sets sensor and sync up, reads the
// lens from the calibration memory, and sets a camera up again that was unplugged. One thread uses
// it.
#include "devices/camera/frame_count.h"
#include "devices/camera/lens.h"
#include "devices/camera/sensor_setup.h"
#include "devices/source.h"

namespace foverig::camera {

struct CameraFrame {
    HostTime stamp{};    ///< of its first packet, as the kernel saw it
    HostTime arrival{};  ///< when it was all there
    FrameHeader header;
    BytePool::Held packet;

    GreyView image() const { return tracker_image(header, packet); }
};

class TrackerCamera {
  public:
    using Sample = CameraFrame;

    /// A camera without an extension unit (any other UVC camera, v4l2loopback) is taken as it is,
    /// with the nominal lens. `transport` outlives the source.
    static Result<TrackerCamera> open(Transport& transport, Sync sync);

    /// Frames in order; damaged ones are counted as rejected, missing ones as lost.
    Next<CameraFrame> next(HostTime deadline);

    /// Why the camera could not be set up and is taken as it is.
    const std::optional<Error>& as_it_is() const { return as_it_is_; }
    const Lens& lens() const { return lens_; }
    /// The lens is the camera's own and not the design's.
    bool calibrated() const { return calibrated_; }
    SourceCounts counts() const { return count_.counts(); }

  private:
    TrackerCamera(Transport& transport, Sync sync) : transport_(&transport), sync_(sync) {}

    Status set_up();
    Status set_up_bridge();
    void set_up_again(HostTime now);
    std::optional<CameraFrame> take(Packet packet);

    Transport* transport_;
    Sync sync_;
    Lens lens_;
    bool calibrated_ = false;
    std::optional<Error> as_it_is_;
    bool was_gone_ = false;
    HostTime next_set_up_{};  // where it was
    FrameCount count_;
};

static_assert(Source<TrackerCamera>);

}  // namespace foverig::camera
