// trace.pftrace, decoded by the field numbers of Perfetto's own schema.
#include "rig/exports/perfetto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <set>

#include "rig/exports/protobuf.h"
#include "tests/rig/exports/some_run.h"
#include "tests/rig/exports/wire_reader.h"

namespace foverig::exports {
namespace {

namespace fs = std::filesystem;
using test::WireMessage;

/// A track event with what its packet says of it.
struct Event {
    std::uint64_t at_ns = 0;
    std::string track;
    std::string name;
    std::uint64_t type = 0;
    WireMessage fields;

    std::set<std::uint64_t> numbers(std::uint32_t field) const {
        std::set<std::uint64_t> all;
        for (auto [at, end] = fields.equal_range(field); at != end; ++at)
            all.insert(at->second.number);
        return all;
    }
};

class PerfettoTrace : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("perfetto_test_" + std::to_string(getpid()));
        bytes_ = perfetto_trace(test::some_run(folder_));
        std::map<std::uint64_t, std::string> tracks;
        const WireMessage trace = test::read_wire(bytes_);
        for (const auto& [number, field] : trace) {
            ASSERT_EQ(number, 1U);  // Trace.packet
            const WireMessage packet = test::read_wire(field.bytes);
            EXPECT_EQ(packet.find(10)->second.number, 1U);  // trusted_packet_sequence_id
            if (const auto found = packet.find(60); found != packet.end()) {
                const WireMessage track = test::read_wire(found->second.bytes);
                tracks[track.find(1)->second.number] = track.find(2)->second.bytes;
                continue;
            }
            Event event;
            event.at_ns = packet.find(8)->second.number;
            event.fields = test::read_wire(packet.find(11)->second.bytes);
            event.type = event.fields.find(9)->second.number;
            event.track = tracks.at(event.fields.find(11)->second.number);
            if (const auto name = event.fields.find(23); name != event.fields.end())
                event.name = name->second.bytes;
            events_.push_back(event);
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::vector<Event> of_frame(std::uint64_t frame) const {
        std::vector<Event> found;
        for (const Event& event : events_)
            if (event.fields.contains(52) && event.fields.find(52)->second.number == frame)
                found.push_back(event);
        return found;
    }

    fs::path folder_;
    std::string bytes_;
    std::vector<Event> events_;
};

TEST_F(PerfettoTrace, LeadsAnArrowFromTheSensorsSampleToThePhoton) {
    std::vector<std::string> way;
    for (const Event& event : events_)
        if (event.numbers(47).contains(7) || event.numbers(48).contains(7))  // frame 3, motion
            way.push_back(event.track);
    EXPECT_THAT(way, testing::ElementsAre("imu sample to arrival", "frame", "frame",
                                          "present to VSync", "VSync to photon", "photon"));
    for (const Event& event : events_)
        EXPECT_EQ(event.numbers(48).contains(7),
                  event.track == "photon" && event.at_ns == 71'000'000)
            << event.track;
}

TEST_F(PerfettoTrace, SharesOneGazeSampleBetweenTheFramesThatUsedIt) {
    std::size_t samples = 0;
    for (const Event& event : events_)
        if (event.track == "gaze sample to arrival" && event.type == 1) {
            EXPECT_EQ(event.numbers(47).size(), 2U);
            ++samples;
        }
    EXPECT_EQ(samples, 6U);
}

TEST_F(PerfettoTrace, HoldsEachInstantOfAFrameOnItsTrack) {
    // Everything lies 12 ms later: the first gaze sample was taken 12 ms before 0.
    const auto events = of_frame(5);
    ASSERT_EQ(events.size(), 6U);
    std::map<std::string, std::uint64_t> at;
    for (const Event& event : events) at[event.track + "/" + event.name] = event.at_ns;
    EXPECT_EQ(at.at("imu sample to arrival/sample"), 75'000'000U);
    EXPECT_EQ(at.at("frame/render"), 77'000'000U);
    EXPECT_EQ(at.at("frame/lens"), 85'000'000U);
    EXPECT_EQ(at.at("present to VSync/waiting"), 86'000'000U);
    EXPECT_EQ(at.at("VSync to photon/scan-out"), 90'000'000U);
    EXPECT_EQ(at.at("photon/photon"), 97'000'000U);
}

TEST_F(PerfettoTrace, SaysOfADroppedFrameThatItWasDropped) {
    std::vector<std::string> names;
    for (const Event& event : of_frame(6)) names.push_back(event.name);
    EXPECT_THAT(names,
                testing::UnorderedElementsAre("sample", "sample", "render", "lens", "dropped"));
}

TEST_F(PerfettoTrace, EndsEverySliceThatItBeginsAndNestsNone) {
    std::map<std::string, std::uint64_t> open, end_ns;
    for (const Event& event : events_) {
        if (event.type == 1) {
            EXPECT_EQ(open[event.track]++, 0U) << event.track;
            EXPECT_GE(event.at_ns, end_ns[event.track]) << event.track;
        }
        if (event.type == 2) {
            EXPECT_EQ(open[event.track]--, 1U) << event.track;
            end_ns[event.track] = event.at_ns;
        }
    }
    for (const auto& [track, count] : open) EXPECT_EQ(count, 0U) << track;
}

TEST_F(PerfettoTrace, TellsPassesAndCountsBesideTheEvents) {
    bool told = false;
    std::vector<double> frame_ms;
    for (const Event& event : events_) {
        for (auto [at, end] = event.fields.equal_range(4); at != end; ++at) {
            const WireMessage annotation = test::read_wire(at->second.bytes);
            told |= annotation.find(10)->second.bytes == "pass.trace_primary_ms" &&
                    annotation.find(5)->second.as_double() == 5.0;
        }
        if (event.track == "frame time")
            frame_ms.push_back(event.fields.find(44)->second.as_double());
    }
    EXPECT_TRUE(told);
    EXPECT_THAT(frame_ms, testing::Each(testing::DoubleNear(9.0, 1e-9)));
    EXPECT_EQ(frame_ms.size(), 12U);
}

TEST_F(PerfettoTrace, IsReadByProtocToo) {
    if (std::system("command -v protoc > /dev/null") != 0)
        GTEST_SKIP() << "no protoc (protobuf-compiler) on this machine";
    const fs::path file = folder_ / "trace.pftrace", text = folder_ / "trace.txt";
    std::ofstream(file, std::ios::binary) << bytes_;
    const std::string command =
        "protoc --decode_raw < '" + file.string() + "' > '" + text.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ostringstream decoded;
    decoded << std::ifstream(text).rdbuf();
    std::size_t packets = 0;
    for (std::size_t at = 0; (at = decoded.str().find("\n1 {", at)) != std::string::npos; ++at)
        ++packets;
    EXPECT_EQ(packets + 1, test::read_wire(bytes_).size());
    EXPECT_THAT(decoded.str(), testing::HasSubstr("23: \"scan-out\""));
}

TEST(ProtobufMessage, WritesTheExamplesOfItsSpecification) {
    ProtobufMessage a, b, c;
    EXPECT_EQ(a.varint(1, 150).bytes(), std::string("\x08\x96\x01", 3));
    EXPECT_EQ(b.text(2, "testing").bytes(), "\x12\x07testing");
    EXPECT_EQ(c.message(3, a).bytes(), std::string("\x1a\x03\x08\x96\x01", 5));
    ProtobufMessage d;
    EXPECT_EQ(d.number(1, 25.4).bytes(), std::string("\x09\x66\x66\x66\x66\x66\x66\x39\x40", 9));
}

}  // namespace
}  // namespace foverig::exports
