// libFuzzer target: the drivers on devices whose packets and answers are mangled on the way. The
// input is a script: which device, then what befalls each packet and each answer. A driver must
// stay alive and hand on nothing but numbers. scripts/fuzz runs it.
#include <cmath>
#include <cstdlib>

#include "devices/camera/blobs.h"
#include "devices/camera/tracker_camera.h"
#include "devices/crc32.h"
#include "devices/dk2/imu_source.h"
#include "devices/dk2/leds.h"
#include "devices/gaze/gaze_source.h"
#include "simulators/camera/simulated_camera.h"
#include "simulators/dk2/simulated_dk2.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/catalog.h"

namespace foverig {
namespace {

constexpr int kMostPackets = 60;

class Script {
  public:
    explicit Script(Bytes bytes) : left_(bytes) {}

    bool over() const { return left_.empty(); }
    unsigned byte() {
        if (left_.empty()) return 0;
        const auto value = static_cast<unsigned>(left_.front());
        left_ = left_.subspan(1);
        return value;
    }
    Bytes take(std::size_t count) {
        const Bytes taken = left_.first(std::min(count, left_.size()));
        left_ = left_.subspan(taken.size());
        return taken;
    }

  private:
    Bytes left_;
};

enum class Harm : unsigned { none, cut, flip, grow, replace, seal, count };

void harm(std::vector<std::byte>& bytes, Script& script) {
    const unsigned op = script.byte();
    const unsigned where = script.byte();
    switch (static_cast<Harm>(op % static_cast<unsigned>(Harm::count))) {
        case Harm::cut:
            bytes.resize(std::min<std::size_t>(bytes.size(), where));
            break;
        case Harm::flip:
        case Harm::seal:
            for (unsigned i = 0; i <= op / 64 && !bytes.empty(); ++i)
                bytes[(where + script.byte() * 7) % bytes.size()] ^= std::byte(script.byte());
            break;
        case Harm::grow:
            bytes.resize(bytes.size() + where, std::byte(op));
            break;
        case Harm::replace: {
            const Bytes other = script.take(where);
            bytes.assign(other.begin(), other.end());
            break;
        }
        default:
            break;
    }
    // With a good seal a gaze frame's body gets past its CRC.
    constexpr std::size_t kSeal = 4;
    if (op % static_cast<unsigned>(Harm::count) != static_cast<unsigned>(Harm::seal) ||
        bytes.size() <= kSeal)
        return;
    const std::uint32_t crc = crc32(Bytes(bytes).first(bytes.size() - kSeal));
    for (std::size_t i = 0; i < kSeal; ++i)
        bytes[bytes.size() - kSeal + i] = std::byte((crc >> (8U * i)) & 0xFFU);
}

/// A device between which and its driver a script stands.
class Mangled final : public Transport {
  public:
    Mangled(Transport& device, Script& script) : device_(device), script_(script) {}

    NextPacket next(HostTime deadline) override {
        if (script_.over() || ++packets_ > kMostPackets) return EndOfStream{};
        NextPacket next = device_.next(deadline);
        auto* const packet = std::get_if<Packet>(&next);
        if (packet == nullptr) return next;
        std::vector<std::byte> bytes = std::move(packet->bytes).release();
        harm(bytes, script_);
        packet->bytes = std::move(bytes);
        return next;
    }
    Status control_set(std::uint8_t id, std::uint16_t value,
                       std::span<const std::byte> data) override {
        return device_.control_set(id, value, data);
    }
    Result<std::vector<std::byte>> control_get(std::uint8_t id, std::uint16_t value,
                                               std::size_t size) override {
        auto answer = device_.control_get(id, value, size);
        if (!answer || script_.byte() % 8 != 1) return answer;
        std::vector<std::byte> bytes = std::move(answer).value();
        harm(bytes, script_);
        return bytes;
    }

  private:
    Transport& device_;
    Script& script_;
    int packets_ = 0;
};

void require(bool good) {
    if (!good) std::abort();
}

bool finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// All that a source gives until its stream ends, or `clock` has gone on for a while.
template <class Source, class OnSample>
void drain(Source& source, ManualClock& clock, const OnSample& on_sample) {
    const HostTime end = clock.now() + Nanoseconds(std::int64_t{1'000'000'000});
    while (clock.now() < end) {
        const auto next = source.next(clock.now() + Nanoseconds(20'000'000));
        if (std::holds_alternative<EndOfStream>(next)) return;
        if (const auto* sample = std::get_if<typename Source::Sample>(&next))
            on_sample(*sample);
        else
            clock.advance(Nanoseconds(20'000'000));
    }
}

void run_dk2(Script& script) {
    ManualClock clock;
    const auto head = motion::make_head("look", 3).value();
    SimulatedDk2 device(clock, *head);
    Mangled mangled(device, script);
    auto opened = dk2::Dk2ImuSource::open(mangled, clock.now(), {.light_leds = true});
    if (!opened) return;
    auto source = std::move(opened).value();
    drain(source, clock, [](const ImuSample& sample) {
        require(finite(sample.accel_m_s2) && finite(sample.gyro_rad_s) &&
                std::isfinite(sample.temperature_c));
    });
    (void)source.take_panel_readbacks();
    (void)source.take_exposures();
    (void)dk2::read_leds(mangled);
}

void run_gaze(Script& script) {
    ManualClock clock;
    const auto eyes = motion::make_eye("scan", 3).value();
    SimulatedGaze device(clock, *eyes);
    Mangled mangled(device, script);
    auto opened = gaze::GazeSource::open(mangled, clock);
    if (!opened) return;
    auto source = std::move(opened).value();
    drain(source, clock, [](const GazeSample& sample) {
        for (const GazeRay& ray : {sample.left.ray, sample.right.ray, sample.combined})
            require(!ray.valid ||
                    (finite(ray.direction) && std::abs(glm::length(ray.direction) - 1.0) < 1e-6));
    });
    (void)source.take_events();
}

void run_camera(Script& script) {
    ManualClock clock;
    const auto head = motion::make_head("look", 3).value();
    SimulatedDk2 headset(clock, *head);
    const auto leds = dk2::read_leds(headset);
    SimulatedCamera device(clock, *head, headset,
                           {.leds = leds.value(), .yuyv = script.byte() % 2 == 1});
    Mangled mangled(device, script);
    auto opened = camera::TrackerCamera::open(mangled, camera::Sync::free_running);
    if (!opened) return;
    auto source = std::move(opened).value();
    drain(source, clock, [](const camera::CameraFrame& frame) {
        for (const camera::Blob& blob : camera::find_blobs(frame.image()))
            require(std::isfinite(blob.center_px.x) && std::isfinite(blob.center_px.y));
    });
}

}  // namespace

int fuzz_streams(const std::uint8_t* data, std::size_t size) {
    Script script(Bytes(reinterpret_cast<const std::byte*>(data), size));
    switch (script.byte() % 3) {
        case 0:
            run_dk2(script);
            break;
        case 1:
            run_gaze(script);
            break;
        default:
            run_camera(script);
            break;
    }
    return 0;
}

}  // namespace foverig

#if defined(FOVERIG_FUZZER)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return foverig::fuzz_streams(data, size);
}
#endif
