#pragma once
#include <stdexcept>

namespace foverig {

/// What is to trace and shade is not there, or failed: one sentence that says what and why.
struct BackendError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace foverig
