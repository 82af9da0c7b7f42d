#include "rig/exports/benchmark_json.h"

#include "rig/stats/centre.h"

namespace foverig::exports {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kUsOfMs = 1000.0;  // compare.py shows whole numbers: passes take less than 1 ms

struct Value {
    std::string name;
    double ms = 0.0;
    double cpu_ms = 0.0;  ///< as long, where only the whole frame's processor time is known
};

std::size_t warm_up_frames(const report::RunData& run) {
    const auto frames = run.number({"steady_frame_time_ms", "warm_up_frames"});
    return static_cast<std::size_t>(frames.value_or(0.0));
}

std::vector<double> steady(const report::RunData& run, const std::string& id) {
    const auto cells = run.frames.column(id);
    std::vector<double> values;
    for (std::size_t i = warm_up_frames(run); i < cells.size(); ++i)
        if (cells[i]) values.push_back(*cells[i]);
    return values;
}

std::vector<Value> values_of(const report::RunData& run) {
    std::vector<Value> values;
    const auto add = [&](const std::string& name, const std::string& id) {
        const auto column = steady(run, id);
        if (column.empty()) return;
        const double ms = stats::median_of(column);
        values.push_back({name, ms, ms});
    };
    const std::string scene = run.text({"scenario", "scene"}) + "/" + run.text({"pipeline"}) + "/";
    add(scene + "frame_time", "frame_time_ms");
    if (const auto cpu = steady(run, "cpu_ms"); !cpu.empty() && !values.empty())
        values.back().cpu_ms = stats::median_of(cpu);
    add(scene + "motion_to_photon", "motion_to_photon_ms");
    add(scene + "gaze_to_photon", "gaze_to_photon_ms");
    for (const std::string& id : run.frames.order)
        if (id.starts_with("pass."))
            add(scene + "pass/" + id.substr(5, id.size() - 8), id);  // without "_ms"
    return values;
}

Json context_of(const report::RunData& run) {
    const Json host = run.summary.value("host", nlohmann::json::object());
    return {{"executable", "foverig"},
            {"num_cpus", host.value("cores", 0)},
            {"mhz_per_cpu", 0},
            {"caches", Json::array()},
            {"library_build_type", run.text({"build", "type"}) == "Debug" ? "debug" : "release"},
            {"foverig_version", run.text({"build", "version"})},
            {"foverig_git", run.text({"build", "git"})},
            {"cpu", run.text({"host", "cpu"})}};
}

}  // namespace

Json benchmark_json(const std::vector<report::RunData>& runs) {
    Json benchmarks = Json::array();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        for (const Value& value : values_of(runs[i]))
            benchmarks.push_back({{"name", value.name},
                                  {"run_name", value.name},
                                  {"run_type", "iteration"},
                                  {"repetitions", runs.size()},
                                  {"repetition_index", i},
                                  {"threads", 1},
                                  {"iterations", runs[i].frames.frames},
                                  {"real_time", kUsOfMs * value.ms},
                                  {"cpu_time", kUsOfMs * value.cpu_ms},
                                  {"time_unit", "us"}});
    }
    return {{"context", runs.empty() ? Json::object() : context_of(runs.front())},
            {"benchmarks", std::move(benchmarks)}};
}

}  // namespace foverig::exports
