#include "rig/identity/processor_use.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <sstream>

namespace foverig {

std::chrono::nanoseconds process_time() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::optional<ProcessorTimes> parse_processor_times(const std::string& line, double ticks_per_s) {
    std::istringstream words(line);
    std::string name;
    enum { user, nice, system, idle, iowait, irq, softirq, steal, count };
    std::array<double, count> s{};
    if (!(words >> name) || name != "cpu") return std::nullopt;
    for (double& seconds : s) {
        if (!(words >> seconds)) return std::nullopt;
        seconds /= ticks_per_s;
    }
    return ProcessorTimes{.busy_s = s[user] + s[nice] + s[system] + s[irq] + s[softirq],
                          .idle_s = s[idle] + s[iowait],
                          .stolen_s = s[steal]};
}

std::optional<ProcessorTimes> processor_times() {
    std::ifstream stream("/proc/stat");
    std::string line;
    if (!std::getline(stream, line)) return std::nullopt;
    auto times = parse_processor_times(line, static_cast<double>(sysconf(_SC_CLK_TCK)));
    if (!times) return std::nullopt;
    times->own_s = std::chrono::duration<double>(process_time()).count();
    times->processors = static_cast<int>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
    return times;
}

std::optional<ProcessorUse> use_between(const ProcessorTimes& before, const ProcessorTimes& after) {
    const double own_s = after.own_s - before.own_s;
    const double busy_s = after.busy_s - before.busy_s;
    const double idle_s = after.idle_s - before.idle_s;
    const double stolen_s = after.stolen_s - before.stolen_s;
    const double all_s = busy_s + idle_s + stolen_s;
    if (!(all_s > 0.0)) return std::nullopt;
    const double per_s = after.processors / all_s;
    // Ticks are coarse: over a short time this process can have more than they say.
    return ProcessorUse{.processors = after.processors,
                        .own = own_s * per_s,
                        .others = std::max(busy_s - own_s, 0.0) * per_s,
                        .stolen = stolen_s * per_s};
}

}  // namespace foverig
