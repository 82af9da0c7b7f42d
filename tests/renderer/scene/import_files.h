#pragma once
// A folder for one test's own scene files, removed with it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/error.h"
#include "renderer/scene/library.h"

namespace foverig::test {

class SceneFiles {
  public:
    SceneFiles() {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("foverig-") + info->test_suite_name() + "-" + info->name() + "-" +
                   std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    ~SceneFiles() { std::filesystem::remove_all(folder_); }
    SceneFiles(const SceneFiles&) = delete;
    SceneFiles& operator=(const SceneFiles&) = delete;

    std::filesystem::path write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }
    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path folder_;
};

/// The sentence with which the import of a file fails; empty where it does not.
inline std::string import_error(const std::filesystem::path& file,
                                const ImportSettings& settings = {}) {
    try {
        import_scene(file, settings);
    } catch (const SceneError& error) {
        return error.what();
    }
    return {};
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Sum over triangles.
inline double area_m2(const Scene& scene) {
    double area = 0.0;
    for (const uvec3& t : scene.triangles) {
        const dvec3 a(scene.positions_m[t.x]);
        area += 0.5 * glm::length(glm::cross(dvec3(scene.positions_m[t.y]) - a,
                                             dvec3(scene.positions_m[t.z]) - a));
    }
    return area;
}

inline dvec3 face_normal(const Scene& scene, std::size_t triangle) {
    const uvec3& t = scene.triangles[triangle];
    const dvec3 a(scene.positions_m[t.x]);
    return glm::normalize(
        glm::cross(dvec3(scene.positions_m[t.y]) - a, dvec3(scene.positions_m[t.z]) - a));
}

}  // namespace foverig::test
