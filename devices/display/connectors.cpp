#include "devices/display/connectors.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace foverig {
namespace {

namespace fs = std::filesystem;

std::string word_in(const fs::path& file) {
    std::string word;
    std::ifstream(file) >> word;
    return word;
}

std::optional<Edid> edid_in(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    Result<Edid> edid = parse_edid(std::as_bytes(std::span(bytes)));
    return edid ? std::optional(std::move(edid).value()) : std::nullopt;
}

}  // namespace

std::vector<Connector> list_connectors(const fs::path& drm) {
    std::vector<Connector> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(drm, error)) {
        // card0-HDMI-A-1; card0 itself and renderD128 are no connectors.
        const std::string file = entry.path().filename().string();
        const auto dash = file.find('-');
        if (!file.starts_with("card") || dash == std::string::npos) continue;
        const std::string status = word_in(entry.path() / "status");
        if (status.empty()) continue;
        found.push_back({.name = file.substr(dash + 1),
                         .connected = status == "connected",
                         .enabled = word_in(entry.path() / "enabled") == "enabled",
                         .edid = edid_in(entry.path() / "edid")});
    }
    std::sort(found.begin(), found.end(),
              [](const Connector& a, const Connector& b) { return a.name < b.name; });
    return found;
}

}  // namespace foverig
