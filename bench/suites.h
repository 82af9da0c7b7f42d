#pragma once
// Each suite registers its benchmarks; all of them borrow what they are given until the program
// ends.
#include "bench/cases.h"
#include "bench/options.h"
#include "bench/report_json.h"

namespace foverig::bench {

struct Bench {
    Options options;
    SceneShelf scenes{options};
    Results results{options};

    Bench() = default;
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;
};

void register_full_against_embree(Bench& bench);
void register_foveation_speedup(Bench& bench);
void register_fixed_work(Bench& bench);
void register_frame_times(Bench& bench);
void register_reprojection_error(Bench& bench);
void register_large_scenes(Bench& bench);
void register_tracer(Bench& bench);
void register_recorder(Bench& bench);
void register_metrics(Bench& bench);
void register_kernels();
void register_devices();
void register_camera();
void register_hour(Bench& bench);
void register_transport(Bench& bench);
void register_vsync(Bench& bench);
void register_rig_latency(Bench& bench);

}  // namespace foverig::bench
