// From a packet's arrival (its read() has returned) to the sample in the hands of whoever asked,
// through the reader thread, the queue, decoder and clock map of a headset on the desk, or of one
// whose reports come over a socket. Beside it what a bare semaphore takes between two threads,
// which is the machine's part, and what one call takes when packets wait already, which is ours.
#include <benchmark/benchmark.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <semaphore>
#include <thread>

#include "bench/on_devices.h"
#include "bench/suites.h"
#include "devices/dk2/imu_source.h"
#include "devices/hardware/live_transport.h"
#include "rig/session/world.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/motion/catalog.h"

namespace foverig::bench {
namespace {

constexpr int kWarmUp = 500;
constexpr int kSamples = 10'000;  // 10 s at 1 kHz
constexpr auto kPeriod = std::chrono::milliseconds(1);

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
    explicit SocketLink(int fd) : fd_(fd) {}

    Status read(hardware::PacketQueue& packets) override {
        pollfd waiting{fd_, POLLIN, 0};
        if (poll(&waiting, 1, 10) <= 0) return Done{};
        std::array<std::byte, 64> report{};
        if (::read(fd_, report.data(), report.size()) != static_cast<ssize_t>(report.size()))
            return Done{};
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
    ManualClock idle_;
    std::unique_ptr<motion::HeadMotion> head_ = motion::make_head("still", 1).value();
    SimulatedDk2 answers_{idle_, *head_};
};

void send_reports(int fd, const std::stop_token& stop) {
    dk2::InputReport11 report;
    report.num_samples = 1;
    report.slots[0] = {{0, 98000, 0}, {100, -200, 300}};
    auto due = std::chrono::steady_clock::now();
    for (int i = 1; i <= kWarmUp + kSamples && !stop.stop_requested(); ++i) {
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

constexpr dvec3 kSent_m_s2{0.0, 9.8, 0.0};

/// A headset that has something to say a thousand times a second.
class Headset {
  public:
    virtual ~Headset() = default;
    virtual Transport& transport() = 0;
    virtual void start() {}
    /// A sample that it can have sent.
    virtual bool sent(const ImuSample& sample) const = 0;
};

class SocketHeadset final : public Headset {
  public:
    SocketHeadset(const Clock& clock, Feed feed)
        : feed_(std::move(feed)),
          transport_(std::move(hardware::LiveTransport::open(
                                   clock,
                                   [fd = feed_.fd()]() -> Result<std::unique_ptr<hardware::Link>> {
                                       return std::unique_ptr<hardware::Link>(
                                           std::make_unique<SocketLink>(fd));
                                   },
                                   {}))
                         .value()) {}
    Transport& transport() override { return *transport_; }
    void start() override { feed_.start(); }
    bool sent(const ImuSample& sample) const override {
        return glm::distance(sample.accel_m_s2, kSent_m_s2) < 1e-6;
    }

  private:
    Feed feed_;
    std::unique_ptr<hardware::LiveTransport> transport_;
};

class DeskHeadset final : public Headset {
  public:
    DeskHeadset(Clock& clock, const Options& options)
        : world_(make_world(on_devices({}, options), clock)) {}
    Transport& transport() override { return world_->headset(); }
    bool sent(const ImuSample& sample) const override {
        constexpr double kFull_m_s2 = 10.0 * 9.81;  // no axis tells more
        return glm::length(sample.accel_m_s2) < kFull_m_s2;
    }

  private:
    std::unique_ptr<World> world_;
};

/// Null: there is no socket pair to be had. Throws DeviceError where no headset is on the desk.
std::unique_ptr<Headset> open_headset(Clock& clock, const Options& options) {
    if (options.devices == "hardware") return std::make_unique<DeskHeadset>(clock, options);
    auto feed = Feed::begin();
    return feed ? std::make_unique<SocketHeadset>(clock, std::move(*feed)) : nullptr;
}

/// Whoever asks waits for each sample.
Durations_us waited_for(const Options& options) {
    WallClock clock;
    const auto headset = open_headset(clock, options);
    if (!headset) return std::nullopt;
    auto source = dk2::Dk2ImuSource::open(headset->transport(), clock.now()).value();
    headset->start();
    std::vector<double> us;
    for (int count = 0; count < kWarmUp + kSamples && clock.now() < HostTime(kLongest);) {
        const auto next = source.next(clock.now() + Nanoseconds(20'000'000));
        const HostTime now = clock.now();
        const auto* const sample = std::get_if<ImuSample>(&next);
        if (sample == nullptr) continue;
        if (!headset->sent(*sample)) return std::nullopt;
        if (++count > kWarmUp) us.push_back(1e3 * to_ms(now - sample->arrival));
    }
    if (source.counts().lost > 0) return std::nullopt;
    return us;
}

/// Whoever asks comes by 75 times a second, as frames do, and takes what is there.
Durations_us taken(const Options& options) {
    WallClock clock;
    const auto headset = open_headset(clock, options);
    if (!headset) return std::nullopt;
    auto source = dk2::Dk2ImuSource::open(headset->transport(), clock.now()).value();
    headset->start();
    std::vector<double> us;
    for (int count = 0; count < kWarmUp + kSamples && clock.now() < HostTime(kLongest);) {
        std::this_thread::sleep_for(std::chrono::microseconds(13'333));
        const HostTime frame = clock.now();
        while (true) {
            const HostTime asked = clock.now();
            const auto next = source.next(frame);
            const HostTime got = clock.now();
            const auto* const sample = std::get_if<ImuSample>(&next);
            if (sample == nullptr) break;
            if (!headset->sent(*sample)) return std::nullopt;
            if (++count > kWarmUp) us.push_back(1e3 * to_ms(got - asked));
        }
    }
    if (source.counts().lost > 0) return std::nullopt;
    us.resize(std::min<std::size_t>(us.size(), kSamples));
    return us;
}

/// One thread reads and tells another, and nothing else: always over a socket.
Durations_us told(const Options&) {
    auto begun = Feed::begin();
    if (!begun) return std::nullopt;
    Feed& feed = *begun;
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
    for (int count = 0; count < kWarmUp + kSamples && clock.now() < HostTime(kLongest); ++count) {
        if (!news.try_acquire_for(std::chrono::seconds(1))) return std::nullopt;
        const HostTime now = clock.now();
        if (count >= kWarmUp)
            us.push_back(1e3 * to_ms(now - HostTime(Nanoseconds(read_ns.load()))));
    }
    return us;
}

struct Way {
    const char* name;
    Durations_us (*measure)(const Options&);
    bool of_a_headset = true;
};

void run(benchmark::State& state, Bench& bench, const Way& c) {
    for (auto unused : state) {
        auto measured = c.measure(bench.options);
        if (!measured || measured->size() != kSamples)
            return state.SkipWithError("samples were lost or changed on the way");
        std::vector<double>& us = *measured;
        std::sort(us.begin(), us.end());
        const auto at = [&](double p) { return us[static_cast<std::size_t>(p * (kSamples - 1))]; };
        state.counters["p50_us"] = at(0.50);
        state.counters["p99_us"] = at(0.99);
        Json row = {{"samples", kSamples}};
        if (c.of_a_headset) row["devices"] = bench.options.devices;
        row.update({{"p50_us", at(0.50)},
                    {"p90_us", at(0.90)},
                    {"p99_us", at(0.99)},
                    {"p99_9_us", at(0.999)},
                    {"most_us", us.back()}});
        bench.results.add("transport", c.name, row);
    }
}

}  // namespace

void register_transport(Bench& bench) {
    for (const Way& c : {Way{"imu 1 kHz", waited_for}, Way{"bare hand-over", told, false},
                         Way{"imu 1 kHz, packets waiting", taken}}) {
        benchmark::RegisterBenchmark((std::string("BM_Transport/") + c.name).c_str(),
                                     [&bench, c](benchmark::State& state) { run(state, bench, c); })
            ->Iterations(1)
            ->UseRealTime()
            ->Unit(benchmark::kSecond);
    }
}

}  // namespace foverig::bench
