#pragma once
#include <chrono>
#include <optional>
#include <string>

namespace foverig {

/// Processor time of this process so far, all its threads. What the machine's host gave to other
/// guests is not in it where the kernel knows of it, as Linux does of KVM, Xen and Hyper-V.
std::chrono::nanoseconds process_time();

/// Seconds of all processors of this machine since it started.
struct ProcessorTimes {
    double own_s = 0.0;     ///< of this process
    double busy_s = 0.0;    ///< of everything, this process too
    double idle_s = 0.0;    ///< ... and waiting for disks
    double stolen_s = 0.0;  ///< the machine's host gave them to other guests
    int processors = 1;     ///< that the machine has
};

/// The first line of /proc/stat, in ticks of which `ticks_per_s` are a second; no value for what is
/// none.
std::optional<ProcessorTimes> parse_processor_times(const std::string& line, double ticks_per_s);

/// Now. No value where the system does not tell.
std::optional<ProcessorTimes> processor_times();

/// What became of a machine's processors over some time; 1.5 is one and a half of them.
struct ProcessorUse {
    int processors = 1;  ///< that it has
    double own = 0.0;
    double others = 0.0;  ///< had by other programs of this machine
    double stolen = 0.0;  ///< given to other guests by its host

    double elsewhere() const { return others + stolen; }
};

/// No value where none passed.
std::optional<ProcessorUse> use_between(const ProcessorTimes& before, const ProcessorTimes& after);

}  // namespace foverig
