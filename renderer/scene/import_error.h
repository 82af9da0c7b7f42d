#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "renderer/scene/error.h"

namespace foverig::scene_import {

/// Throws SceneError("FILE: sentence"). Every complaint about an input file goes through here.
template <class... Args>
[[noreturn]] void fail(const std::filesystem::path& file, fmt::format_string<Args...> sentence,
                       Args&&... args) {
    throw SceneError(file.string() + ": " + fmt::format(sentence, std::forward<Args>(args)...));
}

}  // namespace foverig::scene_import
