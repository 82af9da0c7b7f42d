#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/options.h"

namespace foverig::bench {

using Json = nlohmann::ordered_json;

/// Rows of results by suite. One file a suite, whole or not at all, with what was measured where.
class Results {
  public:
    explicit Results(const Options& options) : options_(options) {}

    /// `row` gets its key "name" from here.
    void add(const std::string& suite, const std::string& name, Json row);

    /// Writes what was added; a suite that did not run keeps the file it had. Throws with the path.
    void write() const;

  private:
    const Options& options_;
    std::map<std::string, std::vector<Json>> rows_;
};

/// Build, machine, Embree and the settings that every comparison shares.
Json identity(const Options& options);

}  // namespace foverig::bench
