#include "rig/compare_options.h"

#include "rig/number_in.h"

namespace foverig {

void CompareOptions::add_to(CLI::App& app) {
    CLI::App& compare =
        *app.add_subcommand("compare", "is one set of runs slower than another; exit 1 if it is");
    compare
        .add_option(
            "runs", runs_,
            "BASE NEW, or with --against only BASE...; each a run folder or a folder of them")
        ->type_name("BASE...")
        ->required();
    compare.add_option("--against", against_, "the new runs")->type_name("NEW...");
    compare.add_option("--threshold", threshold_percent_, "what matters, in percent of the base")
        ->check(number_in(0.0, 1000.0))
        ->capture_default_str();
    compare.add_option("--of", of_, "column of frames.csv to compare, of which less is better")
        ->type_name("COLUMN")
        ->capture_default_str();
    compare.add_flag("--paired", paired_,
                     "the first of both sides were made together, the second too, ...: a machine "
                     "that drifts does no harm then");
    compare.add_option("--allow", allowed_, "keys that may differ, with commas between")
        ->delimiter(',')
        ->type_name("KEYS");
    compare.add_flag("--json", json_, "one JSON object on the last line");
    compare.footer(
        "Examples:\n"
        "  foverig compare base new                  two folders of ten runs each, made in turns\n"
        "  foverig compare base/* --against new/* --paired --threshold 1\n"
        "  foverig compare base new --of cpu_ms      on a machine that others use too\n"
        "  foverig compare full reprojected --allow pipeline --of render_ms\n"
        "Runs at fixed cost are compared byte for byte. Exit code 1: worse, or at fixed cost not\n"
        "the same. docs/compare.md explains the verdicts.");
}

CompareRequest CompareOptions::request() const {
    CompareRequest request;
    request.times = {.of = of_, .threshold = 0.01 * threshold_percent_, .paired = paired_};
    request.allowed = allowed_;
    request.json = json_;
    if (against_.empty() && runs_.size() != 2)
        throw UsageError(
            "compare: expected BASE NEW, two run folders or folders of runs, or BASE... --against "
            "NEW...");
    request.base.assign(runs_.begin(), against_.empty() ? runs_.begin() + 1 : runs_.end());
    if (against_.empty())
        request.fresh = {runs_[1]};
    else
        request.fresh.assign(against_.begin(), against_.end());
    return request;
}

}  // namespace foverig
