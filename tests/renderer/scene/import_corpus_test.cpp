// Issue 2, bar 8: every file of ../shared/scenes/hard and hard-more loads or ends with a sentence
// that names it, in under 10 s and 1 GiB each. Each in a process of its own, which the limits may
// end.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <map>

#include "renderer/check.h"
#include "tests/renderer/scene/import_files.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FOVERIG_SANITIZED 1
#else
#define FOVERIG_SANITIZED 0
#endif

namespace foverig {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(FOVERIG_SOURCE_DIR).parent_path() / "shared" / "scenes";

struct Outcome {
    int exit_code = -1;  ///< 0 loaded, 3 rejected, 5 broken invariant; -1: killed
    int signal = 0;
    std::string text;  ///< the sentence, or the number of triangles
};

[[noreturn]] void import_and_exit(const fs::path& file, int out) {
    // Address space cannot be limited under sanitizers, which map terabytes.
    const rlimit memory{1U << 30U, 1U << 30U};
    if (FOVERIG_SANITIZED == 0) setrlimit(RLIMIT_AS, &memory);
    alarm(FOVERIG_SANITIZED == 0 ? 10 : 120);
    int code = 0;
    std::string text;
    try {
        const Scene scene = import_scene(file);
        check_scene(scene);
        text = std::to_string(scene.triangles.size());
    } catch (const SceneError& error) {
        code = 3;
        text = error.what();
    } catch (const std::exception& error) {
        code = 5;
        text = error.what();
    }
    const bool written = write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    _exit(written ? code : 6);
}

Outcome outcome_of(const fs::path& file) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return {};
    const pid_t child = fork();
    if (child == 0) import_and_exit(file, ends[1]);
    close(ends[1]);
    Outcome outcome;
    std::array<char, 4096> block{};
    for (ssize_t n = 0; (n = read(ends[0], block.data(), block.size())) > 0;)
        outcome.text.append(block.data(), static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    return outcome;
}

std::map<std::string, Outcome> corpus() {
    std::map<std::string, Outcome> outcomes;
    for (const char* folder : {"hard", "hard-more"})
        for (const fs::directory_entry& entry :
             fs::recursive_directory_iterator(kScenes / folder)) {
            const std::string suffix = entry.path().extension();
            if (suffix == ".obj" || suffix == ".gltf" || suffix == ".glb" || suffix == ".ply")
                outcomes[fs::relative(entry.path(), kScenes).string()] = outcome_of(entry.path());
        }
    return outcomes;
}

/// What is merely nasty, with the triangle counts of the folders' README files less those without
/// area.
const std::map<std::string, std::pair<std::size_t, std::size_t>> kMustLoad{
    {"hard/good.glb", {1, 1}},
    {"hard/deep-nodes.gltf", {1, 1}},
    {"hard/missing-mtl.obj", {2, 2}},
    {"hard/mtl-escape.obj", {2, 2}},
    {"hard/mtl-loop.obj", {2, 2}},
    {"hard/duplicate-triangles.obj", {1001, 1002}},
    {"hard/zero-area.obj", {1, 1}},
    {"hard/huge-polygon.obj", {19'900, 19'998}},
    {"hard/long-line.obj", {1, 2'000'000}},
    {"hard/assimp-glTF2_BoxBadNormals-glTF-Binary_BoxBadNormals.glb", {12, 12}},
    {"hard/assimp-glTF2_issue_3269_texcoord_crash.gltf", {10, 10}},
    {"hard-more/Cray_left.obj", {576, 576}},
    {"hard-more/Generic_Twin_7081.1.t0_left.obj", {19'704, 19'704}},
    {"hard-more/Generic_Twin_7081.1.t0_right.obj", {11'656, 11'656}},
    {"hard-more/Generic_Twin_7863.1.t0_left.obj", {212, 212}},
    {"hard-more/Havocglass8_left.obj", {164, 164}},
    {"hard-more/Havocglass8_right.obj", {12, 12}},
    {"hard-more/Offset1.obj", {4418 - 17, 4418}},
    {"hard-more/openscad-nonmanifold-crash.obj", {1441, 1441}},
    {"hard-more/self_intersectA.obj", {17'160, 17'160}},
    {"hard-more/thingi10k_112932.obj", {7878, 7880}},
    {"hard-more/thingi10k_472042.obj", {3632, 3632}},
    {"hard-more/thingi10k_88566.obj", {5344, 5344}},
    {"hard-more/thingi10k_72214.obj", {1660, 1660}},
    {"hard-more/thingi10k_908460.obj", {36'074, 36'074}},
    {"hard-more/obj/issue-161-inconsistent-f.obj", {12, 12}},
    {"hard-more/obj/issue-295-trianguation-failure.obj", {28, 28}},
    {"hard-more/obj/issue-319-002.obj", {12, 14}},
    {"hard-more/obj/issue-330.obj", {3, 3}},
    {"hard-more/obj/leading-decimal-dot-issue-201.obj", {1, 1}},
    {"hard-more/obj/leading-zero-in-exponent-notation-issue-210.obj", {1, 1}},
    {"hard-more/obj/missing_material_file.obj", {36, 36}},
    {"hard-more/obj/mtllib-multiple-files-issue-112.obj", {1, 1}},
    {"hard-more/obj/test-nan.obj", {34, 34}}};

/// Nothing in these can be drawn as they mean it, and part of each of their sentences.
const std::map<std::string, std::string> kMustFail{
    {"hard/bad-base64.gltf", "decode"},
    {"hard/binary-garbage.obj", "not OBJ text"},
    {"hard/buffer-escape.gltf", "own folder"},
    {"hard/buffer-url.gltf", "own folder"},
    {"hard/empty.obj", "no face"},
    {"hard/huge-count.gltf", "wants 4000000000 elements"},
    {"hard/index-out-of-range.gltf", "vertex 60000 of 3"},
    {"hard/index-out-of-range.obj", "face 3 names position 99"},
    {"hard/json-cut.gltf", "not valid JSON"},
    {"hard/length-lie.gltf", "Failed to decode"},
    {"hard/missing-bin.gltf", "gone.bin"},
    {"hard/no-faces.obj", "no face"},
    {"hard/node-bomb.gltf", "tree"},
    {"hard/node-cycle.gltf", "descendant"},
    {"hard/only-zero-area.obj", "no triangle to show"},
    {"hard/ply-negative-index.ply", "vertex -5 of 3"},
    {"hard/ply-no-end.ply", "never ends"},
    {"hard/png-bomb.gltf", "65000 x 65000"},
    {"hard/torn.glb", "cut short"},
    {"hard/version-3.glb", "version 3"},
    {"hard-more/Cray_right.obj", "metres_per_unit"}};

TEST(ImportCorpus, EveryHardFileLoadsOrIsRejectedByASentenceThatNamesIt) {
    if (!fs::exists(kScenes / "hard"))
        GTEST_SKIP() << "the hard scenes are not beside the checkout";
    const std::map<std::string, Outcome> outcomes = corpus();
    EXPECT_EQ(outcomes.size(), 170U);
    for (const auto& [name, outcome] : outcomes) {
        SCOPED_TRACE(name);
        EXPECT_EQ(outcome.signal, 0) << "killed: a crash, 10 s or 1 GiB";
        EXPECT_THAT(outcome.exit_code, testing::AnyOf(0, 3)) << outcome.text;
        if (outcome.exit_code != 3) continue;
        EXPECT_TRUE(outcome.text.starts_with((kScenes / name).string() + ": ")) << outcome.text;
        EXPECT_EQ(outcome.text.find('\n'), std::string::npos) << outcome.text;
    }
    for (const auto& [name, range] : kMustLoad) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(outcomes.contains(name));
        const Outcome& outcome = outcomes.at(name);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
        EXPECT_GE(std::stoul(outcome.text), range.first);
        EXPECT_LE(std::stoul(outcome.text), range.second);
    }
    for (const auto& [name, part] : kMustFail) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(outcomes.contains(name));
        EXPECT_EQ(outcomes.at(name).exit_code, 3);
        EXPECT_NE(outcomes.at(name).text.find(part), std::string::npos) << outcomes.at(name).text;
    }
}

}  // namespace
}  // namespace foverig
