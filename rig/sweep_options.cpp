#include "rig/sweep_options.h"

namespace foverig {

void SweepOptions::add_to(CLI::App& app) {
    CLI::App& sweep = *app.add_subcommand(
        "sweep", "what accuracy costs in time: settings against error and milliseconds");
    sweep.add_option("file", file_, "which knobs, which values, against what (TOML)")
        ->type_name("SWEEP.toml")
        ->required();
    sweep.add_option("--out", out_, "folder; one that was begun goes on; none: runs/NAME")
        ->type_name("DIR");
    sweep.add_option("--shard", shard_, "measure every n-th point from the i-th on, from 0")
        ->type_name("I/N")
        ->capture_default_str();
    sweep.add_flag("--json", json_, "pareto.json on the last line");
    sweep.footer(
        "Examples:\n"
        "  foverig sweep sweeps/example.toml\n"
        "  foverig sweep my.toml --out front          again after Ctrl-C or a crash: goes on\n"
        "  foverig sweep my.toml --out front --shard 3/16    one of 16 jobs of a cluster ...\n"
        "  foverig report front                              ... and their result\n"
        "docs/sweeps.md explains the file and the numbers.");
}

SweepRequest SweepOptions::request() const {
    SweepRequest request;
    request.file = file_;
    request.shard = sweep::parse_shard(shard_);
    request.json = json_;
    if (!out_.empty()) request.out = out_;
    return request;
}

}  // namespace foverig
