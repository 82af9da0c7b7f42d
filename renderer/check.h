#pragma once
#include <fmt/format.h>

#include <stdexcept>

namespace foverig {

/// A broken invariant of our own code (never bad input). `main` reports it and exits with 5.
struct InternalError : std::logic_error {
    using std::logic_error::logic_error;
};

}  // namespace foverig

/// RIG_CHECK(a <= b, "why it must hold"): always on in host code.
#define RIG_CHECK(condition, ...)                                                               \
    do {                                                                                        \
        if (!(condition)) [[unlikely]]                                                          \
            throw ::foverig::InternalError(fmt::format("{}:{}: {} does not hold: {}", __FILE__, \
                                                       __LINE__, #condition,                    \
                                                       fmt::format(__VA_ARGS__)));              \
    } while (false)
