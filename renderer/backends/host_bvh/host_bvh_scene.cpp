#include "renderer/backends/host_bvh/host_bvh_scene.h"

#include <algorithm>

#include "renderer/trace/build/binned_sah.h"
#include "renderer/trace/traverse.h"

namespace foverig::host_bvh {

HostBvhScene::HostBvhScene(const Scene& scene, const HostBvhSettings& settings)
    : posed_(scene, settings.pose),
      bvh_(scene, posed_.view().positions_m, posed_.moving_parts(), settings.alpha_test,
           settings.build_still ? settings.build_still : build_binned_triangles),
      traced_(bvh_.view()) {
    holes_ = settings.alpha_test && std::any_of(scene.parts.begin(), scene.parts.end(),
                                                [](const Part& p) { return p.alpha_masked; });
}

Hit HostBvhScene::closest(const Ray& ray) const {
    return holes_ ? traverse<false, true>(traced_, posed_.view(), ray)
                  : traverse<false, false>(traced_, posed_.view(), ray);
}

bool HostBvhScene::occluded(const Ray& ray) const {
    const Hit hit = holes_ ? traverse<true, true>(traced_, posed_.view(), ray)
                           : traverse<true, false>(traced_, posed_.view(), ray);
    return !hit.missed();
}

void HostBvhScene::set_time(double time_s) {
    if (posed_.moving_parts().empty()) return;
    posed_.set_time(time_s);
    bvh_.refit(posed_.view().positions_m);
    traced_ = bvh_.view();
}

SceneBytes HostBvhScene::bytes() const {
    SceneBytes bytes = posed_.bytes();
    bytes.base += bvh_.bytes();
    return bytes;
}

}  // namespace foverig::host_bvh
