#include "rig/sweep/merged.h"

#include <fmt/format.h>

#include <algorithm>

#include "rig/failure.h"
#include "rig/sweep/journal.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> journals_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("runs") && name.ends_with(".jsonl")) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

void check_same(const Measured& measured, const nlohmann::json& header, const fs::path& file) {
    if (measured.definition != header.at("sweep"))
        throw InputError(fmt::format(
            "{}: belongs to another sweep than the files beside it; expected shards of one",
            file.string()));
    if (measured.build != header.at("build"))
        throw InputError(fmt::format(
            "{}: was measured by another build than the files beside it; expected one program",
            file.string()));
}

/// What another file has too, as where a sweep went on under another --shard, counts once.
void take(const JournalContent& content, Measured& measured) {
    for (const Accuracy& accuracy : content.accuracies)
        measured.accuracies.emplace(accuracy.point, accuracy);
    for (const Times& times : content.times) {
        auto& runs = measured.times[times.point];
        if (std::none_of(runs.begin(), runs.end(),
                         [&](const Times& run) { return run.repetition == times.repetition; }))
            runs.push_back(times);
    }
}

}  // namespace

std::vector<std::size_t> Measured::missing() const {
    const bool timed = !definition.at("fixed_cost").get<bool>();
    const auto repetitions = definition.at("repetitions").get<std::size_t>();
    std::vector<std::size_t> points_left;
    for (std::size_t point = 0; point < points(); ++point) {
        const auto found = times.find(point);
        const bool all_times =
            !timed || (found != times.end() && found->second.size() == repetitions);
        if (accuracies.count(point) == 0 || !all_times) points_left.push_back(point);
    }
    return points_left;
}

bool is_sweep(const fs::path& folder) {
    return !journals_in(folder).empty();
}

Measured read_measured(const fs::path& folder) {
    Measured measured;
    for (const fs::path& file : journals_in(folder)) {
        const JournalContent content = read_journal(file);
        if (content.header.is_null()) continue;  // begun a moment ago
        if (measured.definition.is_null()) {
            measured.definition = content.header.at("sweep");
            measured.build = content.header.at("build");
        }
        check_same(measured, content.header, file);
        measured.hosts.insert(content.header.at("host"));
        take(content, measured);
    }
    if (measured.definition.is_null())
        throw InputError(fmt::format(
            "{}: holds no sweep; expected what `foverig sweep --out` wrote", folder.string()));
    for (auto& [point, times] : measured.times)
        std::stable_sort(times.begin(), times.end(), [](const Times& a, const Times& b) {
            return a.repetition < b.repetition;
        });
    return measured;
}

}  // namespace foverig::sweep
