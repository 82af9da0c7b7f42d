#pragma once
// Reference images on disk, so that they are rendered once however often a sweep is begun, and by
// whichever of its processes comes first.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "rig/sweep/flight.h"

namespace foverig::sweep {

class ReferenceImages {
  public:
    /// `folder`/`key` holds them; `key` is a digest of all that determines them.
    ReferenceImages(std::filesystem::path folder, std::string key)
        : folder_(std::move(folder)), key_(std::move(key)) {}

    bool exist() const;
    /// Renders them into a folder of its own first, so that they are there in whole or not at all.
    /// `frame_done` is told how many are.
    void render(Renderer& renderer, const std::vector<FlownFrame>& flight,
                const std::function<void(std::size_t)>& frame_done) const;
    /// As files keep them (half floats). Throws InputError where one cannot be read.
    Image image(const FrameInput& input, std::size_t eye) const;

  private:
    std::filesystem::path folder_;
    std::string key_;
};

}  // namespace foverig::sweep
