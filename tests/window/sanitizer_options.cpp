// The graphics driver keeps 56 bytes here and there for each context, in modules that are unloaded
// when leaks are looked for, so that no name of theirs could be suppressed.
#if defined(__SANITIZE_ADDRESS__)
// NOLINTNEXTLINE(bugprone-reserved-identifier): the sanitizer asks for this name
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0";
}
#endif
