#pragma once
#include <stdexcept>

namespace foverig {

/// Input data that cannot be used: the message names the file, what was found, what was expected
/// and what to do. `main` prints it and exits with 3.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace foverig
