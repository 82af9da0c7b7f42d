#include "rig/sweep/reference_images.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "renderer/image_read.h"
#include "rig/failure.h"

namespace foverig::sweep {
namespace fs = std::filesystem;
namespace {

std::string file_name(const FrameInput& input, std::size_t eye) {
    return fmt::format("frame_{:06}_{}.exr", input.frame, eye == 0 ? "left" : "right");
}

}  // namespace

bool ReferenceImages::exist() const {
    return fs::is_directory(folder_ / key_);
}

void ReferenceImages::render(Renderer& renderer, const std::vector<FlownFrame>& flight,
                             const std::function<void(std::size_t)>& frame_done) const {
    fs::create_directories(folder_);
    std::string draft = (folder_ / (key_ + ".draft-XXXXXX")).string();
    if (mkdtemp(draft.data()) == nullptr)
        throw std::system_error(errno, std::generic_category(), draft);
    try {
        for (std::size_t i = 0; i < flight.size(); ++i) {
            const FrameInput& input = flight[i].input;
            renderer.render(input);
            for (std::size_t eye = 0; eye < input.eyes.size(); ++eye)
                write_exr(draft / fs::path(file_name(input, eye)),
                          renderer.image(static_cast<int>(eye)));
            frame_done(i + 1);
        }
    } catch (...) {
        fs::remove_all(draft);
        throw;
    }
    fs::permissions(draft, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                               fs::perms::others_read | fs::perms::others_exec);
    std::error_code error;
    fs::rename(draft, folder_ / key_, error);
    if (!error) return;
    fs::remove_all(draft);
    if (!exist()) throw std::system_error(error, (folder_ / key_).string());
}

Image ReferenceImages::image(const FrameInput& input, std::size_t eye) const {
    try {
        return read_image(folder_ / key_ / file_name(input, eye)).image;
    } catch (const ImageFileError& error) {
        throw InputError(fmt::format("{}; delete {} to have it rendered again", error.what(),
                                     (folder_ / key_).string()));
    }
}

}  // namespace foverig::sweep
