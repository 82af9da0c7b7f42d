#include "rig/report/markup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foverig::report {
namespace {

constexpr const char* kAbsent = "–";

std::string with_prefix(double value, const char* unit) {
    const char* prefix = "";
    for (const char* next : {"k", "M", "G", "T"}) {
        if (std::abs(value) < 999.5) break;
        value /= 1000.0;
        prefix = next;
    }
    const std::string digits =
        *prefix == '\0' && value == std::round(value) ? fmt::format("{}", value) : number(value);
    return *prefix == '\0' && *unit == '\0' ? digits
                                            : fmt::format("{}\u202f{}{}", digits, prefix, unit);
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string number(const std::optional<double>& value) {
    if (!value) return kAbsent;
    const double size = std::abs(*value);
    if (size == 0.0) return "0";
    if (size >= 99.95) return fmt::format("{:.0f}", *value);
    if (size >= 9.995) return fmt::format("{:.1f}", *value);
    if (size >= 0.9995) return fmt::format("{:.2f}", *value);
    return fmt::format("{:.3g}", *value);
}

std::string percent(const std::optional<double>& share) {
    if (!share) return kAbsent;
    return fmt::format("{}\u202f%", number(100.0 * *share));
}

std::string bytes(const std::optional<double>& n) {
    return n ? with_prefix(*n, "B") : kAbsent;
}

std::string count(const std::optional<double>& n) {
    return n ? with_prefix(*n, "") : kAbsent;
}

std::string table(const std::vector<std::string>& head,
                  const std::vector<std::vector<std::string>>& rows,
                  const std::vector<std::size_t>& numeric) {
    const auto attribute = [&](std::size_t column) {
        const bool right = std::find(numeric.begin(), numeric.end(), column) != numeric.end();
        return right ? " class=\"n\"" : "";
    };
    std::string html = "<div class=\"scroll\"><table><thead><tr>";
    for (std::size_t i = 0; i < head.size(); ++i) {
        html += fmt::format("<th{}>{}</th>", attribute(i), head[i]);
    }
    html += "</tr></thead><tbody>";
    for (const auto& row : rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            html += fmt::format("<td{}>{}</td>", attribute(i), row[i]);
        }
        html += "</tr>";
    }
    return html + "</tbody></table></div>";
}

std::string page_head(std::string_view title, std::string_view style) {
    constexpr const char* kNothingFetched =
        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
    return fmt::format(
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
        "http-equiv=\"Content-Security-Policy\" content=\"{}\"><meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\"><title>{}</title>"
        "<style>{}</style></head><body><main>\n",
        kNothingFetched, escaped(title), style);
}

std::string section(std::string_view title, std::string_view note, std::string_view body) {
    const std::string lead = note.empty() ? "" : fmt::format("<p class=\"note\">{}</p>", note);
    return fmt::format("<section><h2>{}</h2>{}{}</section>\n", title, lead, body);
}

}  // namespace foverig::report
