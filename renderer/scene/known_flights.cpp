#include "renderer/scene/known_flights.h"

#include <array>
#include <cmath>
#include <span>

namespace foverig::scene_import {
namespace {

struct KnownFlight {
    Bounds bounds;                    ///< of the scene, in its file's units
    std::span<const CameraKey> keys;  ///< in the same
};

// Positions were checked to keep at least 0.3 m from any surface, straight lines between them too.

/// Crytek Sponza: up the nave, round its end, and back through the aisle.
constexpr std::array kSponzaKeys{CameraKey{{-9.8F, 1.7F, -0.3F}, {-2.0F, 2.4F, -0.3F}},
                                 CameraKey{{-4.0F, 2.0F, -0.3F}, {4.0F, 3.2F, -0.3F}},
                                 CameraKey{{3.0F, 2.2F, -0.3F}, {9.5F, 2.6F, 0.4F}},
                                 CameraKey{{7.8F, 1.8F, -0.2F}, {10.0F, 1.8F, 2.6F}},
                                 CameraKey{{8.6F, 1.7F, 1.9F}, {5.5F, 1.9F, 3.6F}},
                                 CameraKey{{6.6F, 1.7F, 3.1F}, {0.0F, 1.9F, 3.0F}},
                                 CameraKey{{-1.0F, 1.8F, 3.1F}, {-7.0F, 2.4F, 1.8F}},
                                 CameraKey{{-8.4F, 1.8F, 3.1F}, {-9.5F, 2.2F, -3.0F}},
                                 CameraKey{{-9.9F, 1.7F, 1.6F}, {-4.0F, 2.2F, -1.6F}},
                                 CameraKey{{-9.8F, 1.7F, -0.3F}, {-2.0F, 2.4F, -0.3F}}};

/// Sibenik cathedral: up the nave, through the pillars, and back through the aisle.
constexpr std::array kSibenikKeys{CameraKey{{-17.6F, -13.4F, 0.3F}, {-4.0F, -11.0F, 0.3F}},
                                  CameraKey{{-10.0F, -12.6F, 0.2F}, {4.0F, -9.5F, 0.0F}},
                                  CameraKey{{-3.5F, -12.2F, 0.1F}, {9.0F, -9.0F, 0.5F}},
                                  CameraKey{{-0.8F, -12.9F, 1.4F}, {-1.0F, -12.5F, 8.0F}},
                                  CameraKey{{-1.7F, -13.3F, 3.9F}, {-7.0F, -12.8F, 7.0F}},
                                  CameraKey{{-4.0F, -13.4F, 5.5F}, {-12.0F, -12.6F, 4.6F}},
                                  CameraKey{{-11.0F, -13.4F, 5.5F}, {-17.0F, -12.0F, 1.0F}},
                                  CameraKey{{-17.2F, -13.4F, 4.6F}, {-9.0F, -11.5F, -2.0F}},
                                  CameraKey{{-17.6F, -13.4F, 0.3F}, {-4.0F, -11.0F, 0.3F}}};

/// Dabrovic Sponza: up the court, and back behind the columns.
constexpr std::array kDabrovicKeys{CameraKey{{-13.5F, 1.2F, -0.2F}, {-2.0F, 3.2F, -0.2F}},
                                   CameraKey{{-5.0F, 1.7F, -0.2F}, {6.0F, 4.2F, -0.6F}},
                                   CameraKey{{4.0F, 1.6F, -0.4F}, {13.0F, 2.8F, 1.5F}},
                                   CameraKey{{12.5F, 1.2F, 1.0F}, {11.5F, 1.6F, 7.0F}},
                                   CameraKey{{12.0F, 1.1F, 4.9F}, {4.0F, 1.9F, 4.4F}},
                                   CameraKey{{2.0F, 1.1F, 5.0F}, {-6.0F, 2.2F, 3.0F}},
                                   CameraKey{{-8.0F, 1.1F, 5.0F}, {-15.0F, 2.0F, 2.0F}},
                                   CameraKey{{-13.5F, 1.2F, 2.6F}, {-5.0F, 2.4F, -2.6F}},
                                   CameraKey{{-13.5F, 1.2F, -0.2F}, {-2.0F, 3.2F, -0.2F}}};

/// Country kitchen: from the far corner along the table to the window, and back on its other side.
constexpr std::array kKitchenKeys{CameraKey{{2.2F, 1.60F, 4.1F}, {0.2F, 1.10F, -0.5F}},
                                  CameraKey{{0.8F, 1.62F, 3.2F}, {-0.2F, 1.05F, -1.5F}},
                                  CameraKey{{-1.2F, 1.58F, 2.3F}, {0.4F, 1.00F, -1.2F}},
                                  CameraKey{{-1.35F, 1.55F, 0.4F}, {0.8F, 1.05F, -2.4F}},
                                  CameraKey{{-1.1F, 1.55F, -0.9F}, {1.8F, 1.05F, -1.9F}},
                                  CameraKey{{0.4F, 1.58F, -0.3F}, {2.6F, 1.10F, -1.2F}},
                                  CameraKey{{1.9F, 1.60F, 0.2F}, {-0.4F, 1.05F, 0.6F}},
                                  CameraKey{{2.1F, 1.62F, 2.2F}, {-1.6F, 1.10F, 0.2F}},
                                  CameraKey{{2.2F, 1.60F, 4.1F}, {0.2F, 1.10F, -0.5F}}};

/// Littlest Tokyo: an orbit close enough to look into its yards and onto its balconies.
constexpr std::array kTokyoKeys{CameraKey{{-86.0F, 130.0F, 480.0F}, {-86.0F, -20.0F, -25.0F}},
                                CameraKey{{290.0F, 110.0F, 350.0F}, {-86.0F, -40.0F, -25.0F}},
                                CameraKey{{430.0F, 90.0F, -25.0F}, {-86.0F, -30.0F, -25.0F}},
                                CameraKey{{270.0F, 120.0F, -390.0F}, {-86.0F, -20.0F, -25.0F}},
                                CameraKey{{-86.0F, 150.0F, -540.0F}, {-86.0F, -20.0F, -25.0F}},
                                CameraKey{{-450.0F, 120.0F, -390.0F}, {-86.0F, -20.0F, -25.0F}},
                                CameraKey{{-600.0F, 90.0F, -25.0F}, {-86.0F, -30.0F, -25.0F}},
                                CameraKey{{-460.0F, 110.0F, 350.0F}, {-86.0F, -40.0F, -25.0F}},
                                CameraKey{{-86.0F, 130.0F, 480.0F}, {-86.0F, -20.0F, -25.0F}}};

const std::array kKnown{
    KnownFlight{{{-15.368F, -1.012F, -9.462F}, {14.399F, 11.436F, 8.843F}}, kSponzaKeys},
    KnownFlight{{{-20.141F, -15.312F, -8.497F}, {20.141F, 15.300F, 8.497F}}, kSibenikKeys},
    KnownFlight{{{-17.403F, -0.907F, -7.799F}, {17.417F, 15.653F, 7.801F}}, kDabrovicKeys},
    KnownFlight{{{-3.139F, -0.021F, -3.184F}, {3.777F, 3.364F, 5.471F}}, kKitchenKeys},
    KnownFlight{{{-359.114F, -211.502F, -301.603F}, {185.953F, 222.809F, 250.440F}}, kTokyoKeys}};

}  // namespace

std::optional<std::vector<CameraKey>> known_flight(const Scene& scene) {
    const vec3 extent_m = scene.bounds.max_m - scene.bounds.min_m;
    for (const KnownFlight& known : kKnown) {
        const vec3 ratio = extent_m / (known.bounds.max_m - known.bounds.min_m);
        const float scale = ratio.x;
        if (glm::length(ratio / scale - 1.0F) > 0.005F) continue;
        std::vector<CameraKey> keys;
        const auto placed = [&](const vec3& p) {
            return scene.bounds.min_m + scale * (p - known.bounds.min_m);
        };
        for (const CameraKey& key : known.keys)
            keys.push_back({placed(key.position_m), placed(key.target_m)});
        return keys;
    }
    return std::nullopt;
}

}  // namespace foverig::scene_import
