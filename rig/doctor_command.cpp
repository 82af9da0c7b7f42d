#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "devices/time.h"
#include "renderer/backends/embree/embree_api.h"
#include "renderer/renderer.h"
#include "rig/commands.h"
#include "rig/doctor_devices.h"
#include "rig/doctor_display.h"
#include "rig/identity/build_info.h"
#include "rig/identity/gpu_info.h"
#include "rig/identity/host_info.h"

namespace foverig {
namespace {

constexpr double kGoodSleep_ms = 1.0;

void print_row(const char* name, const std::string& text) {
    fmt::print("{:<14} {}\n", name, text);
}

/// Smallest step between two readings of the wall clock.
Nanoseconds clock_step() {
    const WallClock clock;
    Nanoseconds least = Nanoseconds::max();
    for (int i = 0; i < 1000; ++i) {
        const HostTime before = clock.now();
        HostTime after = clock.now();
        while (after == before) after = clock.now();
        least = std::min(least, after - before);
    }
    return least;
}

/// How late sleeps of 2 ms end: the worst of 50.
double worst_sleep_ms() {
    WallClock clock;
    double worst = 0.0;
    for (int i = 0; i < 50; ++i) {
        const HostTime deadline = clock.now() + Nanoseconds(2'000'000);
        clock.sleep_until(deadline);
        worst = std::max(worst, to_ms(clock.now() - deadline));
    }
    return worst;
}

}  // namespace

ExitCode doctor_command() {
    const BuildInfo build = build_info();
    const HostInfo host = host_info();
    print_row("foverig",
              fmt::format("{} ({})", build.version, build.git.value_or("no commit known")));
    print_row("built", fmt::format("{}, {}, {}", build.build_type, build.compiler, build.flags));
    print_row("system", host.os.value_or("unknown"));
    print_row("cpu", fmt::format("{}, {} cores for us", host.cpu.value_or("unknown"), host.cores));
    print_row("embree", fmt::format("{} (backend embree)", RTC_VERSION_STRING));
    const double sleep_ms = worst_sleep_ms();
    print_row("clock", fmt::format("steps of {} ns; sleeps end up to {:.3f} ms late: {}",
                                   clock_step().count(), sleep_ms,
                                   sleep_ms <= kGoodSleep_ms
                                       ? "good for the wall clock"
                                       : "on the wall clock frames will begin late; use "
                                         "--clock lockstep, or leave the machine alone"));
    print_row("gpu", gpu_text(find_gpus()));
    const BackendChoice choice = choose_backend({});
    print_row("backend auto", fmt::format("{}: {}", choice.name, choice.why));
    for (const DoctorRow& row : examine_devices()) print_row(row.name, row.text);
    for (const DoctorRow& row : examine_displays()) print_row(row.name, row.text);
    print_row("try", "foverig run");
    return ExitCode::good;
}

}  // namespace foverig
