#pragma once
// Small pieces of HTML and numbers as people read them.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foverig::report {

/// For text between tags and in quoted attributes.
std::string escaped(std::string_view text);

/// Three significant digits: "0.123", "13.3", "131"; "–" for no value.
std::string number(const std::optional<double>& value);

/// 0.2345 -> "23.4 %".
std::string percent(const std::optional<double>& share);

/// "12.3 MB".
std::string bytes(const std::optional<double>& count);

/// 1234567 -> "1.23 M".
std::string count(const std::optional<double>& n);

/// Cells are HTML already. `numeric` columns (from 0) are set right-aligned.
std::string table(const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows,
                  const std::vector<std::size_t>& numeric = {});

/// All before the body's content: the browser itself refuses whatever does not lie in the page.
std::string page_head(std::string_view title, std::string_view style);

/// <section> with a heading, a sentence on how to read it, and a body.
std::string section(std::string_view title, std::string_view note, std::string_view body);

}  // namespace foverig::report
