#include "rig/sweep/read.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <fstream>
#include <sstream>

#include "rig/failure.h"
#include "rig/scenario/parse.h"
#include "rig/scenario/toml_value.h"
#include "rig/sweep/design.h"
#include "rig/sweep/read_cases.h"
#include "rig/sweep/read_knobs.h"
#include "rig/sweep/read_paper.h"
#include "rig/sweep/records.h"
#include "rig/sweep/toml_reader.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostPoints = 10'000;
constexpr std::int64_t kMostRepetitions = 1000;

std::vector<Settings> read_design(const fs::path& file, const toml::table* table,
                                  const Sweep& sweep) {
    const toml::table none;
    const TomlReader reader(file, table != nullptr ? *table : none, {"kind", "points"});
    const auto most = static_cast<std::int64_t>(kMostPoints);
    if (reader.choice("kind", {"grid", "latin"}, "grid") == "latin") {
        const auto count = reader.integer("points", 1, most, 0);
        if (count == 0) refuse(file, *table, "a Latin hypercube needs points = N");
        return latin_hypercube(sweep.knobs, static_cast<std::size_t>(count), sweep.seed);
    }
    double count = 1.0;
    for (const Knob& knob : sweep.knobs) {
        if (knob.values.empty())
            throw UsageError(
                fmt::format("{}: {} is a range, which only design.kind = \"latin\" takes; "
                            "expected a list of values",
                            file.string(), knob.key->name));
        count *= static_cast<double>(knob.values.size());
    }
    if (count > static_cast<double>(kMostPoints))
        throw UsageError(fmt::format("{}: the grid has {:.0f} points; expected at most {}",
                                     file.string(), count, kMostPoints));
    return grid(sweep.knobs);
}

/// The base first, unless the design meets it anyway.
void add_points(Sweep& sweep, const std::vector<Settings>& design) {
    Settings current;
    for (const Knob& knob : sweep.knobs)
        current.emplace_back(knob.key->name, knob.key->get(sweep.base));
    const auto met = std::find(design.begin(), design.end(), current);
    if (met == design.end()) sweep.points.push_back({current, sweep.base});
    for (const Settings& settings : design)
        sweep.points.push_back({settings, with_settings(sweep.base, settings)});
    sweep.default_point = met == design.end() ? 0 : static_cast<std::size_t>(met - design.begin());
}

void check_base(const fs::path& file, const Sweep& sweep) {
    if (sweep.base.frames <= static_cast<std::int64_t>(sweep.warm_up_frames))
        throw UsageError(fmt::format(
            "{}: scenario.frames is {} and warm_up_frames {}; expected frames beyond the warm-up",
            file.string(), sweep.base.frames, sweep.warm_up_frames));
    if (sweep.base.devices == "hardware" || sweep.base.clock == "wall")
        throw UsageError(
            fmt::format("{}: a sweep shows every point the same frames; expected devices = sim or "
                        "replay:FILE and "
                        "clock = lockstep",
                        file.string()));
}

/// Flicker is seen through a filter of a quarter of a second.
void check_rates(const fs::path& file, const Sweep& sweep) {
    constexpr double kLowest_hz = 8.0;
    for (const Point& point : sweep.points)
        if (point.scenario.display.rate_hz < kLowest_hz)
            throw UsageError(fmt::format(
                "{}: display.rate_hz is {}; expected at least {}, as fewer frames a second show no "
                "flicker to measure",
                file.string(), point.scenario.display.rate_hz, kLowest_hz));
}

toml::table parsed(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || fs::is_directory(file) || (stream.peek() != EOF && !(text << stream.rdbuf())))
        throw UsageError(fmt::format("{}: cannot be read; expected a sweep (sweeps/ has examples)",
                                     file.string()));
    try {
        return toml::parse(text.str(), file.string());
    } catch (const toml::parse_error& error) {
        throw UsageError(fmt::format("{}:{}: not valid TOML: {}", file.string(),
                                     error.source().begin.line, error.description()));
    }
}

Scenario read_base(const fs::path& file, const toml::table& root, const TomlReader& reader) {
    Scenario base;
    if (const toml::node* node = root.get("base")) {
        if (!node->is_string())
            refuse(file, *node,
                   fmt::format("base is {}; expected a scenario file", described(*node)));
        base = read_scenario(file.parent_path() / node->as_string()->get());
    }
    if (const auto* table = reader.table("scenario")) apply_table(base, *table, file);
    complete_scenario(base);
    return base;
}

