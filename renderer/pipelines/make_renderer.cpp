#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "renderer/pipelines/cuda_or_none.h"
#include "renderer/pipelines/full.h"
#include "renderer/pipelines/reference.h"
#include "renderer/pipelines/reprojected.h"

namespace foverig {

std::vector<std::string> pipeline_names() {
    return {"full", "reference", "reprojected"};
}
std::vector<std::string> backend_names() {
    return {"auto", "embree", "host-bvh", "cuda"};
}

namespace {

void require_known(const char* key, const std::string& value,
                   const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), value) == known.end())
        throw std::invalid_argument(fmt::format("{} \"{}\" is not known; choose one of {}", key,
                                                value, fmt::join(known, ", ")));
}

}  // namespace

BackendChoice choose_backend(const RenderSettings& settings) {
    require_known("backend", settings.backend, backend_names());
    if (settings.backend != "auto") return {settings.backend, {}};
    if (settings.pipeline == "reference")
        return {"embree", "the reference renderer runs on the processor"};
    const std::string why = why_no_gpu();
    if (why.empty()) return {"cuda", "a GPU is there"};
    return {"embree", why};
}

std::unique_ptr<Renderer> make_renderer(std::shared_ptr<const Scene> scene,
                                        const RenderSettings& settings) {
    require_known("pipeline", settings.pipeline, pipeline_names());
    if (choose_backend(settings).name == "cuda")
        return make_gpu_renderer(std::move(scene), settings);
    if (settings.pipeline == "full")
        return std::make_unique<FullRenderer>(std::move(scene), settings);
    if (settings.pipeline == "reference")
        return std::make_unique<ReferenceRenderer>(std::move(scene), settings);
    return std::make_unique<ReprojectedRenderer>(std::move(scene), settings);
}

}  // namespace foverig
