#include "app/bench/benchmarks.hpp"
#include "app/commands/command.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/number_check.hpp"

#include <map>

namespace quicksand {

namespace {

void add_demo(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<DemoChoice>(
        program, commands, "demo", "Run the dike example, shortened to about two minutes", run_demo);
    add_threads(*parser, choice->threads);
    parser
        ->add_option("-o,--output", choice->directory,
                     "Results folder, replaced if there; results/demo when not given")
        ->type_name("DIR");
}

void add_verify(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<VerifyChoice>(
        program, commands, "verify", "Measure errors and orders on problems with known solutions",
        verify_problems);
    parser->add_option("PROBLEM", choice->problems,
                       "Names in examples/verification, or scenes with [verification]; all when not given");
    parser->add_flag("--short", choice->shortened, "Only the coarse grids, in less than a minute");
    add_overrides(*parser, choice->overrides);
    parser
        ->add_option("--threads", choice->threads,
                     "Runs at the same time; all of the machine's when not given")
        ->check(number_in(allowed_thread_count))
        ->type_name("N");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder of the table and the figures; results/verification when not given")
        ->type_name("DIR");
}

void add_bench(CLI::App& program, Commands& commands)
{
    using Measure = ExitCode (*)(const BenchChoice&);
    static const std::map<std::string, Measure> subjects = {{"kernel", measure_kernel},
                                                            {"error", measure_errors},
                                                            {"grid", measure_grids},
                                                            {"scale", measure_scale},
                                                            {"skip", measure_skips}};
    CLI::App* parser = program.add_subcommand("bench", "Measure speed, memory, and run time against error");
    auto subject = std::make_shared<std::string>();
    auto choice = std::make_shared<BenchChoice>();
    parser
        ->add_option(
            "SUBJECT", *subject,
            "kernel: the phases of a step; error: run time against error; grid: a scene's answers over cell "
            "size and particles per cell; scale: over particles and threads; skip: what scenes save "
            "by what they leave out")
        ->required()
        ->check(CLI::IsMember({"kernel", "error", "grid", "scale", "skip"}));
    parser->add_option(
        "WORDS", choice->words,
        "Scenes, or for error problems of verify; those that come with the program when not given");
    add_overrides(*parser, choice->overrides, "Replace a key of the scenes");
    parser->add_option("-o,--output", choice->directory, "Folder of tables and figures")
        ->type_name("DIR")
        ->capture_default_str();
    parser->add_option("--until", choice->until, "End of the runs of scenes in s, for error and grid")
        ->type_name("T")
        ->check(number_in(positive_number));
    parser->add_option("--largest", choice->largest, "Particles of the largest body of scale")
        ->check(number_in({.lower = 1e3, .upper = 1e8}))
        ->type_name("N")
        ->capture_default_str();
    parser->add_option("--threads", choice->threads, "Threads; kernel measures 1 and 2 when not given")
        ->check(number_in(allowed_thread_count))
        ->type_name("N");
    commands.push_back({parser, [subject, choice] { return subjects.at(*subject)(*choice); }});
}

void add_stress(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<StressChoice>(
        program, commands, "stress",
        "Run a designed set of scenes and random ones, to find where the program loses its stability",
        stress_solver);
    parser->add_option("ROWS", choice->rows,
                       "What the rows to run begin with, as \"steps\" or \"corners/explicit-fixed\"; "
                       "all when not given");
    parser->add_option("--random", choice->random_scenes, "Random scenes")
        ->check(number_in({.lower = 0.0, .upper = 9999.0}))
        ->type_name("N")
        ->capture_default_str();
    parser->add_option("--seed", choice->seed, "Of the random scenes: the same one gives the same scenes")
        ->check(number_in({.lower = 0.0, .upper = 1e15}))
        ->type_name("N")
        ->capture_default_str();
    parser->add_flag("--long", choice->long_ones,
                     "Also rows that take minutes: a bar that swings for 10^6 steps");
    parser->add_option("--limit", choice->limit, "Wall time in s after which a row is ended")
        ->check(number_in(positive_number))
        ->type_name("T")
        ->capture_default_str();
    parser->add_option("--row", choice->row, "Run this row alone in this process, to look at it closely")
        ->type_name("ROW");
    parser
        ->add_option("--threads", choice->threads,
                     "Rows at the same time; all of the machine's when not given")
        ->check(number_in(allowed_thread_count))
        ->type_name("N");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder of the page, the tables, the figures and the scenes")
        ->type_name("DIR")
        ->capture_default_str();
}

} // namespace

void add_measuring_commands(CLI::App& program, Commands& commands)
{
    add_demo(program, commands);
    add_verify(program, commands);
    add_bench(program, commands);
    add_stress(program, commands);
}

} // namespace quicksand
