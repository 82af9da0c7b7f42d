#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "rig/commands.h"

namespace foverig {

/// The options of `foverig sweep`.
class SweepOptions {
  public:
    void add_to(CLI::App& app);
    SweepRequest request() const;

  private:
    std::string file_, out_, shard_ = "0/1";
    bool json_ = false;
};

}  // namespace foverig
