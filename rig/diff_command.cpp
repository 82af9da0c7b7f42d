#include <fmt/format.h>

#include <algorithm>

#include "metrics/finite.h"
#include "metrics/heatmap.h"
#include "rig/commands.h"

namespace foverig {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
using Pair = std::pair<fs::path, fs::path>;

std::vector<fs::path> images_in(const fs::path& folder) {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

/// Two files, or the files of one name in two folders: a sequence in the order of their names.
std::vector<Pair> pairs_of(const fs::path& a, const fs::path& b) {
    if (fs::is_directory(a) != fs::is_directory(b))
        throw InputError(
            fmt::format("{} and {}: one is a folder, the other is not; expected two of a kind",
                        a.string(), b.string()));
    if (!fs::is_directory(a)) return {{a, b}};
    const auto names = images_in(a);
    if (names.empty()) throw InputError(fmt::format("{}: holds no images", a.string()));
    if (images_in(b) != names)
        throw InputError(fmt::format(
            "{} and {}: hold files of different names; expected one frame of each for each name",
            a.string(), b.string()));
    std::vector<Pair> pairs;
    for (const fs::path& name : names) pairs.emplace_back(a / name, b / name);
    return pairs;
}

ReadImage read_finite(const fs::path& file, std::uint64_t& not_finite) {
    try {
        ReadImage read = read_image(file);
        const std::uint64_t count = metrics::count_not_finite(read.image);
        if (count > 0) {
            fmt::print(stderr,
                       "{}: {} values are NaN or infinite; compared as 0, +infinity as 65504\n",
                       file.string(), count);
            read.image = metrics::with_finite_values(std::move(read.image));
        }
        not_finite += count;
        return read;
    } catch (const ImageFileError& error) {
        throw InputError(error.what());
    }
}

void check_sizes(const Pair& files, const Image& a, const Image& b) {
    if (a.width_px == b.width_px && a.height_px == b.height_px) return;
    throw InputError(fmt::format("{} is {} x {} pixels and {} is {} x {}; expected one size",
                                 files.first.string(), a.width_px, a.height_px,
                                 files.second.string(), b.width_px, b.height_px));
}

std::string text_of(const Json& metric) {
    std::string text;
    for (const auto& [key, value] : metric.items()) {
        if (value.is_object())
            text += fmt::format("{} ({})  ", key, text_of(value));
        else if (value.is_number())
            text += fmt::format("{} {:.6g}  ", key, value.get<double>());
        else
            text += fmt::format("{} {}  ", key, value.get<std::string>());
    }
    while (text.ends_with(' ')) text.pop_back();
    return text;
}

void write_heatmap(const fs::path& file, const metrics::Plane& map) {
    try {
        write_png(file, metrics::heatmap(map));
    } catch (const std::runtime_error& error) {
        throw UsageError(fmt::format("--out {}", error.what()));
    }
}

}  // namespace

ExitCode diff_command(const DiffRequest& request) {
    const auto pairs = pairs_of(request.reference, request.test);
    if (request.heatmap && pairs.size() > 1)
        throw UsageError("--out draws one pair of images; name two files instead of folders");
    const auto& chosen = request.settings.metrics;
    if (request.heatmap && !chosen.empty() &&
        std::find(chosen.begin(), chosen.end(), "flip") == chosen.end())
        throw UsageError("--out draws the map of FLIP; add flip to --metrics");
    for (const std::string& metric : chosen)
        if (pairs.size() == 1 && (metric == "change" || metric == "flicker"))
            throw UsageError(fmt::format(
                "--metrics {}: is of sequences; name two folders of frames instead of two images",
                metric));
    DiffMetrics diff(request.settings, pairs.size() > 1);
    std::uint64_t not_finite_a = 0;
    std::uint64_t not_finite_b = 0;
    int width_px = 0;
    for (const Pair& files : pairs) {
        const ReadImage a = read_finite(files.first, not_finite_a);
        const ReadImage b = read_finite(files.second, not_finite_b);
        check_sizes(files, a.image, b.image);
        if (std::exchange(width_px, a.image.width_px) != 0 && width_px != a.image.width_px)
            throw InputError(
                fmt::format("{}: frames of a sequence differ in size", files.first.string()));
        diff.add(a, b);
    }
    const Json result = diff.result();
    if (request.heatmap) write_heatmap(*request.heatmap, diff.flip_map());
    if (!request.json) {
        for (const auto& [name, metric] : result.items())
            fmt::print("{:<8} {}\n", name, text_of(metric));
        return ExitCode::good;
    }
    Json json = result;
    json["frames"] = pairs.size();
    json["pixels_per_degree"] = request.settings.pixels_per_degree;
    json["not_finite"] = {{"reference", not_finite_a}, {"test", not_finite_b}};
    fmt::print("{}\n", json.dump());
    return ExitCode::good;
}

}  // namespace foverig
