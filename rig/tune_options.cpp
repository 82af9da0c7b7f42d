#include "rig/tune_options.h"

#include "rig/number_in.h"

namespace foverig {

void TuneOptions::add_to(CLI::App& app) {
    CLI::App& tune = *app.add_subcommand(
        "tune", "search a sweep's knobs for the smallest error within a budget of milliseconds");
    tune.add_option("file", file_, "a sweep whose knobs are lists, each in rising or falling order")
        ->type_name("SWEEP.toml")
        ->required();
    tune.add_option("--budget-ms", budget_ms_, "of a frame; none: a VSync")
        ->check(number_in(0.001, 10'000.0));
    tune.add_option("--out", out_, "folder; one that was begun goes on; none: runs/NAME-tuned")
        ->type_name("DIR");
    tune.add_flag("--json", json_, "tuned.json on the last line");
    tune.footer(
        "Examples:\n"
        "  foverig tune sweeps/example.toml --budget-ms 6\n"
        "  foverig run runs/example-tuned/tuned.toml\n"
        "Measures what the search asks for, not the whole grid; what was measured serves another\n"
        "budget too. Exit code 1: nothing that was tried fits. docs/sweeps.md explains the "
        "search.");
}

TuneRequest TuneOptions::request() const {
    TuneRequest request;
    request.file = file_;
    request.budget_ms = budget_ms_;
    request.json = json_;
    if (!out_.empty()) request.out = out_;
    return request;
}

}  // namespace foverig
