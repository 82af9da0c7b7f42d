#include "rig/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "renderer/backend_error.h"
#include "renderer/check.h"
#include "renderer/scene/error.h"
#include "rig/calibrate_options.h"
#include "rig/commands.h"
#include "rig/compare_options.h"
#include "rig/diff_options.h"
#include "rig/expose_options.h"
#include "rig/identity/build_info.h"
#include "rig/number_in.h"
#include "rig/report_options.h"
#include "rig/scenario/write.h"
#include "rig/scenario_options.h"
#include "rig/sweep_options.h"
#include "rig/tune_options.h"

namespace foverig {
namespace {

struct RunOptions {
    ScenarioOptions scenario;
    std::string out;
    std::vector<std::string> fail_if;
    bool json = false;
    bool help_scenario = false;
};

struct RecordOptions {
    ScenarioOptions scenario;
    std::string out;
};

struct ReplayOptions {
    std::string file;
    std::optional<double> speed;
    bool loop = false;
};

struct RecoverOptions {
    std::string file;
    std::string out;
};

struct PlanOptions {
    ScenarioOptions scenario;
    bool no_run = false;
    bool json = false;
};

void add_run_options(CLI::App& run, RunOptions& options) {
    run.add_option("--out", options.out, "run folder to write; none: the next free runs/NNN")
        ->type_name("DIR")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    run.add_option("--fail-if", options.fail_if,
                   "exit with 1 if this holds of summary.json; may be given again")
        ->type_name("'KEY > NUMBER'")
        ->allow_extra_args(false);
    run.add_flag("--json", options.json, "the summary as one JSON object on the last line");
}

void add_run(CLI::App& app, RunOptions& options) {
    CLI::App& run = *app.add_subcommand("run", "frame loop; writes a run folder with a report");
    options.scenario.add_to(run);
    add_run_options(run, options);
    run.add_flag("--help-scenario", options.help_scenario, "all scenario keys with their defaults");
    run.footer(
        "Examples:\n"
        "  foverig run                                the built-in scenario\n"
        "  foverig run my.toml --frames 300 --out my-run\n"
        "  foverig run --scene sponza.glb --set foveation.configuration=small\n"
        "  foverig run --clock lockstep --cost fixed:10 --seed 7      repeats bit for bit\n"
        "  foverig run --display window --gaze mouse                  look at it; Escape ends it\n"
        "  foverig run --set recording.enabled=true                   keeps session.mcap\n"
        "  foverig run my.toml --fail-if 'vsync.missed_ratio > 0.01'");
}

void add_record(CLI::App& app, RecordOptions& options) {
    CLI::App& record =
        *app.add_subcommand("record", "the devices' streams alone, into an MCAP file");
    options.scenario.add_to(record);
    record
        .add_option("--out", options.out, "file to write; none: the next free recordings/NNN.mcap")
        ->type_name("FILE");
    record.footer(
        "Examples:\n"
        "  foverig record --seconds 10 --out desk.mcap\n"
        "  foverig record --set motion.head=look --clock wall --seconds 60");
}

void add_replay(CLI::App& app, ReplayOptions& options, RunOptions& run) {
    CLI::App& replay =
        *app.add_subcommand("replay", "`run` on a recording, with the scenario that it holds");
    replay.add_option("file", options.file, "recording (MCAP)")->type_name("FILE")->required();
    replay
        .add_option("--speed", options.speed,
                    "on the wall clock at so many times the recorded speed; 0: as fast as possible")
        ->check(number_in(0.0, 1000.0));
    replay.add_flag("--loop", options.loop, "begin again at the end");
    run.scenario.add_settings_to(replay);
    add_run_options(replay, run);
    replay.footer(
        "Examples:\n"
        "  foverig replay runs/001/session.mcap             the same poses and gaze, bit for bit,\n"
        "                                                   if the cost was fixed\n"
        "  foverig replay desk.mcap --speed 1               at recorded time\n"
        "  foverig replay desk.mcap --pipeline full --loop --seconds 60\n"
        "  foverig run my.toml --devices replay:desk.mcap   another scenario on its devices");
}

void add_recover(CLI::App& app, RecoverOptions& options) {
    CLI::App& recover = *app.add_subcommand("recover", "mend a torn or damaged recording");
    recover.add_option("file", options.file, "recording (MCAP)")->type_name("FILE")->required();
    recover.add_option("--out", options.out, "file to write; none: NAME.recovered.mcap beside it")
        ->type_name("FILE");
    recover.footer("Example:\n  foverig recover session.mcap --out mended.mcap");
}

void add_plan(CLI::App& app, PlanOptions& options) {
    CLI::App& plan =
        *app.add_subcommand("plan", "which effects and passes run, why, and what they cost");
    options.scenario.add_to(plan);
    plan.add_flag("--no-run", options.no_run,
                  "only decide: render nothing, so costs are not known");
    plan.add_flag("--json", options.json, "as JSON");
    plan.footer(
        "Examples:\n"
        "  foverig plan --scene cornell\n"
        "  foverig plan my.toml --set lighting.ao_samples=16");
}

std::vector<FailIf> parsed(const std::vector<std::string>& texts) {
    std::vector<FailIf> checks;
    for (const std::string& text : texts) checks.push_back(parse_fail_if(text));
    return checks;
}

std::optional<std::filesystem::path> path_of(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional<std::filesystem::path>(text);
}

ExitCode run(const RunOptions& options, const Scenario& scenario) {
    return run_command({.scenario = scenario,
                        .out = path_of(options.out),
                        .checks = parsed(options.fail_if),
                        .json = options.json});
}

ExitCode run(const RunOptions& options) {
    if (options.help_scenario) {
        fmt::print("{}", scenario_help());
        return ExitCode::good;
    }
    return run(options, options.scenario.scenario());
}

ExitCode replay(const ReplayOptions& options, const RunOptions& run_options) {
    Scenario base = recorded_scenario(options.file);
    base.replay.loop = options.loop;
    if (options.speed) {
        base.clock = *options.speed > 0.0 ? "wall" : "lockstep";
        if (*options.speed > 0.0) {
            base.cost = "measured";
            base.replay.speed = *options.speed;
        }
    }
    return run(run_options, run_options.scenario.over(std::move(base)));
}

ExitCode dispatch(int argc, const char* const* argv) {
    CLI::App app(
        "Test and benchmark rig for foveated ray tracing on head-mounted displays. With no "
        "argument: the built-in scenario on simulated devices.",
        "foverig");
    const BuildInfo build = build_info();
    app.set_version_flag("--version",
                         fmt::format("foverig {} ({}), {}", build.version,
                                     build.git.value_or("no commit known"), build.compiler));
    app.require_subcommand(0, 1);
    app.footer(
        "Exit codes: 0 good, 1 a check failed, 2 usage or scenario, 3 input data, 4 device, "
        "5 internal, 6 (compare, fixed cost) different.");
    RunOptions run_options, replay_run_options;
    RecordOptions record_options;
    ReplayOptions replay_options;
    RecoverOptions recover_options;
    PlanOptions plan_options;
    DiffOptions diff_options;
    CompareOptions compare_options;
    SweepOptions sweep_options;
    TuneOptions tune_options;
    ExposeOptions expose_options;
    CalibrateOptions calibrate_options;
    ReportOptions report_options;
    add_run(app, run_options);
    add_record(app, record_options);
    add_replay(app, replay_options, replay_run_options);
    add_recover(app, recover_options);
    add_plan(app, plan_options);
    report_options.add_to(app);
    diff_options.add_to(app);
    compare_options.add_to(app);
    sweep_options.add_to(app);
    tune_options.add_to(app);
    expose_options.add_to(app);
    calibrate_options.add_to(app);
    app.add_subcommand("scenes", "what there is to look at");
    app.add_subcommand("devices", "simulated devices, motions and faults");
    app.add_subcommand("doctor", "what works on this machine, and what to do");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked_for = error.get_exit_code() == 0;  // --help, --version
        app.exit(error);
        return asked_for ? ExitCode::good : ExitCode::usage;
    }
    if (app.got_subcommand("record")) {
        return record_command(
            {.scenario = record_options.scenario.scenario(), .out = path_of(record_options.out)});
    }
    if (app.got_subcommand("replay")) return replay(replay_options, replay_run_options);
    if (app.got_subcommand("recover")) {
        return recover_command(recover_options.file, path_of(recover_options.out));
    }
    if (app.got_subcommand("plan")) {
        return plan_command({.scenario = plan_options.scenario.scenario(),
                             .measure = !plan_options.no_run,
                             .json = plan_options.json});
    }
    if (app.got_subcommand("report")) return report_command(report_options.request());
    if (app.got_subcommand("diff")) return diff_command(diff_options.request());
    if (app.got_subcommand("compare")) return compare_command(compare_options.request());
    if (app.got_subcommand("tune")) return tune_command(tune_options.request());
    if (app.got_subcommand("sweep")) return sweep_command(sweep_options.request());
    if (app.got_subcommand("expose")) return expose_command(expose_options.request());
    if (app.got_subcommand("calibrate")) return calibrate_command(calibrate_options.request());
    if (app.got_subcommand("scenes")) return scenes_command();
    if (app.got_subcommand("devices")) return devices_command();
    if (app.got_subcommand("doctor")) return doctor_command();
    return run(run_options);
}

int failed(ExitCode code, const char* text) {
    fmt::print(stderr, "foverig: {}\n", text);
    return static_cast<int>(code);
}

}  // namespace

int run_program(int argc, const char* const* argv) {
    try {
        return static_cast<int>(dispatch(argc, argv));
    } catch (const UsageError& error) {
        return failed(ExitCode::usage, error.what());
    } catch (const SceneError& error) {
        return failed(ExitCode::input, error.what());
    } catch (const InputError& error) {
        return failed(ExitCode::input, error.what());
    } catch (const DeviceError& error) {
        return failed(ExitCode::device, error.what());
    } catch (const BackendError& error) {
        return failed(ExitCode::device, error.what());
    } catch (const std::bad_alloc&) {
        return failed(ExitCode::internal, "out of memory");
    } catch (const std::exception& error) {
        return failed(ExitCode::internal, error.what());
    }
}

}  // namespace foverig
