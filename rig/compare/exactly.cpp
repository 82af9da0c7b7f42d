#include "rig/compare/exactly.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <sstream>

#include "rig/failure.h"
#include "rig/text/digest.h"

namespace foverig::compare {
namespace fs = std::filesystem;
namespace {

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    if (!stream || !(bytes << stream.rdbuf()))
        throw InputError(fmt::format("{}: cannot be read", file.string()));
    return bytes.str();
}

/// Of each file by its name within the run folder.
std::map<std::string, std::string> digests_of(const fs::path& run) {
    std::map<std::string, std::string> digests;
    digests["frames.csv"] = Digest().add(bytes_of(run / "frames.csv")).hex();
    if (!fs::is_directory(run / "images")) return digests;
    for (const auto& entry : fs::directory_iterator(run / "images"))
        digests["images/" + entry.path().filename().string()] =
            Digest().add(bytes_of(entry.path())).hex();
    return digests;
}

std::string text_of(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "NA";
}

std::string first_cell(const FrameTable& a, const FrameTable& b) {
    if (a.order != b.order) return "frames.csv: the columns differ";
    for (std::size_t frame = 0; frame < std::min(a.frames, b.frames); ++frame)
        for (const std::string& id : a.order) {
            const auto& x = a.columns.at(id)[frame];
            const auto& y = b.columns.at(id)[frame];
            if (x != y)
                return fmt::format("frames.csv: {} of frame {} is {} and {}", id, frame, text_of(x),
                                   text_of(y));
        }
    return fmt::format("frames.csv: {} and {} frames", a.frames, b.frames);
}

}  // namespace

std::string digest_of(const report::RunData& run) {
    Digest digest;
    for (const auto& [name, of_file] : digests_of(run.folder)) digest.add(name).add(of_file);
    return digest.hex();
}

std::optional<std::string> first_difference(const report::RunData& a, const report::RunData& b) {
    const auto of_a = digests_of(a.folder);
    const auto of_b = digests_of(b.folder);
    if (of_a == of_b) return std::nullopt;
    if (of_a.at("frames.csv") != of_b.at("frames.csv")) return first_cell(a.frames, b.frames);
    for (const auto& [name, digest] : of_a) {
        const auto other = of_b.find(name);
        if (other == of_b.end()) return name + ": only one of them has it";
        if (other->second != digest) return name + ": the pixels differ";
    }
    for (const auto& [name, digest] : of_b)
        if (of_a.count(name) == 0) return name + ": only one of them has it";
    return std::nullopt;
}

}  // namespace foverig::compare
