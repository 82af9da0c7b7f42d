#pragma once
// The program as its users meet it, in process, on small images, in a folder of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "rig/program.h"

namespace foverig::test {

namespace fs = std::filesystem;

struct Outcome {
    int code = 0;
    std::string out;
    std::string err;
};

inline Outcome foverig(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "foverig");
    std::vector<const char*> argv;
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_program(static_cast<int>(argv.size()), argv.data());
    std::fflush(stdout);
    Outcome outcome{code, testing::internal::GetCapturedStdout(),
                    testing::internal::GetCapturedStderr()};
    return outcome;
}

inline std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Without showing the bytes where they differ: images would flood the screen.
inline bool same_bytes(const fs::path& a, const fs::path& b) {
    return text_of(a) == text_of(b);
}

class ProgramBench : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) / ("program_test_" + std::to_string(getpid()));
        fs::remove_all(root_);
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    /// A run that takes a moment: a small Cornell box at a fixed cost.
    Outcome small_run(const fs::path& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"run",
                                           "--scene",
                                           "cornell",
                                           "--frames",
                                           "4",
                                           "--cost",
                                           "fixed:10",
                                           "--out",
                                           (root_ / out).string(),
                                           "--set",
                                           "display.eye_width_px=96",
                                           "--set",
                                           "display.eye_height_px=96",
                                           "--set",
                                           "settle_s=0.05",
                                           "--set",
                                           "scene_detail=0.2",
                                           "--set",
                                           "images.frames=[3]"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return foverig(arguments);
    }

    fs::path root_;
};

}  // namespace foverig::test
