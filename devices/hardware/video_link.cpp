#include "devices/hardware/video_link.h"

#include <fmt/format.h>
#include <linux/usb/video.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "devices/camera/frame.h"
#include "devices/hardware/holders.h"

namespace foverig::hardware {
namespace {

constexpr std::uint32_t kBuffers = 4;
constexpr std::uint32_t kFewestBuffers = 2;  // one is filled while one is read
constexpr int kWait_ms = 50;                 // how soon the reader sees that it should stop
constexpr int kTries = 4;                    // of a request to a unit that is not ready
constexpr int kPause_ms = 5;                 // between two of them

v4l2_buffer mapped_buffer(std::uint32_t index = 0) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = index;
    return buffer;
}

std::uint32_t age_us(const v4l2_buffer& buffer, std::int64_t now_ns) {
    const bool monotonic =
        (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
    if (!monotonic) return 0;
    const std::int64_t stamp_us =
        std::int64_t{buffer.timestamp.tv_sec} * 1'000'000 + buffer.timestamp.tv_usec;
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(now_ns / 1000 - stamp_us, 0, 10'000'000));
}

}  // namespace

Error VideoLink::failed(const char* doing) const {
    const int reason = errno;
    switch (reason) {
        case EBUSY:
            return busy(path_);
        case EACCES:
        case EPERM:
            return forbidden(path_);
        case ENODEV:
        case ENXIO:
        case ENOENT:
            return {ErrorCode::closed, fmt::format("{} is unplugged", path_)};
        case ENOSPC:
            return {ErrorCode::io,
                    fmt::format("{}: the USB controller has no bandwidth left for it; plug the "
                                "camera into a port of its own",
                                path_)};
        default:
            return {ErrorCode::io,
                    fmt::format("{} did not {}: {}", path_, doing, std::strerror(reason))};
    }
}

Result<std::unique_ptr<VideoLink>> VideoLink::opened(const FoundDevice& device,
                                                     std::shared_ptr<VideoCalls> calls) {
    const int file = calls->open(device.path.c_str());
    std::unique_ptr<VideoLink> link(new VideoLink(device.path, std::move(calls), file));
    if (file < 0) return link->failed("open");
    if (auto status = link->check_abilities(); !status) return status.error();
    return link;
}

Result<std::unique_ptr<Link>> VideoLink::open(const FoundDevice& device,
                                              const std::vector<VideoMode>& modes,
                                              std::shared_ptr<VideoCalls> calls) {
    auto link = opened(device, std::move(calls));
    if (!link) return link.error();
    if (auto status = (*link)->stream(modes); !status) return status.error();
    return std::unique_ptr<Link>(std::move(link).value());
}

Result<std::unique_ptr<Link>> VideoLink::open(const FoundDevice& device, const VideoWish& wish,
                                              std::shared_ptr<VideoCalls> calls) {
    auto link = opened(device, calls);
    if (!link) return link.error();
    const auto modes = nearest_first(offered_modes(*calls, (*link)->file_, wish), wish);
    if (modes.empty()) {
        return Error{ErrorCode::unsupported,
                     fmt::format("{} offers neither YUYV nor MJPG nor GREY", device.path)};
    }
    if (auto status = (*link)->stream(modes); !status) return status.error();
    return std::unique_ptr<Link>(std::move(link).value());
}

Status VideoLink::stream(const std::vector<VideoMode>& modes) {
    if (auto status = choose(modes); !status) return status.error();
    if (auto status = map_buffers(); !status) return status.error();
    return start();
}

VideoLink::~VideoLink() {
    if (file_ < 0) return;
    if (streaming_) {
        int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        (void)calls_->ioctl(file_, VIDIOC_STREAMOFF, &type);
    }
    for (const Buffer& buffer : buffers_) (void)calls_->unmap(buffer.memory, buffer.size);
    (void)calls_->close(file_);
}

Status VideoLink::check_abilities() {
    v4l2_capability able{};
    if (calls_->ioctl(file_, VIDIOC_QUERYCAP, &able) < 0) return failed("tell what it can");
    const std::uint32_t abilities =
        (able.capabilities & V4L2_CAP_DEVICE_CAPS) != 0 ? able.device_caps : able.capabilities;
    constexpr std::uint32_t kNeeded = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    if ((abilities & kNeeded) != kNeeded) {
        return Error{ErrorCode::unsupported,
                     fmt::format("{} streams no video (it may be a camera's metadata)", path_)};
    }
    return Done{};
}

