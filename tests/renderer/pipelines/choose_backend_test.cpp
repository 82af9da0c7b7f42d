#include <gtest/gtest.h>

#include "renderer/backend_error.h"
#include "renderer/pipelines/cuda_or_none.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

TEST(ChooseBackend, AutoIsTheGpuWhereThereIsOneAndSaysWhyNot) {
    const BackendChoice choice = choose_backend({});
    const std::string why_not = why_no_gpu();
    EXPECT_EQ(choice.name, why_not.empty() ? "cuda" : "embree");
    EXPECT_NE(choice.why, "");
    if (!why_not.empty()) {
        EXPECT_EQ(choice.why, why_not);
    }
}

TEST(ChooseBackend, TheReferenceRunsOnTheProcessor) {
    EXPECT_EQ(choose_backend(settings_of("reference")).name, "embree");
}

TEST(ChooseBackend, WhatIsAskedForIsTaken) {
    for (const char* name : {"embree", "host-bvh", "cuda"}) {
        RenderSettings settings;
        settings.backend = name;
        EXPECT_EQ(choose_backend(settings).name, name);
        EXPECT_EQ(choose_backend(settings).why, "");
    }
}

TEST(ChooseBackend, CudaWithoutAGpuIsAnErrorThatSaysWhy) {
    if (why_no_gpu().empty()) GTEST_SKIP() << "there is a GPU";
    RenderSettings settings;
    settings.backend = "cuda";
    const auto scene = std::make_shared<const Scene>(card_before_wall());
    try {
        make_renderer(scene, settings);
        ADD_FAILURE() << "a renderer without a GPU";
    } catch (const BackendError& error) {
        EXPECT_EQ(error.what(), why_no_gpu());
    }
}

}  // namespace
}  // namespace foverig
