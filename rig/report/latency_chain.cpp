#include "rig/report/latency_chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "rig/records/distribution.h"
#include "rig/report/markup.h"
#include "rig/report/svg.h"

namespace foverig::report {
namespace {

constexpr double kWidth = 1000.0;
constexpr double kLeft = 70.0;
constexpr double kRight = 16.0;

struct Link {
    const char* name;
    const char* meaning;
    std::string from;
    std::string to;
};

/// `device` is the prefix of the columns of its sample: "sample" or "gaze".
std::array<Link, 6> links_of(const std::string& device) {
    return {{
        {"transport", "sample taken to its bytes on the host", device + "_ns",
         device + "_arrival_ns"},
        {"age", "bytes on the host to the frame's begin", device + "_arrival_ns", "begin_ns"},
        {"render", "begin to all eyes rendered", "begin_ns", "submit_ns"},
        {"distort", "rendered to handed to the display", "submit_ns", "present_ns"},
        {"wait", "handed over to the VSync that shows it", "present_ns", "vsync_ns"},
        {"scan-out", "VSync to light at the eyes' centres", "vsync_ns", "photon_ns"},
    }};
}

struct Chain {
    const char* name;
    std::vector<std::optional<Distribution>> links;
    std::optional<Distribution> whole;
};

/// Only frames that have every instant, so that the means add up.
Chain chain_of(const FrameTable& frames, const char* name, const std::string& device) {
    const auto links = links_of(device);
    std::array<std::vector<double>, 6> spans_ms;
    std::vector<double> whole_ms;
    std::array<std::vector<std::optional<double>>, 6> from;
    std::array<std::vector<std::optional<double>>, 6> to;
    for (std::size_t link = 0; link < links.size(); ++link) {
        from[link] = frames.column(links[link].from);
        to[link] = frames.column(links[link].to);
    }
    for (std::size_t i = 0; i < frames.frames; ++i) {
        const bool complete =
            std::all_of(from.begin(), from.end(),
                        [&](const auto& column) { return column[i].has_value(); }) &&
            to.back()[i].has_value();
        if (!complete) continue;
        for (std::size_t link = 0; link < links.size(); ++link) {
            spans_ms[link].push_back((*to[link][i] - *from[link][i]) * 1e-6);
        }
        whole_ms.push_back((*to.back()[i] - *from.front()[i]) * 1e-6);
    }
    Chain chain{name, {}, distribution_of(std::move(whole_ms))};
    for (auto& spans : spans_ms) chain.links.push_back(distribution_of(std::move(spans)));
    return chain;
}

void draw_chain(Svg& svg, const Chain& chain, const Scale& x, double top) {
    const auto links = links_of("");
    svg.text({kLeft - 10, top + 24}, chain.name, "axis-strong", "end");
    double at_ms = 0.0;
    for (std::size_t i = 0; i < chain.links.size(); ++i) {
        const double mean_ms = chain.links[i]->mean;
        const double width = x(at_ms + mean_ms) - x(at_ms);
        svg.rect({x(at_ms), top}, width, 38.0, series_class(i),
                 fmt::format("{}: {} ms ({})", links[i].name, number(mean_ms), links[i].meaning));
        if (width > 44.0) {
            svg.text({x(at_ms) + width / 2, top + 24}, number(mean_ms), "on-bar", "middle");
        }
        at_ms += mean_ms;
    }
}

std::string legend() {
    const auto links = links_of("");
    std::string html = "<p class=\"legend\">";
    for (std::size_t i = 0; i < links.size(); ++i) {
        html += fmt::format("<span><i class=\"{}\"></i>{}: {}</span>", series_class(i),
                            links[i].name, links[i].meaning);
    }
    return html + "</p>";
}

std::string chain_table(const std::vector<Chain>& chains) {
    const auto links = links_of("");
    const auto row = [](const std::string& what, const std::optional<Distribution>& d) {
        return std::vector<std::string>{what,           number(d->mean), number(d->p50),
                                        number(d->p90), number(d->p99),  number(d->max)};
    };
    std::vector<std::vector<std::string>> rows;
    for (const Chain& chain : chains) {
        rows.push_back(row(fmt::format("<b>{} to photon</b>", chain.name), chain.whole));
        for (std::size_t i = 0; i < links.size(); ++i) {
            rows.push_back(
                row(fmt::format("<i class=\"key {}\"></i>{}", series_class(i), links[i].name),
                    chain.links[i]));
        }
    }
    return table({"", "mean ms", "p50", "p90", "p99", "max"}, rows, {1, 2, 3, 4, 5});
}

}  // namespace

std::string latency_chain(const RunData& run) {
    std::vector<Chain> chains;
    for (auto& chain :
         {chain_of(run.frames, "motion", "sample"), chain_of(run.frames, "gaze", "gaze")}) {
        if (chain.whole) chains.push_back(chain);
    }
    if (chains.empty()) return "<p>No frame has every instant from a sample to its photon.</p>";
    double high_ms = 0.0;
    for (const Chain& chain : chains) high_ms = std::max(high_ms, chain.whole->mean);
    const double height = 34.0 + 52.0 * static_cast<double>(chains.size());
    Svg svg(kWidth, height, "Mean latency from motion and from gaze to photon, link by link");
    const Scale x{0.0, high_ms * 1.02, kLeft, kWidth - kRight};
    for (const double tick : ticks(high_ms * 1.02, 8)) {
        svg.line({x(tick), 6.0}, {x(tick), height - 28}, "grid");
        svg.text({x(tick), height - 10}, fmt::format("{:g} ms", tick), "axis", "middle");
    }
    for (std::size_t i = 0; i < chains.size(); ++i) {
        draw_chain(svg, chains[i], x, 8.0 + 52.0 * static_cast<double>(i));
    }
    return svg.str() + legend() + chain_table(chains);
}

}  // namespace foverig::report
