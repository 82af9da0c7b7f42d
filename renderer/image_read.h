#pragma once
#include <filesystem>
#include <stdexcept>

#include "renderer/image.h"

namespace foverig {

/// A picture as its file has it, in linear light.
struct ReadImage {
    Image image;
    bool high_dynamic_range = false;  ///< PFM, Radiance HDR and EXR; a PNG is of 0 to 1
};

/// One sentence: the file and what is wrong with it.
struct ImageFileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads PNG (8 or 16 bit, sRGB unless the file says otherwise, over black where it is
/// transparent), PFM, Radiance HDR (RGBE) or OpenEXR (R, G, B or Y), told apart by their first
/// bytes. Grey becomes RGB. At most 64 million pixels. Throws ImageFileError.
ReadImage read_image(const std::filesystem::path& file);

}  // namespace foverig
