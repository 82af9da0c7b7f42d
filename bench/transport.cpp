// Issue 4, bar 5: from a read() that returns to the sample in the hands of whoever asked, through
// the reader thread, the queue, decoder and clock map of a headset on the desk.
#include <benchmark/benchmark.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "bench/suites.h"
#include "devices/dk2/imu_source.h"
#include "devices/hardware/live_transport.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig::bench {
namespace {

constexpr int kWarmUp = 500;
constexpr int kReports = 10'000;  // 10 s at 1 kHz
constexpr auto kPeriod = std::chrono::milliseconds(1);

/// When read() returned, by the count of samples in the report.
using ReadTimes = std::vector<std::atomic<std::int64_t>>;

class Socket {
  public:
    explicit Socket(int fd) : fd_(fd) {}
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    ~Socket() { close(fd_); }
    int fd() const { return fd_; }

  private:
    int fd_;
};

/// A headset whose reports come over a socket and whose answers are a simulated one's.
class SocketLink final : public hardware::Link {
  public:
    SocketLink(int fd, const Clock& clock, ReadTimes& times)
        : fd_(fd), clock_(clock), times_(times) {}

    Status read(hardware::PacketQueue& packets) override {
        pollfd waiting{fd_, POLLIN, 0};
        if (poll(&waiting, 1, 10) <= 0) return Done{};
        std::array<std::byte, 64> report{};
        if (::read(fd_, report.data(), report.size()) != static_cast<ssize_t>(report.size()))
            return Done{};
        const HostTime now = clock_.now();
        if (const auto decoded = dk2::InputReport11::decode(report))
            times_[decoded->sample_count % times_.size()] = now.time_since_epoch().count();
        packets.push(report);
        return Done{};
    }
    Status control_set(std::uint8_t id, std::uint16_t value, Bytes data) override {
        return answers_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        return answers_.control_get(id, value, size);
    }

  private:
    int fd_;
    const Clock& clock_;
    ReadTimes& times_;
    ManualClock idle_;
    std::unique_ptr<motion::HeadMotion> head_ = motion::make_head("still", 1).value();
    SimulatedDk2 answers_{idle_, *head_};
};

void send_reports(int fd, const std::stop_token& stop) {
    dk2::InputReport11 report;
    report.num_samples = 1;
    report.slots[0] = {{0, 98000, 0}, {100, -200, 300}};
    auto due = std::chrono::steady_clock::now();
    for (int i = 1; i <= kWarmUp + kReports && !stop.stop_requested(); ++i) {
        report.sample_count = static_cast<std::uint16_t>(i);
        report.sample_timestamp_us = static_cast<std::uint32_t>(1000 * i);
        const auto bytes = report.encode();
        std::this_thread::sleep_until(due += kPeriod);
        if (write(fd, bytes.data(), bytes.size()) < 0) return;
    }
}

void run(benchmark::State& state, Bench& bench) {
    for (auto unused : state) {
        int pair[2];
        if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, pair) != 0)
            return state.SkipWithError("no socket pair");
        const Socket ours(pair[0]);
        const Socket theirs(pair[1]);
        const WallClock clock;
        ReadTimes times(std::size_t{1} << 16U);
        auto transport = hardware::LiveTransport::open(
            clock,
            [&]() -> Result<std::unique_ptr<hardware::Link>> {
                return std::unique_ptr<hardware::Link>(
                    std::make_unique<SocketLink>(ours.fd(), clock, times));
            },
            {});
        if (!transport) return state.SkipWithError(transport.error().text.c_str());
        auto opened = dk2::Dk2ImuSource::open(**transport, clock.now());
        if (!opened) return state.SkipWithError(opened.error().text.c_str());
        auto source = std::move(opened).value();
        const std::jthread sender(
            [fd = theirs.fd()](const std::stop_token& stop) { send_reports(fd, stop); });
        std::vector<double> us;
        const HostTime end = clock.now() + Nanoseconds(std::int64_t{60'000'000'000});
        int count = 0;
        while (count < kWarmUp + kReports && clock.now() < end) {
            const auto next = source.next(clock.now() + Nanoseconds(20'000'000));
            const HostTime now = clock.now();
            const auto* const sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) continue;
            if (sample->accel_m_s2 != dvec3(0.0, 9.8, 0.0) &&
                glm::distance(sample->accel_m_s2, dvec3(0.0, 9.8, 0.0)) > 1e-6)
                return state.SkipWithError("the sample is not what was sent");
            ++count;
            if (count <= kWarmUp) continue;
            const std::int64_t read = times[static_cast<std::size_t>(count) % times.size()].load();
            us.push_back(static_cast<double>(now.time_since_epoch().count() - read) * 1e-3);
        }
        if (source.counts().lost > 0 || us.size() != kReports)
            return state.SkipWithError("reports were lost on the way");
        std::sort(us.begin(), us.end());
        const auto at = [&](double p) { return us[static_cast<std::size_t>(p * (kReports - 1))]; };
        state.counters["p50_us"] = at(0.50);
        state.counters["p99_us"] = at(0.99);
        bench.results.add("transport", "imu 1 kHz",
                          {{"reports", kReports},
                           {"p50_us", at(0.50)},
                           {"p90_us", at(0.90)},
                           {"p99_us", at(0.99)},
                           {"p99_9_us", at(0.999)},
                           {"most_us", us.back()}});
    }
}

}  // namespace

void register_transport(Bench& bench) {
    benchmark::RegisterBenchmark("BM_Transport",
                                 [&bench](benchmark::State& state) { run(state, bench); })
        ->Iterations(1)
        ->UseRealTime()
        ->Unit(benchmark::kSecond);
}

}  // namespace foverig::bench
