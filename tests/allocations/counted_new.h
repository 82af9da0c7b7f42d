#pragma once
// This program's operator new counts.
#include <cstddef>

namespace foverig::test {

/// Made by all threads so far, but for what NotCounted covered.
std::size_t allocations();

/// What this thread allocates while one lives is the test's own affair.
class NotCounted {
  public:
    NotCounted();
    ~NotCounted();
    NotCounted(const NotCounted&) = delete;
    NotCounted& operator=(const NotCounted&) = delete;
};

}  // namespace foverig::test
