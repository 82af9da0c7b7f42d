// All devices at once, each at its full rate: what a driver gave is what its device sent.
#include <signal.h>

#include <algorithm>

#include "devices/camera/blobs.h"
#include "devices/camera/tracker_camera.h"
#include "devices/dk2/input_reports.h"
#include "devices/gaze/requests.h"
#include "tests/kernel/drivers/desk.h"
#include "tests/kernel/exposed.h"
#include "tests/kernel/recorded.h"

namespace foverig::test {
namespace {

constexpr Nanoseconds kWarmUp = kSecond, kMeasured = 5 * kSecond;

struct Stream {
    std::string device, file;
    double rate_hz;
    std::size_t drivers_own = 0;  ///< bytes before those of the device
    std::vector<Packet> got{};
};

Bytes device_bytes(const Stream& stream, const Packet& packet) {
    return Bytes(packet.bytes).subspan(stream.drivers_own);
}

/// `got` is a run of `sent` without gap, byte for byte.
void expect_contiguous(const Stream& stream) {
    const auto sent = recorded_packets(stream.file, stream.device);
    ASSERT_FALSE(stream.got.empty());
    const auto same = [&](const Packet& a, const Packet& b) {
        return std::ranges::equal(device_bytes(stream, a), device_bytes(stream, b));
    };
    // Frames that look alike may begin in several places; the whole of them fits in one.
    const auto run = std::ranges::search(sent, stream.got, same);
    EXPECT_FALSE(run.empty()) << "bytes that were never sent, or " << stream.got.size()
                              << " packets with a gap";
}

void expect_rate(const Stream& stream) {
    ASSERT_GT(stream.got.size(), 1u);
    const double seconds = to_seconds(stream.got.back().arrival - stream.got.front().arrival);
    EXPECT_NEAR(static_cast<double>(stream.got.size() - 1) / seconds, stream.rate_hz,
                0.01 * stream.rate_hz);
}

void expect_order(const Stream& stream) {
    for (std::size_t i = 1; i < stream.got.size(); ++i) {
        ASSERT_GE(stream.got[i].arrival, stream.got[i - 1].arrival);
    }
}

void start(Transport& transport, std::uint16_t rate_hz) {
    EXPECT_TRUE(transport.control_set(gaze::request::set_rate, rate_hz, {}));
    EXPECT_TRUE(transport.control_set(gaze::request::start, 0, {}));
}

class Streams : public testing::Test {
  protected:
    /// Once for all tests here: it takes a while.
    static void SetUpTestSuite() {
        const Stream imu{"dk2", fresh_file("imu.mcap"), 1000.0};
        const Stream slow{"gaze", fresh_file("slow.mcap"), 60.0};
        const Stream fast{"gaze", fresh_file("fast.mcap"), 251.0};  // a heartbeat each second
        const Stream seen{"camera", fresh_file("camera.mcap"), 60.0, camera::FrameHeader::kSize};
        Exposed headset_process({"dk2", "--set", "motion.head=look", "--record", imu.file});
        Exposed slow_process({"gaze", "--set", "motion.gaze=scan", "--record", slow.file});
        Exposed fast_process({"gaze", "--set", "motion.gaze=scan", "--set",
                              "hardware.gaze_usb_id=1209:0002", "--record", fast.file});
        Exposed camera_process({"camera", "--set", "motion.head=still", "--record", seen.file});
        WallClock clock;
        auto headset_link = headset(clock);
        auto slow_link = tracker(clock);
        auto fast_link = tracker(clock, kSecondTracker);
        auto camera_link = opened([&] { return hardware::open_tracker_camera(clock, ""); });
        ASSERT_TRUE(headset_link && slow_link && fast_link && camera_link);
        EXPECT_TRUE(camera::TrackerCamera::open(*camera_link, camera::Sync::headset));
        start(*slow_link, 60);
        start(*fast_link, 250);
        const HostTime from = clock.now() + kWarmUp, until = from + kMeasured;
        for (auto* link :
             {camera_link.get(), headset_link.get(), slow_link.get(), fast_link.get()}) {
            packets_until(*link, from);
        }
        streams = {imu, slow, fast, seen};
        streams[3].got = packets_until(*camera_link, until);  // first: its link keeps but a few
        streams[0].got = packets_until(*headset_link, until);
        streams[1].got = packets_until(*slow_link, until);
        streams[2].got = packets_until(*fast_link, until);
        camera_link.reset();
        headset_link.reset();
        EXPECT_TRUE(slow_link->control_set(gaze::request::stop, 0, {}));
        slow_link.reset();
        fast_link.reset();
        EXPECT_EQ(camera_process.stop(), 0) << camera_process.said();
        EXPECT_EQ(headset_process.stop(), 0) << headset_process.said();
        EXPECT_EQ(slow_process.stop(), 0);
        EXPECT_EQ(fast_process.stop(), 0);
    }

