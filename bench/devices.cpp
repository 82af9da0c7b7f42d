// Single steps of the device layer; each is proved right before it is timed.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/suites.h"
#include "devices/clock_map.h"
#include "devices/dk2/decoder.h"
#include "devices/fusion/head_fusion.h"
#include "devices/fusion/rotation.h"
#include "devices/gaze/frames.h"

namespace foverig::bench {
namespace {

void BM_Dk2ReportDecode(benchmark::State& state) {
    dk2::InputReport11 report;
    report.num_samples = 1;
    report.slots[0] = {{0, 98000, 0}, {100, -200, 300}};
    dk2::Dk2Decoder decoder;
    report.sample_timestamp_us = 1000;
    const auto first = decoder.decode(report.encode());
    if (!first || first->samples.size() != 1 ||
        glm::distance(first->samples[0].gyro_rad_s, dvec3(0.01, -0.02, 0.03)) > 1e-12)
        return state.SkipWithError("the sample is not what was encoded");
    // 4096 stamps of 2^20 us go once round the 32-bit clock, so the ring is always in order.
    std::vector<std::array<std::byte, dk2::InputReport11::kSize>> ring;
    for (int i = 0; i < 4096; ++i) {
        ++report.sample_count;
        report.sample_timestamp_us += std::uint32_t{1} << 20U;
        ring.push_back(report.encode());
    }
    std::size_t at = 0;
    for (auto unused : state) benchmark::DoNotOptimize(decoder.decode(ring[at++ % ring.size()]));
}

void BM_Sgz1Decode(benchmark::State& state) {
    gaze::SampleFrame frame;
    frame.header.sequence = 7;
    frame.exposure_ns = 123'456'789;
    frame.direction = {0.1F, -0.2F, 0.97F};
    auto bytes = frame.encode();
    const auto decoded = gaze::decode_frame(bytes);
    if (!decoded || std::get<gaze::SampleFrame>(*decoded).exposure_ns != frame.exposure_ns ||
        std::get<gaze::SampleFrame>(*decoded).direction != frame.direction)
        return state.SkipWithError("the frame is not what was encoded");
    bytes[100] ^= std::byte{1};
    if (gaze::decode_frame(bytes)) return state.SkipWithError("a flipped bit passes the CRC");
    bytes[100] ^= std::byte{1};
    for (auto unused : state) benchmark::DoNotOptimize(gaze::decode_frame(bytes));
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}

/// A device clock 100 ppm fast, a packet each millisecond, 0..0.25 ms late in a fixed pattern.
void BM_ClockMapUpdate(benchmark::State& state) {
    ClockMap<Dk2Time> map;
    std::int64_t k = 0;
    const auto update = [&] {
        const Dk2Time device(Nanoseconds(k * 1'000'100));
        map.update(device, HostTime(Nanoseconds(k * 1'000'000 + 500'000 + k * 7 % 5 * 50'000)));
        ++k;
        return device;
    };
    Dk2Time newest{};
    while (k < 60'000) newest = update();
    const Nanoseconds error =
        map.to_host(newest) - HostTime(Nanoseconds((k - 1) * 1'000'000 + 500'000));
    if (std::abs(to_ms(error)) > 0.05)
        return state.SkipWithError("a minute of packets does not give the clocks' relation");
    for (auto unused : state) benchmark::DoNotOptimize(map.to_host(update()));
}

/// A head that turns at 1 rad/s about the vertical; its sensor feels the centripetal acceleration
/// of the neck model.
void BM_FusionStep(benchmark::State& state) {
    HeadFusion fusion;
    ImuSample sample;
    sample.accel_m_s2 = {0.0, 9.80665, 0.0805};
    sample.gyro_rad_s = {0.0, 1.0, 0.0};
    const auto step = [&] {
        ++sample.sequence;
        sample.device_time += Nanoseconds(1'000'000);
        sample.host_time += Nanoseconds(1'000'000);
        fusion.add(sample);
    };
    for (int i = 0; i <= 1000; ++i) step();
    const dquat expected = exp_map(dvec3(0.0, 1.0, 0.0));
    if (angle_between(fusion.at(sample.host_time).world_from_head, expected) > 0.01)
        return state.SkipWithError("a second at 1 rad/s is not one radian");
    for (auto unused : state) {
        step();
        benchmark::DoNotOptimize(fusion.at(sample.host_time + Nanoseconds(13'000'000)));
    }
}

}  // namespace

void register_devices() {
    benchmark::RegisterBenchmark("BM_Dk2ReportDecode", BM_Dk2ReportDecode);
    benchmark::RegisterBenchmark("BM_Sgz1Decode", BM_Sgz1Decode);
    benchmark::RegisterBenchmark("BM_ClockMapUpdate", BM_ClockMapUpdate);
    benchmark::RegisterBenchmark("BM_FusionStep", BM_FusionStep);
}

}  // namespace foverig::bench
