// The order of V4L2's calls and what their failures become, against a kernel that is played.
#include "devices/hardware/video_link.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/usb/video.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>

#include "devices/camera/frame.h"
#include "tests/devices/hardware/other_program.h"

namespace foverig::hardware {
namespace {

/// One camera with four buffers; `fail` makes a call fail once with an errno.
class PlayedKernel final : public VideoCalls {
  public:
    std::map<std::string, int> fail;
    std::vector<std::string> log;
    std::uint32_t format = V4L2_PIX_FMT_GREY;
    std::uint32_t capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    bool ready = false;
    v4l2_buffer filled{};
    std::vector<std::uint8_t> unit_memory;
    std::uint16_t unit_length = 3;  ///< of each selector
    int not_ready = 0;              ///< requests to the unit that find it so
    int paused_ms = 0;
    static constexpr std::size_t kSize = 752 * 480;
    std::array<std::vector<std::byte>, 4> memory{};
    int mapped = 0, opened = 0, queued = 0;

    int open(const char*) override {
        if (fails("open")) return -1;
        ++opened;
        return 7;
    }
    int close(int) override {
        log.emplace_back("close");
        --opened;
        return 0;
    }
    int ioctl(int, unsigned long request, void* argument) override {
        switch (request) {
            case VIDIOC_QUERYCAP: {
                if (fails("querycap")) return -1;
                auto* c = static_cast<v4l2_capability*>(argument);
                c->capabilities = V4L2_CAP_DEVICE_CAPS;
                c->device_caps = capabilities;
                return 0;
            }
            case VIDIOC_S_FMT: {
                if (fails("s_fmt")) return -1;
                auto& pix = static_cast<v4l2_format*>(argument)->fmt.pix;
                pix.pixelformat = format;
                pix.width = format == V4L2_PIX_FMT_YUYV ? 376 : 752;
                pix.height = 480;
                pix.bytesperline = 752;
                return 0;
            }
            case VIDIOC_S_PARM:
                return fails("s_parm") ? -1 : 0;
            case VIDIOC_REQBUFS:
                if (fails("reqbufs")) return -1;
                EXPECT_EQ(static_cast<v4l2_requestbuffers*>(argument)->count, 4u);
                return 0;
            case VIDIOC_QUERYBUF: {
                if (fails("querybuf")) return -1;
                auto* b = static_cast<v4l2_buffer*>(argument);
                b->length = kSize;
                b->m.offset = b->index;
                return 0;
            }
            case VIDIOC_QBUF:
                if (fails("qbuf")) return -1;
                ++queued;
                return 0;
            case VIDIOC_STREAMON:
                return fails("streamon") ? -1 : 0;
            case VIDIOC_STREAMOFF:
                return fails("streamoff") ? -1 : 0;
            case VIDIOC_DQBUF:
                if (fails("dqbuf")) return -1;
                *static_cast<v4l2_buffer*>(argument) = filled;
                --queued;
                return 0;
            case UVCIOC_CTRL_QUERY: {
                if (fails("xu")) return -1;
                if (not_ready > 0) {
                    --not_ready;
                    errno = EBUSY;
                    return -1;
                }
                auto* q = static_cast<uvc_xu_control_query*>(argument);
                EXPECT_EQ(q->unit, 4);
                // As uvcvideo does.
                if (q->size != (q->query == UVC_GET_LEN ? 2 : unit_length)) {
                    errno = ENOBUFS;
                    return -1;
                }
                if (q->query == UVC_GET_LEN) {
                    q->data[0] = static_cast<std::uint8_t>(unit_length);
                    q->data[1] = 0;
                }
                if (q->query == UVC_SET_CUR) unit_memory.assign(q->data, q->data + q->size);
                if (q->query == UVC_GET_CUR) std::copy_n(unit_memory.begin(), q->size, q->data);
                return 0;
            }
            default:
                errno = ENOTTY;
                return -1;
        }
    }
    void* map(std::size_t size, int, std::int64_t offset) override {
        if (fails("mmap")) return MAP_FAILED;
        auto& m = memory[static_cast<std::size_t>(offset)];
        m.assign(size, static_cast<std::byte>(offset));
        ++mapped;
        return m.data();
    }
    int unmap(void*, std::size_t) override {
        --mapped;
        return 0;
    }
    int wait(int, int) override { return fails("poll") ? -1 : static_cast<int>(ready); }
    void pause(int ms) override { paused_ms += ms; }
    std::int64_t monotonic_ns() override { return 100'000'000'000; }

    void fill(std::uint32_t index, std::uint32_t sequence) {
        ready = true;
        filled = {};
        filled.index = index;
        filled.sequence = sequence;
        filled.bytesused = kSize;
        filled.flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
        filled.timestamp = {.tv_sec = 99, .tv_usec = 985'000};
    }

  private:
    bool fails(const std::string& call) {
        log.push_back(call);
        const auto found = fail.find(call);
        if (found == fail.end()) return false;
        errno = found->second;
        return true;
    }
};

/// The test keeps the kernel.
std::shared_ptr<VideoCalls> borrowed(PlayedKernel& kernel) {
    return {std::shared_ptr<void>(), &kernel};
}

const FoundDevice kNode{.path = "/dev/video3", .serial = "", .problem = {}};

std::unique_ptr<Link> opened(PlayedKernel& kernel) {
    auto link = VideoLink::open(kNode, tracker_modes(), borrowed(kernel));
    EXPECT_TRUE(link) << link.error().text;
    return std::move(link).value();
}

Packet only_packet(PacketQueue& queue) {
    auto next = queue.next(HostTime{});
    auto* packet = std::get_if<Packet>(&next);
    return packet != nullptr ? std::move(*packet) : Packet{};
}

TEST(VideoLink, SetsUpAndTakesDownInOrder) {
    PlayedKernel kernel;
    opened(kernel).reset();
    const std::vector<std::string> expected{
        "open",     "querycap", "s_fmt",    "s_parm",   "reqbufs",   "querybuf", "mmap",
        "querybuf", "mmap",     "querybuf", "mmap",     "querybuf",  "mmap",     "qbuf",
        "qbuf",     "qbuf",     "qbuf",     "streamon", "streamoff", "close"};
    EXPECT_EQ(kernel.log, expected);
    EXPECT_EQ(kernel.mapped, 0);
    EXPECT_EQ(kernel.opened, 0);
}

TEST(VideoLink, AFrameCarriesItsBytesNumberAndAge) {
    PlayedKernel kernel;
    const auto link = opened(kernel);
    ManualClock clock;
    PacketQueue queue(clock);
    ASSERT_TRUE(link->read(queue));
    EXPECT_TRUE(only_packet(queue).bytes.empty());
    kernel.fill(2, 41);
    ASSERT_TRUE(link->read(queue));
    const Packet packet = only_packet(queue);
    const auto header = camera::decode_header(packet.bytes);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->format, camera::kGrey);
    EXPECT_EQ(header->sequence, 41u);
    EXPECT_EQ(header->age_us, 15'000u);
    EXPECT_FALSE(header->damaged);
    EXPECT_EQ(packet.bytes[camera::FrameHeader::kSize], std::byte{2});
    EXPECT_EQ(kernel.queued, 4);
}

TEST(VideoLink, YuyvOfHalfTheWidthIsTakenWhereGreyIsNot) {
    PlayedKernel kernel;
    kernel.format = V4L2_PIX_FMT_YUYV;
    const auto link = opened(kernel);
    ManualClock clock;
    PacketQueue queue(clock);
    kernel.fill(0, 0);
    ASSERT_TRUE(link->read(queue));
    const Packet packet = only_packet(queue);
    const auto header = camera::decode_header(packet.bytes);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->width_px, 376);
    EXPECT_EQ(camera::tracker_image(*header, packet.bytes).width_px, 752);
}

TEST(VideoLink, ShortAndFaultyFramesAreMarked) {
    PlayedKernel kernel;
    const auto link = opened(kernel);
    ManualClock clock;
    PacketQueue queue(clock);
    kernel.fill(1, 1);
    kernel.filled.bytesused = 1000;
    ASSERT_TRUE(link->read(queue));
    kernel.fill(1, 2);
    kernel.filled.flags |= V4L2_BUF_FLAG_ERROR;
    ASSERT_TRUE(link->read(queue));
    EXPECT_TRUE(camera::decode_header(only_packet(queue).bytes)->damaged);
    EXPECT_TRUE(camera::decode_header(only_packet(queue).bytes)->damaged);
}

TEST(VideoLink, EachFailureOfOpeningIsToldApartAndLeavesNothingOpen) {
    const struct {
        const char* call;
        int reason;
        ErrorCode code;
    } cases[] = {{"open", EACCES, ErrorCode::forbidden},
                 {"open", ENODEV, ErrorCode::closed},
                 {"querycap", ENODEV, ErrorCode::closed},
                 {"s_fmt", EBUSY, ErrorCode::busy},
                 {"s_fmt", EINVAL, ErrorCode::unsupported},
                 {"reqbufs", EBUSY, ErrorCode::busy},
                 {"querybuf", EIO, ErrorCode::io},
                 {"mmap", ENOMEM, ErrorCode::io},
                 {"qbuf", EIO, ErrorCode::io},
                 {"streamon", ENOSPC, ErrorCode::io},
                 {"streamon", EBUSY, ErrorCode::busy}};
    for (const auto& c : cases) {
        PlayedKernel kernel;
        kernel.fail[c.call] = c.reason;
        const auto link = VideoLink::open(kNode, tracker_modes(), borrowed(kernel));
        ASSERT_FALSE(link) << c.call;
        EXPECT_EQ(link.error().code, c.code) << c.call << " " << c.reason;
        EXPECT_NE(link.error().text.find("/dev/video3"), std::string::npos);
        EXPECT_EQ(kernel.opened, 0) << c.call;
        EXPECT_EQ(kernel.mapped, 0) << c.call;
    }
}

TEST(VideoLink, WhoHoldsTheCameraIsNamed) {
    const std::string node = testing::TempDir() + "foverig_video_" + std::to_string(getpid());
    std::ofstream(node) << "x";
    {
        const test::OtherProgram other(node);
        for (const char* call : {"s_fmt", "reqbufs", "streamon"}) {
            PlayedKernel kernel;
            kernel.fail[call] = EBUSY;
            const auto link = VideoLink::open({.path = node, .serial = "", .problem = {}},
                                              tracker_modes(), borrowed(kernel));
            ASSERT_FALSE(link) << call;
            EXPECT_EQ(link.error().code, ErrorCode::busy);
            EXPECT_NE(link.error().text.find(fmt::format("(pid {})", other.pid())),
                      std::string::npos)
                << link.error().text;
        }
    }
    std::remove(node.c_str());
}

TEST(VideoLink, ARateThatIsRefusedAndANodeOfMetadata) {
    PlayedKernel kernel;
    kernel.fail["s_parm"] = ENOTTY;
    EXPECT_TRUE(VideoLink::open(kNode, tracker_modes(), borrowed(kernel)));
    PlayedKernel metadata;
    metadata.capabilities = V4L2_CAP_META_CAPTURE | V4L2_CAP_STREAMING;
    EXPECT_EQ(VideoLink::open(kNode, tracker_modes(), borrowed(metadata)).error().code,
              ErrorCode::unsupported);
}

TEST(VideoLink, PullingTheCableEndsTheReading) {
    for (const char* call : {"poll", "dqbuf", "qbuf"}) {
        PlayedKernel kernel;
        const auto link = opened(kernel);
        ManualClock clock;
        PacketQueue queue(clock);
        kernel.fill(0, 0);
        kernel.fail[call] = ENODEV;
        const Status status = link->read(queue);
        ASSERT_FALSE(status) << call;
        EXPECT_EQ(status.error().code, ErrorCode::closed) << call;
    }
    PlayedKernel kernel;
    const auto link = opened(kernel);
    ManualClock clock;
    PacketQueue queue(clock);
    kernel.fill(0, 0);
    kernel.fail["dqbuf"] = EAGAIN;
    EXPECT_TRUE(link->read(queue));
}

TEST(VideoLink, TheExtensionUnitIsAskedAsUvcHasIt) {
    PlayedKernel kernel;
    const auto link = opened(kernel);
    const std::vector<std::byte> asked{std::byte{0x84}, std::byte{0x98}, std::byte{0}};
    ASSERT_TRUE(link->control_set(2, 4, asked));
    EXPECT_EQ(link->control_get(2, 4, 3).value(), asked);
    kernel.fail["xu"] = ENOENT;
    EXPECT_EQ(link->control_set(9, 4, asked).error().code, ErrorCode::unsupported);
    kernel.fail["xu"] = ENODEV;
    EXPECT_EQ(link->control_get(2, 4, 3).error().code, ErrorCode::closed);
    kernel.fail["xu"] = EIO;
    EXPECT_EQ(link->control_get(2, 4, 3).error().code, ErrorCode::io);
}

/// EBUSY of a unit is the camera's "not ready" (UVC 1.5, 4.2.1.2) and never another program.
TEST(VideoLink, AUnitThatIsNotReadyIsAskedAgainAndNobodyIsBlamed) {
    const std::vector<std::byte> asked{std::byte{0x84}, std::byte{0x98}, std::byte{0}};
    PlayedKernel kernel;
    const auto link = opened(kernel);
    ASSERT_TRUE(link->control_set(2, 4, asked));
    kernel.not_ready = 3;
    EXPECT_EQ(link->control_get(2, 4, 3).value(), asked);
    EXPECT_EQ(kernel.paused_ms, 15);
    for (const int reason : {EBUSY, EACCES, EILSEQ}) {
        kernel.fail["xu"] = reason;
        const auto refused = link->control_set(2, 4, asked);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, ErrorCode::io) << reason;
        EXPECT_NE(refused.error().text.find("extension unit 4"), std::string::npos);
        for (const char* untrue : {"held by", "program", "udev"}) {
            EXPECT_EQ(refused.error().text.find(untrue), std::string::npos) << refused.error().text;
        }
    }
    EXPECT_EQ(kernel.paused_ms, 30) << "what is in the wrong state is not asked again";
}

/// The length of selector 3 is not known: what the camera says holds.
TEST(VideoLink, AsksTheExtensionUnitForAsManyBytesAsItHas) {
    for (const std::uint16_t length : std::initializer_list<std::uint16_t>{3, 4, 6}) {
        PlayedKernel kernel;
        kernel.unit_length = length;
        const auto link = opened(kernel);
        const std::vector<std::byte> asked{std::byte{0x80}, std::byte{0x14}, {}, {}};
        EXPECT_TRUE(link->control_set(3, 4, asked)) << length;
        EXPECT_EQ(kernel.unit_memory.size(), length);
        const auto answer = link->control_get(3, 4, asked.size());
        ASSERT_TRUE(answer) << length;
        EXPECT_EQ(answer->size(), std::min<std::size_t>(length, 4));
        EXPECT_EQ((*answer)[1], std::byte{0x14});
    }
}

/// MJPG's frames differ in size, and have no rows.
TEST(VideoLink, GivesCompressedFramesAsLongAsTheyAre) {
    PlayedKernel kernel;
    kernel.format = V4L2_PIX_FMT_MJPEG;
    auto link = VideoLink::open(
        kNode,
        std::vector<VideoMode>{{.format = V4L2_PIX_FMT_MJPEG, .width_px = 752, .height_px = 480}},
        borrowed(kernel));
    ASSERT_TRUE(link) << link.error().text;
    ManualClock clock;
    PacketQueue queue(clock);
    kernel.fill(1, 5);
    kernel.filled.bytesused = 1234;
    ASSERT_TRUE((*link)->read(queue));
    kernel.fill(2, 6);
    kernel.filled.bytesused = 0;
    ASSERT_TRUE((*link)->read(queue));
    const Packet packet = only_packet(queue);
    const auto header = camera::decode_any_header(packet.bytes);
    ASSERT_TRUE(header) << header.error().text;
    EXPECT_EQ(header->format, camera::kMjpeg);
    EXPECT_EQ(header->stride_bytes, 0u);
    EXPECT_EQ(header->image_bytes, 1234u);
    EXPECT_FALSE(header->damaged);
    EXPECT_FALSE(camera::decode_any_header(only_packet(queue).bytes)) << "nothing in it";
}

}  // namespace
}  // namespace foverig::hardware