    static inline std::vector<Stream> streams;
};

TEST_F(Streams, NothingIsLostAndBytesAreTheDevices) {
    ASSERT_EQ(streams.size(), 4u);
    for (const Stream& stream : streams) {
        SCOPED_TRACE(stream.file);
        expect_contiguous(stream);
    }
    // 5 s, and a packet at each end may fall either way.
    EXPECT_NEAR(static_cast<double>(streams[0].got.size()), 5000.0, 50.0);
    EXPECT_NEAR(static_cast<double>(streams[1].got.size()), 305.0, 5.0);
    EXPECT_NEAR(static_cast<double>(streams[2].got.size()), 1255.0, 15.0);
    EXPECT_NEAR(static_cast<double>(streams[3].got.size()), 300.0, 5.0);
}

TEST_F(Streams, ComeAtTheirRatesInOrder) {
    ASSERT_EQ(streams.size(), 4u);
    for (const Stream& stream : streams) {
        SCOPED_TRACE(stream.file);
        expect_order(stream);
    }
    expect_rate(streams[0]);
    expect_rate(streams[2]);
    expect_rate(streams[3]);
}

TEST_F(Streams, CountersAndStampsOfReportsRunOn) {
    ASSERT_EQ(streams.size(), 4u);
    std::optional<dk2::InputReport11> before;
    for (const Packet& packet : streams[0].got) {
        const auto report = dk2::InputReport11::decode(packet.bytes);
        ASSERT_TRUE(report);
        if (before) {
            ASSERT_EQ(static_cast<std::uint16_t>(before->sample_count + before->num_samples),
                      report->sample_count);
            ASSERT_EQ(report->sample_timestamp_us - before->sample_timestamp_us,
                      1000u * report->num_samples);
        }
        before = *report;
    }
}

TEST_F(Streams, FramesAreWholeAndNumberedAndOfBothLengths) {
    ASSERT_EQ(streams.size(), 4u);
    for (const std::size_t s : {std::size_t{1}, std::size_t{2}}) {
        std::size_t samples = 0, heartbeats = 0;
        std::optional<std::uint32_t> before;
        for (const Packet& packet : streams[s].got) {
            const auto frame = gaze::decode_frame(packet.bytes);  // checks length and CRC
            ASSERT_TRUE(frame) << frame.error().text;
            const gaze::FrameHeader& header = std::visit(
                [](const auto& f) -> const gaze::FrameHeader& { return f.header; }, *frame);
            if (before) {
                ASSERT_EQ(header.sequence, *before + 1);
            }
            before = header.sequence;
            // Both are short reads of a transfer of 512 bytes.
            samples += packet.bytes.size() == gaze::SampleFrame::kSize;
            heartbeats += packet.bytes.size() == gaze::HeartbeatFrame::kSize;
        }
        EXPECT_EQ(samples + heartbeats, streams[s].got.size());
        EXPECT_GE(heartbeats, 4u);
    }
}

TEST_F(Streams, CameraFramesAreNumberedAndShowTheHeadsetsLeds) {
    ASSERT_EQ(streams.size(), 4u);
    std::optional<std::uint32_t> before;
    for (const Packet& packet : streams[3].got) {
        const auto header = camera::decode_header(packet.bytes);
        ASSERT_TRUE(header) << header.error().text;
        ASSERT_EQ(header->format, camera::kGrey) << "the kernel's quirk for 2833:0201";
        ASSERT_EQ(header->width_px, 752);
        ASSERT_EQ(header->height_px, 480);
        ASSERT_FALSE(header->damaged);
        if (before) {
            ASSERT_EQ(header->sequence, *before + 1);
        }
        before = header->sequence;
        ASSERT_GE(camera::find_blobs(camera::tracker_image(*header, packet.bytes)).size(), 4u);
    }
}

}  // namespace
}  // namespace foverig::test
