#pragma once
// A camera over V4L2: memory-mapped streaming of GREY, YUYV or MJPG frames, and the extension unit
// of a UVC camera (DEVICES.md 1.8). Packets are camera/frame.h's.
#include <map>
#include <memory>
#include <vector>

#include "devices/hardware/found_device.h"
#include "devices/hardware/link.h"
#include "devices/hardware/video_modes.h"

namespace foverig::hardware {

class VideoLink final : public Link {
  public:
    /// The first mode that the camera takes as it is asked. Streams from now on. Errors: forbidden,
    /// busy, closed, unsupported, io.
    static Result<std::unique_ptr<Link>> open(const FoundDevice& device,
                                              const std::vector<VideoMode>& modes,
                                              std::shared_ptr<VideoCalls> calls = kernel_video());
    /// What is nearest to the wish of all that the camera offers. Errors: the same.
    static Result<std::unique_ptr<Link>> open(const FoundDevice& device, const VideoWish& wish,
                                              std::shared_ptr<VideoCalls> calls = kernel_video());
    ~VideoLink() override;

    Status read(PacketQueue& packets) override;
    /// SET_CUR of selector `id` of the extension unit `value`; `data` is cut, or filled up with
    /// zeros, to the selector's length as the camera tells it. A unit that is not ready is asked
    /// again for 15 ms. Errors: unsupported, closed, io.
    Status control_set(std::uint8_t id, std::uint16_t value, Bytes data) override;
    /// GET_CUR of the same: `size` bytes, or fewer where the selector is shorter.
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override;

  private:
    struct Buffer {
        void* memory = nullptr;
        std::size_t size = 0;
    };

    VideoLink(std::string path, std::shared_ptr<VideoCalls> calls, int file)
        : path_(std::move(path)), calls_(std::move(calls)), file_(file) {}

    static Result<std::unique_ptr<VideoLink>> opened(const FoundDevice& device,
                                                     std::shared_ptr<VideoCalls> calls);
    Status stream(const std::vector<VideoMode>& modes);
    Status check_abilities();
    Status choose(const std::vector<VideoMode>& modes);
    Status map_buffers();
    Status start();
    Status give_back(std::uint32_t index);
    Status query(std::uint8_t request, std::uint8_t selector, std::uint16_t unit,
                 std::span<std::byte> data);
    Result<std::size_t> length_of(std::uint8_t selector, std::uint16_t unit);
    Error refused(std::uint8_t selector, std::uint16_t unit, std::size_t size) const;
    Error failed(const char* doing) const;

    std::string path_;
    std::shared_ptr<VideoCalls> calls_;
    int file_;
    std::vector<Buffer> buffers_;
    bool streaming_ = false;
    std::uint32_t format_ = 0, stride_bytes_ = 0;  // no stride: the frames' sizes differ
    std::size_t whole_bytes_ = 0;                  // of a frame, at most
    std::uint16_t width_px_ = 0, height_px_ = 0;
    std::map<std::pair<std::uint8_t, std::uint16_t>, std::size_t> lengths_;  // that were asked for
};

}  // namespace foverig::hardware
