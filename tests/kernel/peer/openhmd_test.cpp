// A judge that we did not write: OpenHMD's driver and fusion on the exposed headset, against ours
// on the very bytes that it was sent.
#include <gtest/gtest.h>
#include <openhmd.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <thread>

#include "devices/dk2/imu_source.h"
#include "devices/fusion/head_fusion.h"
#include "devices/fusion/rotation.h"
#include "simulators/motion/recorded_head.h"
#include "tests/kernel/exposed.h"
#include "tests/kernel/recorded.h"

namespace foverig::test {
namespace {

constexpr double kStill_s = 20.0;  // opening takes a while; both begin level and at rest
constexpr double kMotion_s = 20.0;

struct Turned {
    double t_s;
    dquat world_from_head;
};

dquat about(const dvec3& axis, double degrees) {
    return glm::angleAxis(glm::radians(degrees), axis);
}

/// A look round: yaw to 40 degrees, pitch to 20, roll to 10, at up to 60 degrees per second.
dquat head_at(double t_s) {
    const double t = std::clamp(t_s - kStill_s, 0.0, kMotion_s);
    const double begun = std::min(t / 2.0, 1.0);  // softly
    const auto swing = [&](double period_s) {
        return begun * begun * std::sin(2.0 * std::numbers::pi * t / period_s);
    };
    return about({0, 1, 0}, 40.0 * swing(5.0)) * about({1, 0, 0}, 20.0 * swing(4.0)) *
           about({0, 0, 1}, 10.0 * swing(20.0 / 7.0));
}

std::string motion_file() {
    const std::string file = fresh_file("look.csv");
    std::ofstream out(file);
    out << "t_s,qw,qx,qy,qz\n";
    out.precision(12);
    for (int i = 0; i <= 250 * (kStill_s + kMotion_s); ++i) {
        const double t_s = 0.004 * i;
        const dquat q = head_at(t_s);
        out << t_s << ',' << q.w << ',' << q.x << ',' << q.y << ',' << q.z << '\n';
    }
    return file;
}

/// libusb without udevd sees no device that came after it: OpenHMD starts behind the headset.
bool wait_for_headset() {
    for (int i = 0; i < 6000; ++i) {  // as often as `opened` of drivers/desk.h tries
        for (const auto& device : std::filesystem::directory_iterator("/sys/bus/usb/devices")) {
            std::ifstream in(device.path() / "product");
            std::string product;
            if (std::getline(in, product) && product == "Rift DK2") return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
}

class OpenHmd {
  public:
    OpenHmd() : context_(ohmd_ctx_create()) {
        const int count = ohmd_ctx_probe(context_);
        for (int i = 0; i < count && headset_ == nullptr; ++i) {
            const std::string product = ohmd_list_gets(context_, i, OHMD_PRODUCT);
            if (product == "Rift (DK2)") headset_ = ohmd_list_open_device(context_, i);
        }
    }
    ~OpenHmd() { ohmd_ctx_destroy(context_); }
    OpenHmd(const OpenHmd&) = delete;
    OpenHmd& operator=(const OpenHmd&) = delete;

    bool is_open() const { return headset_ != nullptr; }
    const char* error() const { return ohmd_ctx_get_error(context_); }
    int width_px() const {
        int width = 0;
        ohmd_device_geti(headset_, OHMD_SCREEN_HORIZONTAL_RESOLUTION, &width);
        return width;
    }
    dquat update() {
        ohmd_ctx_update(context_);
        float q[4] = {0, 0, 0, 1};
        ohmd_device_getf(headset_, OHMD_ROTATION_QUAT, q);
        return {q[3], q[0], q[1], q[2]};
    }

  private:
    ohmd_context* context_;
    ohmd_device* headset_ = nullptr;
};

/// OpenHMD's orientation, each few milliseconds of `clock`.
std::vector<Turned> watched(OpenHmd& peer, const Clock& clock, double until_s) {
    std::vector<Turned> turned;
    while (to_seconds(clock.now().time_since_epoch()) < until_s) {
        const dquat q = peer.update();
        turned.push_back({to_seconds(clock.now().time_since_epoch()), q});
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
    return turned;
}

/// Our own driver's decoder and fusion on the recorded reports, by their arrival.
std::vector<Turned> fused(const std::string& file) {
    const auto recording = Recording::open(file);
    EXPECT_TRUE(recording);
    ManualClock clock;
    ReplayedDevice replayed(*recording, "dk2", clock, {});
    dk2::Dk2Decoder decoder{dk2::FactoryCalibration{}};
    HeadFusion fusion;
    std::vector<Turned> turned;
    for (const Packet& packet : recorded_packets(file, "dk2")) {
        const auto decoded = decoder.decode(packet.bytes);
        EXPECT_TRUE(decoded);
        if (!decoded) continue;
        for (ImuSample sample : decoded->samples) {
            sample.host_time = packet.arrival;
            fusion.add(sample);
        }
        turned.push_back({to_seconds(packet.arrival.time_since_epoch()),
                          fusion.at(packet.arrival).world_from_head});
    }
    return turned;
}

dquat at(const std::vector<Turned>& turned, double t_s) {
    const auto later = std::lower_bound(turned.begin(), turned.end(), t_s,
                                        [](const Turned& t, double s) { return t.t_s < s; });
    if (later == turned.begin()) return turned.front().world_from_head;
    if (later == turned.end()) return turned.back().world_from_head;
    const auto earlier = std::prev(later);
    const double share = (t_s - earlier->t_s) / (later->t_s - earlier->t_s);
    return glm::slerp(earlier->world_from_head, later->world_from_head, share);
}

double angle_deg(const dquat& a, const dquat& b) {
    const dquat d = glm::conjugate(a) * b;
    return glm::degrees(2.0 * std::atan2(glm::length(dvec3(d.x, d.y, d.z)), std::abs(d.w)));
}

/// Largest angle between the two over the motion, where `b`'s clock is ahead by `offset_s`.
double worst_deg(const std::vector<Turned>& a, const std::vector<Turned>& b, double from_s,
                 double offset_s, double step_s) {
    double worst = 0.0;
    for (double t_s = from_s; t_s < from_s + kMotion_s; t_s += step_s) {
        worst = std::max(worst, angle_deg(at(a, t_s), at(b, t_s + offset_s)));
    }
    return worst;
}

}  // namespace

TEST(Peer, OpenHmdAgreesWithOurFusionWithinOneDegree) {
    const std::string file = fresh_file("sent.mcap");
    const WallClock clock;
    Exposed process({"dk2", "--set", "motion.head=" + motion_file(), "--record", file});
    ASSERT_TRUE(wait_for_headset());
    std::optional<OpenHmd> peer(std::in_place);
    ASSERT_TRUE(peer->is_open()) << peer->error();
    const double opened_s = to_seconds(clock.now().time_since_epoch());
    ASSERT_LT(opened_s, kStill_s - 1.0) << "the head moves already";
    EXPECT_EQ(peer->width_px(), 1920);
    const auto theirs = watched(*peer, clock, kStill_s + kMotion_s + 3.0);
    peer.reset();  // it has a thread that reads on
    EXPECT_EQ(process.stop(), 0) << process.said();
    std::printf("%s", process.said().c_str());
    const auto ours = fused(file);
    ASSERT_GT(ours.size(), 25'000u);

    // The two programs' clocks began at different instants: the difference is the one that fits.
    double offset_s = 0.0, worst = 1e9;
    for (const double step_s : {0.05, 0.005, 0.0005}) {
        const double middle_s = offset_s;
        const double reach_s = step_s == 0.05 ? kStill_s : 12.0 * step_s;
        for (double o_s = middle_s - reach_s; o_s <= middle_s + reach_s; o_s += step_s) {
            const double deg = worst_deg(ours, theirs, kStill_s, o_s, 0.1);
            if (deg < worst) worst = deg, offset_s = o_s;
        }
    }
    worst = worst_deg(ours, theirs, kStill_s, offset_s, 0.01);
    double moved = 0.0, off_truth = 0.0;
    for (double t_s = kStill_s; t_s < kStill_s + kMotion_s; t_s += 0.01) {
        moved = std::max(moved, angle_deg(at(ours, t_s), dquat(1, 0, 0, 0)));
        off_truth = std::max(off_truth, angle_deg(at(ours, t_s), head_at(t_s)));
    }
    std::printf(
        "OpenHMD is off ours by at most %.3f degrees, ours off the truth by %.3f, over %.0f s "
        "and %.1f degrees\n",
        worst, off_truth, kMotion_s, moved);
    EXPECT_GT(moved, 35.0) << "the head hardly moved: nothing was judged";
    EXPECT_LT(worst, 1.0);
    EXPECT_LT(off_truth, 1.0);
}

}  // namespace foverig::test
