#pragma once
// How a run can end badly: what `main` turns into an exit code and one sentence for a person.
#include <stdexcept>

namespace foverig {

enum class ExitCode {
    good = 0,
    check_failed = 1,  ///< a check that the user asked for
    usage = 2,         ///< command line or scenario
    input = 3,         ///< input data: scenes, run folders
    device = 4,
    internal = 5,
    different = 6,      ///< compare at fixed cost: not the same, which is neither better nor worse
    interrupted = 130,  ///< Ctrl-C before there was anything to keep
};

/// The command line or the scenario asks for something that cannot be: exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file that should be read cannot be: exit code 3.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A device failed and the run cannot go on: exit code 4.
struct DeviceError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace foverig
