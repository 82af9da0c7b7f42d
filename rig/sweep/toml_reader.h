#pragma once
// Tables of a sweep's TOML file, each complaint with file and line.
#include <toml++/toml.h>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foverig::sweep {

/// Throws UsageError: "sweep.toml:3: what".
[[noreturn]] void refuse(const std::filesystem::path& file, const toml::node& node,
                         const std::string& what);

/// Borrows both. Throws UsageError where the table holds another key than the `known` ones, and
/// below where a value is not what is expected.
class TomlReader {
  public:
    TomlReader(const std::filesystem::path& file, const toml::table& table,
               const std::vector<std::string>& known);

    std::int64_t integer(const char* name, std::int64_t least, std::int64_t most,
                         std::int64_t otherwise) const;
    std::string choice(const char* name, const std::vector<std::string>& choices,
                       const std::string& otherwise) const;
    bool flag(const char* name, bool otherwise) const;
    std::string text(const char* name, const std::string& otherwise) const;
    std::vector<std::string> texts(const char* name) const;
    /// Of at least 0; no value where it is not there.
    std::optional<double> number(const char* name) const;
    /// Empty where it is not there.
    std::vector<double> numbers(const char* name) const;
    /// Nullptr where it is not there.
    const toml::table* table(const char* name) const;
    /// Of an array of tables; empty where it is not there.
    std::vector<const toml::table*> tables(const char* name) const;

  private:
    const std::filesystem::path& file_;
    const toml::table& table_;
};

}  // namespace foverig::sweep
