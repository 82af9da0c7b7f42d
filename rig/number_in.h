#pragma once
#include <CLI/CLI.hpp>

namespace foverig {

/// What CLI::Range says, but of "nan" too, which lies in no range and which that lets pass.
CLI::Validator number_in(double low, double high);

}  // namespace foverig
