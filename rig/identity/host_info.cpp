#include "rig/identity/host_info.h"

#include <sched.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

namespace foverig {
namespace {

/// The value of the first line "key<separator>value" of a file.
std::optional<std::string> value_in(const char* file, const std::string& key, char separator) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (line.rfind(key, 0) != 0) continue;
        const auto at = line.find(separator);
        if (at == std::string::npos) continue;
        std::string value = line.substr(at + 1);
        value.erase(0, value.find_first_not_of(" \t\""));
        value.erase(value.find_last_not_of(" \t\"") + 1);
        if (!value.empty()) return value;
    }
    return std::nullopt;
}

unsigned usable_cores() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) return static_cast<unsigned>(CPU_COUNT(&set));
    return std::thread::hardware_concurrency();
}

std::optional<std::string> system_name() {
    const auto distribution = value_in("/etc/os-release", "PRETTY_NAME", '=');
    utsname kernel{};
    if (uname(&kernel) != 0) return distribution;
    const std::string name = std::string(kernel.sysname) + " " + kernel.release;
    return distribution ? *distribution + ", " + name : name;
}

}  // namespace

HostInfo host_info() {
    return {.cpu = value_in("/proc/cpuinfo", "model name", ':'),
            .cores = usable_cores(),
            .os = system_name()};
}

std::uint64_t peak_rss_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts KiB
}

}  // namespace foverig
