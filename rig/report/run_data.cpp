#include "rig/report/run_data.h"

#include <fmt/format.h>

#include <fstream>

#include "rig/failure.h"

namespace foverig::report {
namespace {

const nlohmann::json* find(const nlohmann::json& root, std::initializer_list<const char*> path) {
    const nlohmann::json* at = &root;
    for (const char* name : path) {
        if (!at->is_object()) return nullptr;
        const auto next = at->find(name);
        if (next == at->end()) return nullptr;
        at = &*next;
    }
    return at;
}

}  // namespace

std::optional<double> RunData::number(std::initializer_list<const char*> path) const {
    const auto* found = find(summary, path);
    return found != nullptr && found->is_number() ? std::optional(found->get<double>())
                                                  : std::nullopt;
}

std::string RunData::text(std::initializer_list<const char*> path) const {
    const auto* found = find(summary, path);
    return found != nullptr && found->is_string() ? found->get<std::string>() : "–";
}

RunData read_run(const std::filesystem::path& folder) {
    const auto file = folder / "summary.json";
    std::ifstream stream(file);
    if (!stream) {
        throw InputError(
            fmt::format("{}: cannot be read; expected a run folder, as `foverig run` "
                        "writes it",
                        file.string()));
    }
    RunData run{folder, nlohmann::json::parse(stream, nullptr, false), {}};
    if (run.summary.is_discarded() || run.text({"schema"}).rfind("foverig.summary/1", 0) != 0) {
        throw InputError(
            fmt::format("{}: not a summary of schema foverig.summary/1", file.string()));
    }
    run.frames = read_frames_csv(folder / "frames.csv");
    return run;
}

}  // namespace foverig::report
