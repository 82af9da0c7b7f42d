#pragma once
// For ThreadSanitizer alone: TBB is not compiled with it, so that the tool cannot see that a task
// comes after its spawn, and the return of a parallel loop after its tasks. Says so, and nothing
// else: two tasks of a loop stay unordered. No code in any other build.
#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace foverig::task_order {

#if defined(__SANITIZE_THREAD__)
inline constexpr char kSpawned = 0;
inline constexpr char kEnded = 0;
inline void before_loop() {
    __tsan_release(const_cast<char*>(&kSpawned));
}
inline void task_begins() {
    __tsan_acquire(const_cast<char*>(&kSpawned));
}
inline void task_ends() {
    __tsan_release(const_cast<char*>(&kEnded));
}
inline void after_loop() {
    __tsan_acquire(const_cast<char*>(&kEnded));
}
#else
inline void before_loop() {}
inline void task_begins() {}
inline void task_ends() {}
inline void after_loop() {}
#endif

}  // namespace foverig::task_order
