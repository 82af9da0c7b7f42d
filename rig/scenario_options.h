#pragma once
#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "rig/scenario/scenario.h"

namespace foverig {

/// The options of a subcommand that decide a scenario: a file, named options, `--set`. Later ones
/// win. One object for each subcommand; it outlives the parsing.
class ScenarioOptions {
  public:
    void add_to(CLI::App& command);
    /// The same without the file: the scenario comes from elsewhere.
    void add_settings_to(CLI::App& command);

    /// Throws UsageError with file and line, or the option.
    Scenario scenario() const;
    /// What the options make of `base`.
    Scenario over(Scenario base) const;

  private:
    std::string file_;
    std::map<std::string, std::string> named_;  ///< key of the scenario -> text
    std::vector<std::string> settings_;
};

}  // namespace foverig
