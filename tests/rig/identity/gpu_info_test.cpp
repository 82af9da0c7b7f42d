#include "rig/identity/gpu_info.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace foverig {
namespace {

TEST(GpuInfo, NamesArchitectureAndDriver) {
    GpuFindings found;
    found.driver = "580.159.03";
    found.cuda = "13.0";
    found.gpus = {{"NVIDIA H200", 9, 0}, {"NVIDIA T4", 7, 5}};
    const std::string text = gpu_text(found);
    for (const char* part : {"NVIDIA H200, sm_90", "NVIDIA T4, sm_75", "580.159.03", "CUDA 13.0"})
        EXPECT_NE(text.find(part), std::string::npos) << text;
}
TEST(GpuInfo, SaysPlainlyWhyThereIsNone) {
    GpuFindings found;
    found.why_none = "no NVIDIA driver is loaded";
    EXPECT_EQ(gpu_text(found), "none that CUDA can use: no NVIDIA driver is loaded");
}
TEST(GpuInfo, FindsNoneWithoutADriver) {
    if (std::filesystem::exists("/proc/driver/nvidia/version") ||
        std::filesystem::exists("/dev/nvidiactl"))
        GTEST_SKIP() << "there is a driver here";
    const GpuFindings found = find_gpus();
    EXPECT_TRUE(found.gpus.empty());
    EXPECT_FALSE(found.driver.has_value());
    EXPECT_FALSE(found.why_none.empty());
}

}  // namespace
}  // namespace foverig
