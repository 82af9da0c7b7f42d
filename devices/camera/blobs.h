#pragma once
// Spots of light in an image of the tracker camera.
#include <vector>

#include "devices/camera/frame.h"
#include "devices/math.h"

namespace foverig::camera {

struct BlobConfig {
    double threshold_sigmas = 8.0;  ///< above the background, of its noise ...
    double least_threshold = 12.0;  ///< ... and at least as many levels
    int least_area_px = 2;
    int most_area_px = 900;  ///< larger: a lamp or a window
    /// The box of an LED's spot is filled and about square; a filament or an edge is not.
    double most_elongation = 3.0;
    double least_fill = 0.4;
    /// Five times a headset's 40 LEDs; with more it is not the headset that lights the image.
    std::size_t most_blobs = 200;
};

struct Blob {
    dvec2 center_px{0};     ///< centroid of light; (0, 0) is a pixel's centre
    double brightness = 0;  ///< sum of levels above the background
    int area_px = 0;        ///< pixels above the threshold
    int peak = 0;           ///< highest level; 255: saturated
};

/// Level and spread of what is not lit, from every 61st pixel's median and quartile.
struct Background {
    double level = 0, sigma = 1;
};
Background background_of(const GreyView& image);

/// Spots, top to bottom. What touches the image's border is left out: its centre is not seen. One
/// more than `most_blobs` are the most: the time that it takes to tell spots apart, and to follow
/// them, grows with their square.
std::vector<Blob> find_blobs(const GreyView& image, const BlobConfig& config = {});

}  // namespace foverig::camera
