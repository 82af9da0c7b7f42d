#include "rig/identity/build_info.h"

#include "foverig_git_commit.h"

namespace foverig {

BuildInfo build_info() {
    const std::string commit = FOVERIG_GIT_COMMIT;
    return {.version = FOVERIG_VERSION,
            .git = commit.empty() ? std::nullopt : std::optional(commit),
            .compiler = FOVERIG_COMPILER,
            .flags = FOVERIG_FLAGS,
            .build_type = FOVERIG_BUILD_TYPE,
            .fp_mode = "fast"};
}

}  // namespace foverig
