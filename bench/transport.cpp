// Issue 4, bar 5: from a read() that returns to the sample in the hands of whoever asked, through
// the reader thread, the queue, decoder and clock map of a headset on the desk. Beside it what a
// bare semaphore takes between two threads, which is the machine's part, and what one call takes
// when packets wait already, which is ours.
#include <benchmark/benchmark.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <semaphore>
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

/// Both ends, and what sends.
class Feed {
  public:
    static std::optional<Feed> begin() {
        int pair[2];
        if (socketpair(AF_UNIX, SOCK_SEQPACKET, 0, pair) != 0) return std::nullopt;
        return Feed(pair[0], pair[1]);
    }
    int fd() const { return ours_->fd(); }
    void start() {
        sender_ = std::jthread(
            [fd = theirs_->fd()](const std::stop_token& stop) { send_reports(fd, stop); });
    }

  private:
    Feed(int ours, int theirs)
        : ours_(std::make_unique<Socket>(ours)), theirs_(std::make_unique<Socket>(theirs)) {}

    std::unique_ptr<Socket> ours_, theirs_;
    std::jthread sender_;  // last: stops first
};

constexpr Nanoseconds kLongest{60'000'000'000};

/// Of each sample after the warm-up. A way returns nothing where it failed.
using Durations_us = std::optional<std::vector<double>>;

bool is_what_was_sent(const ImuSample& sample) {
    return glm::distance(sample.accel_m_s2, dvec3(0.0, 9.8, 0.0)) < 1e-6;
}

struct Desk {
    Feed& feed;
    const WallClock clock{};
    ReadTimes times = ReadTimes(std::size_t{1} << 16U);
    std::unique_ptr<hardware::LiveTransport> transport =
        std::move(hardware::LiveTransport::open(
                      clock,
                      [this]() -> Result<std::unique_ptr<hardware::Link>> {
                          return std::unique_ptr<hardware::Link>(
                              std::make_unique<SocketLink>(feed.fd(), clock, times));
                      },
                      {}))
            .value();
    dk2::Dk2ImuSource source = dk2::Dk2ImuSource::open(*transport, clock.now()).value();
};

/// Whoever asks waits for each sample.
Durations_us waited_for(Feed& feed) {
    Desk desk{feed};
    feed.start();
    std::vector<double> us;
    for (int count = 0; count < kWarmUp + kReports && desk.clock.now() < HostTime(kLongest);) {
        const auto next = desk.source.next(desk.clock.now() + Nanoseconds(20'000'000));
        const HostTime now = desk.clock.now();
        const auto* const sample = std::get_if<ImuSample>(&next);
        if (sample == nullptr) continue;
        if (!is_what_was_sent(*sample)) return std::nullopt;
        if (++count <= kWarmUp) continue;
        const auto index = static_cast<std::size_t>(count) % desk.times.size();
        const HostTime read{Nanoseconds(desk.times[index].load())};
        us.push_back(1e3 * to_ms(now - read));
    }
    if (desk.source.counts().lost > 0) return std::nullopt;
    return us;
}

/// Whoever asks comes by 75 times a second, as frames do, and takes what is there.
Durations_us taken(Feed& feed) {
    Desk desk{feed};
    feed.start();
    std::vector<double> us;
    for (int count = 0; count < kWarmUp + kReports && desk.clock.now() < HostTime(kLongest);) {
        std::this_thread::sleep_for(std::chrono::microseconds(13'333));
        const HostTime frame = desk.clock.now();
        while (true) {
            const HostTime asked = desk.clock.now();
            const auto next = desk.source.next(frame);
            const HostTime got = desk.clock.now();
            const auto* const sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            if (!is_what_was_sent(*sample)) return std::nullopt;
            if (++count > kWarmUp) us.push_back(1e3 * to_ms(got - asked));
        }
    }
    if (desk.source.counts().lost > 0) return std::nullopt;
    us.resize(std::min<std::size_t>(us.size(), kReports));
    return us;
}

/// One thread reads and tells another, and nothing else.
Durations_us told(Feed& feed) {
    const WallClock clock;
    std::counting_semaphore<> news{0};
    std::atomic<std::int64_t> read_ns{0};
    const std::jthread reader([&](const std::stop_token& stop) {
        const sched_param priority{.sched_priority = hardware::kReaderPriority};
        (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);  // as the driver's
        while (!stop.stop_requested()) {
            pollfd waiting{feed.fd(), POLLIN, 0};
            if (poll(&waiting, 1, 10) <= 0) continue;
            std::array<std::byte, 64> report{};
            if (::read(feed.fd(), report.data(), report.size()) <= 0) continue;
            read_ns = clock.now().time_since_epoch().count();
            news.release();
        }
    });
    feed.start();
    std::vector<double> us;
    for (int count = 0; count < kWarmUp + kReports && clock.now() < HostTime(kLongest); ++count) {
        if (!news.try_acquire_for(std::chrono::seconds(1))) return std::nullopt;
        const HostTime now = clock.now();
        if (count >= kWarmUp)
            us.push_back(1e3 * to_ms(now - HostTime(Nanoseconds(read_ns.load()))));
    }
    return us;
}

struct Way {
    const char* name;
    Durations_us (*measure)(Feed&);
};

void run(benchmark::State& state, Bench& bench, const Way& c) {
    for (auto unused : state) {
        auto feed = Feed::begin();
        if (!feed) return state.SkipWithError("no socket pair");
        auto measured = c.measure(*feed);
        if (!measured || measured->size() != kReports)
            return state.SkipWithError("reports were lost or changed on the way");
        std::vector<double>& us = *measured;
        std::sort(us.begin(), us.end());
        const auto at = [&](double p) { return us[static_cast<std::size_t>(p * (kReports - 1))]; };
        state.counters["p50_us"] = at(0.50);
        state.counters["p99_us"] = at(0.99);
        bench.results.add("transport", c.name,
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
    for (const Way& c : {Way{"imu 1 kHz", waited_for}, Way{"bare hand-over", told},
                         Way{"imu 1 kHz, packets waiting", taken}}) {
        benchmark::RegisterBenchmark((std::string("BM_Transport/") + c.name).c_str(),
                                     [&bench, c](benchmark::State& state) { run(state, bench, c); })
            ->Iterations(1)
            ->UseRealTime()
            ->Unit(benchmark::kSecond);
    }
}

}  // namespace foverig::bench
