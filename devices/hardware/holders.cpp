#include "devices/hardware/holders.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <optional>

#include "devices/hardware/first_line.h"

namespace foverig::hardware {
namespace {

namespace fs = std::filesystem;

std::optional<int> number_of(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

bool has_open(const fs::path& process, const struct stat& node) {
    std::error_code error;
    for (const auto& file : fs::directory_iterator(process / "fd", error)) {
        struct stat opened {};
        if (::stat(file.path().c_str(), &opened) == 0 && opened.st_dev == node.st_dev &&
            opened.st_ino == node.st_ino) {
            return true;
        }
    }
    return false;
}

std::string name_of(const fs::path& process) {
    const std::string name = first_line_of(process / "comm");
    return name.empty() ? "a program" : name;
}

}  // namespace

std::vector<Holder> holders_of(const std::string& path, const std::string& proc) {
    std::vector<Holder> holders;
    struct stat node {};
    if (::stat(path.c_str(), &node) != 0) return holders;
    std::error_code error;
    for (const auto& process : fs::directory_iterator(proc, error)) {
        const auto pid = number_of(process.path().filename().string());
        if (!pid || *pid == ::getpid()) continue;
        if (has_open(process.path(), node)) holders.push_back({*pid, name_of(process.path())});
    }
    return holders;
}

Error busy(const std::string& path, const std::vector<Holder>& holders) {
    if (holders.empty()) {
        return {ErrorCode::busy,
                fmt::format("{} is held by another program, which this user may not see (sudo "
                            "fuser {}); end that one first",
                            path, path)};
    }
    std::vector<std::string> names;
    for (const Holder& holder : holders) {
        names.push_back(fmt::format("{} (pid {})", holder.name, holder.pid));
    }
    return {ErrorCode::busy, fmt::format("{} is held by {}; end that program first", path,
                                         fmt::join(names, " and "))};
}

}  // namespace foverig::hardware