Status VideoLink::choose(const std::vector<VideoMode>& modes) {
    for (const VideoMode& mode : modes) {
        v4l2_format format{};
        format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        format.fmt.pix.pixelformat = mode.format;
        format.fmt.pix.width = mode.width_px;
        format.fmt.pix.height = mode.height_px;
        format.fmt.pix.field = V4L2_FIELD_NONE;
        if (calls_->ioctl(file_, VIDIOC_S_FMT, &format) < 0) {
            if (errno == EINVAL) continue;
            return failed("take a format");
        }
        const v4l2_pix_format& got = format.fmt.pix;
        if (got.pixelformat != mode.format || got.width != mode.width_px ||
            got.height != mode.height_px) {
            continue;
        }
        format_ = got.pixelformat;
        width_px_ = static_cast<std::uint16_t>(got.width);
        height_px_ = static_cast<std::uint16_t>(got.height);
        if (format_ == V4L2_PIX_FMT_MJPEG) {
            stride_bytes_ = 0;
            whole_bytes_ = got.sizeimage;
        } else {
            const std::uint32_t tight = got.width * (format_ == V4L2_PIX_FMT_YUYV ? 2 : 1);
            stride_bytes_ = std::max(got.bytesperline, tight);
            whole_bytes_ = std::size_t{stride_bytes_} * got.height;
        }
        v4l2_streamparm rate{};
        rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
        rate.parm.capture.timeperframe = {.numerator = 1, .denominator = mode.rate_hz};
        // A camera that keeps its own rate says so by its frames.
        (void)calls_->ioctl(file_, VIDIOC_S_PARM, &rate);
        return Done{};
    }
    return Error{ErrorCode::unsupported,
                 fmt::format("{} takes none of the {} formats asked for", path_, modes.size())};
}

Status VideoLink::map_buffers() {
    v4l2_requestbuffers request{};
    request.count = kBuffers;
    request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request.memory = V4L2_MEMORY_MMAP;
    if (calls_->ioctl(file_, VIDIOC_REQBUFS, &request) < 0) return failed("give buffers");
    if (request.count < kFewestBuffers) {
        return Error{ErrorCode::io, fmt::format("{} gave {} buffers; expected {}", path_,
                                                request.count, kBuffers)};
    }
    for (std::uint32_t i = 0; i < request.count; ++i) {
        v4l2_buffer buffer = mapped_buffer(i);
        if (calls_->ioctl(file_, VIDIOC_QUERYBUF, &buffer) < 0) return failed("describe a buffer");
        if (buffer.length < whole_bytes_)
            return Error{ErrorCode::io, fmt::format("{} gives buffers of {} bytes; expected {}, a "
                                                    "whole frame; unplug the camera and plug it in "
                                                    "again",
                                                    path_, buffer.length, whole_bytes_)};
        void* memory = calls_->map(buffer.length, file_, buffer.m.offset);
        if (memory == MAP_FAILED) return failed("map a buffer");
        buffers_.push_back({memory, buffer.length});
    }
    return Done{};
}

Status VideoLink::start() {
    for (std::uint32_t i = 0; i < buffers_.size(); ++i) {
        if (auto status = give_back(i); !status) return status;
    }
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (calls_->ioctl(file_, VIDIOC_STREAMON, &type) < 0) return failed("start to stream");
    streaming_ = true;
    return Done{};
}

Status VideoLink::give_back(std::uint32_t index) {
    v4l2_buffer buffer = mapped_buffer(index);
    if (calls_->ioctl(file_, VIDIOC_QBUF, &buffer) < 0) return failed("take a buffer back");
    return Done{};
}

