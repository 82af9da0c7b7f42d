#pragma once

namespace foverig {

/// The whole program; what it throws becomes one sentence on stderr and an exit code (ExitCode).
int run_program(int argc, const char* const* argv);

}  // namespace foverig
