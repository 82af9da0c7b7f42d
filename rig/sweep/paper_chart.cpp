#include "rig/sweep/paper_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rig/sweep/error_chart.h"

namespace foverig::sweep {
namespace {

using nlohmann::json;
using report::Point;
using report::Scale;
using report::Svg;

constexpr double kWidth = 1000.0, kHeight = 560.0;
constexpr double kLeft = 60.0, kRight = 984.0;
constexpr double kTop = 34.0, kPanel = 200.0, kGap = 46.0;  // two panels, one above the other
constexpr double kBeside = 7.0;  // theirs stand so far left of the middle, ours right
constexpr double kMark = 4.5;
constexpr double kLine = 15.0;  // of text

/// A place on the horizontal axis; those of a case stand together, and those of a scene.
struct Place {
    const json* row;
    double x;
    bool first_of_case;
    bool first_of_scene;
};

/// "Sponza, area light, 8 samples": the scene, and the rest.
std::pair<std::string, std::string> parts_of(const json& row) {
    const auto name = row.at("case").get<std::string>();
    const auto comma = name.find(", ");
    if (comma == std::string::npos) return {name, ""};
    return {name.substr(0, comma), name.substr(comma + 2)};
}

std::vector<Place> places_of(const json& paper) {
    std::vector<const json*> shown;
    for (const json& row : paper.at("rows"))
        if (row.at("variant") != paper.at("baseline")) shown.push_back(&row);
    std::vector<Place> places;
    const double step =
        (kRight - kLeft) / static_cast<double>(std::max<std::size_t>(1, shown.size()));
    for (std::size_t i = 0; i < shown.size(); ++i)
        places.push_back({shown[i], kLeft + (static_cast<double>(i) + 0.5) * step,
                          i == 0 || shown[i]->at("case") != shown[i - 1]->at("case"),
                          i == 0 || parts_of(*shown[i]).first != parts_of(*shown[i - 1]).first});
    return places;
}

double high_of(const json& ratio) {
    double high = 1.0;
    for (const char* key : {"theirs", "ours"})
        if (ratio.at(key).is_number()) high = std::max(high, ratio.at(key).get<double>());
    if (ratio.contains("ci95") && ratio.at("ci95").is_array() && ratio.at("ours").is_number())
        high = std::max(high, std::min(ratio.at("ci95").at(1).get<double>(),
                                       1.5 * ratio.at("ours").get<double>()));
    return high;
}

/// Of a speed-up: what the reading of the two plots leaves open.
double reading_error(const json& row, const json& paper) {
    double relative = 0.0;
    for (const json& other : paper.at("rows")) {
        if (other.at("case") != row.at("case")) continue;
        if (other.at("variant") != row.at("variant") && other.at("variant") != paper.at("baseline"))
            continue;
        const json& theirs = other.at("theirs");
        if (theirs.is_object() && theirs.at("ms_error").is_number())
            relative += theirs.at("ms_error").get<double>() / theirs.at("ms").get<double>();
    }
    return relative;
}

void draw_marks(Svg& svg, const json& paper, const Place& place, const Scale& y, const char* of) {
    const json& ratio = place.row->at(of);
    const std::string name = fmt::format("{}, {}: {}", place.row->at("case").get<std::string>(),
                                         place.row->at("variant").get<std::string>(), of);
    if (ratio.at("theirs").is_number()) {
        const double theirs = ratio.at("theirs").get<double>();
        const double error = of == std::string("speed_up") ? reading_error(*place.row, paper) : 0.0;
        if (error > 0.0)
            draw_upright_interval(svg, place.x - kBeside, y, theirs * (1.0 - error),
                                  theirs * (1.0 + error), "theirs-line");
        svg.rect({place.x - kBeside - kMark, y(theirs) - kMark}, 2 * kMark, 2 * kMark, "theirs",
                 fmt::format("{} {:.3g} in the paper", name, theirs));
    }
    if (!ratio.at("ours").is_number()) return;
    const double ours = ratio.at("ours").get<double>();
    if (ratio.contains("ci95") && ratio.at("ci95").is_array())
        draw_upright_interval(svg, place.x + kBeside, y, ratio.at("ci95").at(0).get<double>(),
                              ratio.at("ci95").at(1).get<double>(), "ours-line");
    svg.circle({place.x + kBeside, y(ours)}, kMark + 0.5, "ours",
               fmt::format("{} {:.3g} here", name, ours));
}

/// Joins the variants of each case, theirs and ours.
void draw_lines(Svg& svg, const std::vector<Place>& places, const Scale& y, const char* of) {
    for (const auto& [key, style, beside] : {std::tuple{"theirs", "theirs-line", -kBeside},
                                             std::tuple{"ours", "ours-line", kBeside}}) {
        std::vector<Point> line;
        for (std::size_t i = 0; i <= places.size(); ++i) {
            const bool ends = i == places.size() || places[i].first_of_case;
            if (ends && line.size() > 1) svg.polyline(line, style);
            if (ends) line.clear();
            if (i == places.size()) break;
            const json& value = places[i].row->at(of).at(key);
            if (value.is_number()) line.push_back({places[i].x + beside, y(value.get<double>())});
        }
    }
}

void draw_panel(Svg& svg, const json& paper, const std::vector<Place>& places, double top,
                const char* of, const std::string& title) {
    double high = 1.0;
    for (const Place& place : places) high = std::max(high, high_of(place.row->at(of)));
    const Scale y{0.0, 1.08 * high, top + kPanel, top};
    for (const double tick : report::ticks(y.high, 6)) {
        svg.line({kLeft, y(tick)}, {kRight, y(tick)}, "grid");
        svg.text({kLeft - 8, y(tick) + 4}, fmt::format("{:g}", tick), "axis", "end");
    }
    svg.text({kLeft, top - 10}, title, "axis-strong");
    for (const Place& place : places)
        if (place.first_of_case && &place != &places.front()) {
            const double half_step = (places[1].x - places[0].x) / 2.0;
            svg.line({place.x - half_step, top}, {place.x - half_step, top + kPanel}, "grid");
        }
    draw_lines(svg, places, y, of);
    for (const Place& place : places) draw_marks(svg, paper, place, y, of);
}

/// Calls `draw` with the first and the last of neighbours of which the first alone `begins`.
template <class Draw>
void for_each_run(const std::vector<Place>& places, bool Place::*begins, Draw draw) {
    for (std::size_t i = 0; i < places.size();) {
        std::size_t end = i + 1;
        while (end < places.size() && !(places[end].*begins)) ++end;
        draw(places[i], places[end - 1]);
        i = end;
    }
}

/// From fine to coarse: the variants where a case has several, what the case is besides its scene,
/// and the scene once for all its cases.
void draw_names(Svg& svg, const std::vector<Place>& places) {
    const auto middle = [](const Place& a, const Place& b) { return (a.x + b.x) / 2.0; };
    const bool several =
        std::ranges::any_of(places, [](const Place& p) { return !p.first_of_case; });
    double line = kTop + 2 * kPanel + kGap + 18.0;
    if (several) {
        for (const Place& place : places)
            svg.text({place.x, line}, place.row->at("variant").get<std::string>(), "axis",
                     "middle");
        line += 1.3 * kLine;
    }
    double scene_line = line;
    for_each_run(places, &Place::first_of_case, [&](const Place& first, const Place& last) {
        std::string rest = parts_of(*first.row).second;
        for (double at = line; !rest.empty(); at += kLine) {
            const auto comma = several ? std::string::npos : rest.find(", ");
            svg.text({middle(first, last), at}, rest.substr(0, comma), "axis", "middle");
            rest = comma == std::string::npos ? "" : rest.substr(comma + 2);
            scene_line = std::max(scene_line, at + 1.3 * kLine);
        }
    });
    for_each_run(places, &Place::first_of_scene, [&](const Place& first, const Place& last) {
        svg.text({middle(first, last), scene_line}, parts_of(*first.row).first, "axis-strong",
                 "middle");
        if (&first == &places.front()) return;
        const double x = first.x - (places[1].x - places[0].x) / 2.0;
        svg.line({x, kTop + 2 * kPanel + kGap}, {x, scene_line}, "grid");
    });
}

}  // namespace

const char* const kPaperStyle = R"css(
.theirs { fill: var(--paper); stroke: var(--s1); stroke-width: 2; }
.theirs-line { fill: none; stroke: var(--s1); stroke-width: 1.5; stroke-dasharray: 5 3; }
.ours { fill: var(--s0); } .ours-line { fill: none; stroke: var(--s0); stroke-width: 1.5; }
i.theirs { background: none; border: 2px solid var(--s1); }
i.ours { background: var(--s0); border-radius: 50%; }
)css";

std::string paper_legend() {
    return "<div class=\"legend\"><span><i class=\"theirs\"></i>the paper</span><span><i "
           "class=\"ours\"></i>here, with the 95 % interval of the runs</span></div>";
}

std::string paper_chart(const json& paper) {
    const std::vector<Place> places = places_of(paper);
    const auto baseline = paper.at("baseline").get<std::string>();
    Svg svg(kWidth, kHeight, "speed-up and ray cut, the paper's beside ours");
    draw_panel(svg, paper, places, kTop, "speed_up",
               fmt::format("speed-up: time of {} / time", baseline));
    draw_panel(svg, paper, places, kTop + kPanel + kGap, "ray_cut",
               fmt::format("ray cut: rays of {} / rays", baseline));
    draw_names(svg, places);
    return svg.str();
}

}  // namespace foverig::sweep
