#pragma once
// The shared reference numbers of other people's metrics, and the images they are of.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/image_read.h"

namespace foverig::test {

inline const std::filesystem::path kMetricsFolder =
    std::filesystem::path(FOVERIG_SOURCE_DIR).parent_path() / "shared" / "metrics";

class Expected : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(kMetricsFolder / "expected.json"))
            GTEST_SKIP() << "no shared folder with expected.json beside the checkout";
        json = nlohmann::json::parse(std::ifstream(kMetricsFolder / "expected.json"));
        tolerances = json.at("suggested_absolute_tolerances");
    }

    const Image& image(const nlohmann::json& name) {
        const auto file = name.get<std::string>();
        if (!images_.contains(file)) images_[file] = read_image(kMetricsFolder / file).image;
        return images_.at(file);
    }

    double tolerance(const char* name) const { return tolerances.at(name).get<double>(); }

    nlohmann::json json, tolerances;

  private:
    std::map<std::string, Image> images_;
};

/// The frames of a strip, stacked from top to bottom.
inline std::vector<Image> frames_of(const Image& strip, int height_px) {
    std::vector<Image> frames;
    const auto size = static_cast<std::ptrdiff_t>(strip.width_px) * height_px;
    for (auto at = strip.pixels.begin(); at != strip.pixels.end(); at += size)
        frames.push_back({strip.width_px, height_px, {at, at + size}});
    return frames;
}

}  // namespace foverig::test
