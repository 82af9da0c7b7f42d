#pragma once
#include <memory>
#include <string>

#include "renderer/renderer.h"

namespace foverig {

/// Why no GPU can render here, in a few words; empty: one can.
std::string why_no_gpu();

/// Throws BackendError where why_no_gpu() has a reason.
std::unique_ptr<Renderer> make_gpu_renderer(std::shared_ptr<const Scene> scene,
                                            const RenderSettings& settings);

}  // namespace foverig
