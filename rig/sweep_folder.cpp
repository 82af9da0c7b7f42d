#include "rig/sweep_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "rig/failure.h"
#include "rig/text/digest.h"

namespace foverig {
namespace fs = std::filesystem;

std::string program_digest() {
    std::ostringstream bytes;
    bytes << std::ifstream("/proc/self/exe", std::ios::binary).rdbuf();
    return Digest().add(bytes.view()).hex();
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw UsageError(fmt::format("--out {}: cannot be made: {}; expected a folder that may be",
                                     folder.string(), error.message()));
}

void begin_or_go_on(sweep::Journal& journal, const fs::path& file, const nlohmann::json& header) {
    const nlohmann::json& begun = journal.content().header;
    if (begun.is_null()) {
        journal.append(header);
        return;
    }
    for (const char* part : {"sweep", "build", "host"}) {
        if (begun.at(part) == header.at(part)) continue;
        const char* const what = *part == 's'   ? "of another sweep"
                                 : *part == 'b' ? "by another build of foverig"
                                                : "on another machine";
        throw UsageError(fmt::format(
            "{}: was begun {}; expected the same to go on, or another --out", file.string(), what));
    }
}

}  // namespace foverig