/// All of the flight, unless the file asks for stretches of it.
Stretches read_stretches(const fs::path& file, const TomlReader& reader, const Sweep& sweep) {
    const std::int64_t frames = sweep.base.frames;
    const auto warm_up = static_cast<std::int64_t>(sweep.warm_up_frames);
    const std::int64_t count = reader.integer("stretches", 1, frames, 1);
    const std::int64_t each = reader.integer("stretch_frames", 1, frames, 0);
    if (each == 0 && count == 1) return {};
    if (each <= warm_up || each * count > frames)
        throw UsageError(fmt::format(
            "{}: {} stretches of {} frames; expected stretch_frames beyond the warm-up of {} and "
            "all of them within scenario.frames, {}",
            file.string(), count, each, warm_up, frames));
    return {static_cast<std::size_t>(count), static_cast<std::size_t>(each)};
}

/// Knobs to draw the error over: lists of numbers.
std::vector<std::string> read_over(const fs::path& file, const toml::table& root,
                                   const TomlReader& reader, const Sweep& sweep) {
    std::vector<std::string> over = reader.texts("over");
    for (const std::string& name : over) {
        const auto found = std::find_if(sweep.knobs.begin(), sweep.knobs.end(),
                                        [&](const Knob& knob) { return knob.key->name == name; });
        const bool numbers =
            found != sweep.knobs.end() && !found->values.empty() &&
            (found->key->type == KeyType::number || found->key->type == KeyType::integer);
        if (!numbers)
            refuse(file, *root.get("over"),
                   fmt::format("over names {}; expected a knob with a list of numbers", name));
    }
    return over;
}

void read_points(const fs::path& file, const toml::table& root, const TomlReader& reader,
                 Sweep& sweep) {
    if (!root.contains("cases")) {
        if (root.contains("variants"))
            refuse(file, *root.get("variants"), "variants are of cases; expected [[cases]]");
        sweep.knobs = read_knobs(file, reader.table("knobs"));
        add_points(sweep, read_design(file, reader.table("design"), sweep));
        return;
    }
    for (const char* other : {"knobs", "design", "prices", "within"})
        if (const toml::node* node = root.get(other))
            refuse(file, *node,
                   fmt::format("cases have variants and no {}; expected one or the other", other));
    read_cases(file, reader, reader.table("reference"), sweep);
}

}  // namespace

Sweep read_sweep(const fs::path& file) {
    const toml::table root = parsed(file);
    const TomlReader reader(
        file, root,
        {"base", "scenario", "knobs", "design", "reference", "repetitions", "order", "seed",
         "warm_up_frames", "error", "within", "prices", "cases", "variants", "paper", "stretches",
         "stretch_frames", "errors_at", "over"});
    Sweep sweep;
    sweep.name = file.stem().string();
    sweep.base = read_base(file, root, reader);
    sweep.repetitions = static_cast<int>(reader.integer("repetitions", 1, kMostRepetitions, 3));
    sweep.order =
        reader.choice("order", {"abba", "random"}, "abba") == "abba" ? Order::abba : Order::random;
    sweep.seed = static_cast<std::uint64_t>(reader.integer("seed", 0, 1'000'000'000, 1));
    sweep.warm_up_frames =
        static_cast<std::size_t>(reader.integer("warm_up_frames", 0, 1'000'000, 3));
    sweep.error = reader.choice("error", error_names(), "acuity");
    sweep.errors_at_truth = reader.choice("errors_at", {"tracker", "truth"}, "tracker") == "truth";
    sweep.within = reader.numbers("within");
    sweep.prices = reader.flag("prices", false);
    sweep.reference = read_reference(file, reader.table("reference"), sweep.base);
    check_base(file, sweep);
    sweep.stretches = read_stretches(file, reader, sweep);
    read_points(file, root, reader, sweep);
    check_rates(file, sweep);
    sweep.over = read_over(file, root, reader, sweep);
    if (const auto* paper = reader.table("paper")) sweep.paper = read_paper(file, *paper, sweep);
    return sweep;
}

}  // namespace foverig::sweep