Status VideoLink::read(PacketQueue& packets) {
    const int ready = calls_->wait(file_, kWait_ms);
    if (ready < 0) return failed("wait");
    if (ready == 0) return Done{};
    v4l2_buffer buffer = mapped_buffer();
    if (calls_->ioctl(file_, VIDIOC_DQBUF, &buffer) < 0) {
        if (errno == EAGAIN) return Done{};
        // What poll calls ready without a frame is an end: uvcvideo's way to say unplugged.
        return failed("give a frame");
    }
    if (buffer.index >= buffers_.size()) {
        return Error{ErrorCode::io, fmt::format("{} gave a buffer that is none", path_)};
    }
    const Buffer& mapped = buffers_[buffer.index];
    const std::size_t used = std::min<std::size_t>(buffer.bytesused, mapped.size);
    // A short frame keeps its size: old bytes behind it are marked by `damaged`.
    const bool compressed = stride_bytes_ == 0;
    const std::size_t size = compressed ? used : whole_bytes_;
    const camera::FrameHeader header{
        .format = format_,
        .width_px = width_px_,
        .height_px = height_px_,
        .stride_bytes = stride_bytes_,
        .sequence = buffer.sequence,
        .age_us = age_us(buffer, calls_->monotonic_ns()),
        .damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0 || used < size || used == 0,
        .image_bytes = static_cast<std::uint32_t>(size)};
    const auto* bytes = static_cast<const std::byte*>(mapped.memory);
    packets.push(camera::encode_header(header), Bytes(bytes, size));
    return give_back(buffer.index);
}

Status VideoLink::query(std::uint8_t request, std::uint8_t selector, std::uint16_t unit,
                        std::span<std::byte> data) {
    uvc_xu_control_query query{};
    query.unit = static_cast<std::uint8_t>(unit);
    query.selector = selector;
    query.query = request;
    query.size = static_cast<std::uint16_t>(data.size());
    query.data = reinterpret_cast<std::uint8_t*>(data.data());
    for (int tried = 1; calls_->ioctl(file_, UVCIOC_CTRL_QUERY, &query) < 0; ++tried) {
        if (errno != EBUSY || tried == kTries) return refused(selector, unit, data.size());
        calls_->pause(kPause_ms);
    }
    return Done{};
}

/// Of a unit, uvcvideo says EBUSY for the camera's own "not ready" and EACCES (once EILSEQ) for its
/// "wrong state": neither tells of another program or of a user's rights.
Error VideoLink::refused(std::uint8_t selector, std::uint16_t unit, std::size_t size) const {
    switch (errno) {
        case ENOENT:
        case EINVAL:
        case ENOTTY:
        case ENOBUFS:
            return {ErrorCode::unsupported,
                    fmt::format("{} has no selector {} of {} bytes in extension unit {}", path_,
                                selector, size, unit)};
        case EBUSY:
            return {ErrorCode::io,
                    fmt::format("{}: extension unit {} is still at work on an earlier request and "
                                "was not ready for selector {} within {} ms; where that lasts, "
                                "unplug the camera and plug it in again",
                                path_, unit, selector, (kTries - 1) * kPause_ms)};
        case EACCES:
        case EILSEQ:
            return {ErrorCode::io,
                    fmt::format("{}: extension unit {} takes no selector {} in the state that it "
                                "is in; unplug the camera and plug it in again",
                                path_, unit, selector)};
        default:
            return failed("answer its extension unit");
    }
}

/// The kernel lets nothing through that is not as long as the camera says.
Result<std::size_t> VideoLink::length_of(std::uint8_t selector, std::uint16_t unit) {
    const auto known = lengths_.find({selector, unit});
    if (known != lengths_.end()) return known->second;
    std::array<std::byte, 2> answer{};
    if (auto status = query(UVC_GET_LEN, selector, unit, answer); !status) return status.error();
    return lengths_[{selector, unit}] = read_u16(answer, 0);
}

Status VideoLink::control_set(std::uint8_t id, std::uint16_t value, Bytes data) {
    const auto length = length_of(id, value);
    if (!length) return length.error();
    std::vector<std::byte> bytes = to_vector(data);
    bytes.resize(*length);
    return query(UVC_SET_CUR, id, value, bytes);
}

Result<std::vector<std::byte>> VideoLink::control_get(std::uint8_t id, std::uint16_t value,
                                                      std::size_t size) {
    const auto length = length_of(id, value);
    if (!length) return length.error();
    std::vector<std::byte> bytes(*length);
    if (auto status = query(UVC_GET_CUR, id, value, bytes); !status) return status.error();
    bytes.resize(std::min(bytes.size(), size));
    return bytes;
}

}  // namespace foverig::hardware
