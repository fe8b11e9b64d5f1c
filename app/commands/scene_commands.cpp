#include "app/commands/command.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/number_check.hpp"

namespace quicksand {

namespace {

void add_scene(CLI::App& parser, SceneChoice& choice,
               const std::string& about = "Scene file, or a folder that holds scene.toml")
{
    parser.add_option("SCENE", choice.scene, about)->required();
    add_threads(parser, choice.threads);
    parser.add_option("--until", choice.until, "End of the run in s, in place of run.end_time")
        ->check(number_in(positive_number))
        ->type_name("T");
    add_overrides(parser, choice.overrides);
}

void add_run(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] =
        add_command<RunChoice>(program, commands, "run", "Run a scene and write its results", run_scene);
    add_scene(*parser, choice->scene);
    parser->add_option("-o,--output", choice->directory, "Results folder; results/<scene> when not given")
        ->type_name("DIR");
    parser
        ->add_option("--from", choice->from,
                     "Begin with the end of another run, or of one of its stages, instead of settling")
        ->type_name("RESULTS[:STAGE]");
    CLI::Option* overwrite =
        parser->add_flag("--overwrite", choice->overwrite, "Replace the results of a former run");
    CLI::Option* resume =
        parser->add_flag("--resume", choice->resume, "Go on from the last checkpoint")->excludes(overwrite);
    parser
        ->add_flag("--continue", choice->go_on,
                   "Go on with what the folder holds of this run; else begin. A finished run stays")
        ->excludes(overwrite)
        ->excludes(resume);
}

void add_sweep(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<SweepChoice>(
        program, commands, "sweep", "Run a scene for many values of its keys, and collect what comes of it",
        run_sweep);
    parser->add_option("SWEEP", choice->file, "File of the sweep, or a folder that holds sweep.toml")
        ->required();
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder of the sweep; results/<file> when not given. What it holds is gone on with")
        ->type_name("DIR");
    parser
        ->add_option("--from", choice->from,
                     "Begin all runs with the end of another one, or of one of its stages: settled once")
        ->type_name("RESULTS[:STAGE]");
    parser->add_option("--jobs", choice->jobs, "Runs at a time; 1 when not given")
        ->check(number_in(allowed_thread_count))
        ->type_name("N");
    parser
        ->add_option("--threads", choice->threads,
                     "Threads of a run; when not given the machine's over --jobs, with slurm and snakemake 1")
        ->check(number_in(allowed_thread_count))
        ->type_name("N");
    parser
        ->add_option("--engine", choice->engine,
                     "local runs here; the others write files for GNU parallel, Slurm or Snakemake")
        ->check(CLI::IsMember({"local", "parallel", "slurm", "snakemake"}));
    CLI::Option* collect = parser->add_flag("--collect", choice->collect,
                                            "Run nothing; make tables and pictures of what is there");
    parser->add_flag("--dry-run", choice->dry_run, "Check and list the runs; write nothing")
        ->excludes(collect);
}

void add_check(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<CheckChoice>(
        program, commands, "check", "Print the plan of a run and write its initial frame", check_scene);
    add_scene(*parser, choice->scene);
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder of the frame; results/<scene>-check when not given")
        ->type_name("DIR");
}

void add_stability(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<StabilityChoice>(
        program, commands, "stability",
        "Find the factor of safety and the failure mode of a slope by strength reduction", assess_stability);
    add_scene(*parser, choice->scene,
              "Scene file, a folder that holds scene.toml, or the results folder of a run: from its end");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Results folder; results/<scene>-stability, or RESULTS/stability, when not given")
        ->type_name("DIR");
    parser->add_option("--tolerance", choice->tolerance, "Width of the bracket over the factor; 0.005")
        ->check(number_in({.lower = 1e-4, .upper = 0.5}))
        ->type_name("W");
    parser
        ->add_option("--seismic-coefficient", choice->seismic_coefficient,
                     "Horizontal force over weight, positive towards +x (pseudo-static)")
        ->check(number_in({.lower = -2.0, .upper = 2.0}))
        ->type_name("K");
    parser
        ->add_option("--residual-strength", choice->residual_strength,
                     "Strength of liquefied sand over its vertical effective stress before the shaking")
        ->check(number_in(positive_number))
        ->type_name("RATIO");
    parser->add_option("--liquefied-ru", choice->liquefied_ru, "Least ru of sand that has this strength; 0.8")
        ->check(number_in({.lower = 0.0, .upper = 1.0, .lower_open = true}))
        ->type_name("RU");
}

void add_new(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<NewChoice>(
        program, commands, "new", "Make a folder with a commented scene and drawing to start from",
        create_scene);
    parser->add_option("KIND", choice->example, "column, dike, river_dike, sea_dike, level_site or slope")
        ->required();
    parser->add_option("NAME", choice->folder, "The folder to make")->required();
}

void add_element(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<ElementChoice>(
        program, commands, "element", "Test a soil in the element laboratory: simple shear and others",
        run_element_tests);
    parser->add_option("TEST", choice->file, "File of tests, or a folder that holds test.toml")->required();
    add_overrides(*parser, choice->overrides, "Replace a key of the file: --set materials.sand.n1_60=10");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Results folder, replaced if there; results/<file> when not given")
        ->type_name("DIR");
}

void add_motion(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<MotionChoice>(
        program, commands, "motion",
        "Measure a recorded motion, draw its histories and response spectra, and make it ready for a scene",
        examine_motion);
    parser
        ->add_option("FILE", choice->file,
                     "Record in PEER's AT2 form, or two columns: time in s, acceleration")
        ->required();
    parser->add_option("--unit", choice->unit, "Unit of the accelerations of two columns")
        ->check(CLI::IsMember({"g", "m/s2"}));
    parser
        ->add_option("--trim", choice->trim, "Keep the values between these times in s, from there on time 0")
        ->type_name("FROM:TO");
    parser
        ->add_option("--baseline", choice->baseline, "Take off the straight line that fits the accelerations")
        ->check(CLI::IsMember({"none", "linear"}));
    parser
        ->add_option("--low-cut", choice->low_cut,
                     "Filter out what is slower; half of the amplitude is left there. In Hz")
        ->check(number_in(positive_number))
        ->type_name("F");
    parser->add_option("--high-cut", choice->high_cut, "Filter out what is faster, likewise. In Hz")
        ->check(number_in(positive_number))
        ->type_name("F");
    parser->add_option("--peak", choice->peak, "Scale to this peak acceleration, as \"0.3 g\"")
        ->type_name("PGA");
    parser->add_option("--damping", choice->damping, "Damping of the spectra in per cent; 5")
        ->check(number_in({.lower = 0.0, .upper = 50.0}))
        ->type_name("D");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder, its files replaced if there; results/<file>-motion when not given")
        ->type_name("DIR");
}

void add_validity(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<ValidityChoice>(
        program, commands, "validity", "Tell what a sand meets of what laboratories know, as Markdown",
        tell_validity);
    parser->add_option("TEST", choice->file, "File of element tests; a table for each material that they use")
        ->required();
    add_overrides(*parser, choice->overrides,
                  "Replace a key of the file: --set materials.sand.law=calibrated");
}

void add_calibrate(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<CalibrateChoice>(
        program, commands, "calibrate", "Fit keys of a sand to measured points of cyclic strength",
        calibrate_sand);
    parser->add_option("TEST", choice->file, "File of element tests, whose first test names the sand")
        ->required();
    parser
        ->add_option(
            "DATA", choice->data,
            "CSV file with columns CSR and N, and if you like alpha, k0, sigma_v (Pa) and criterion, "
            "which are those of the test where they are left out")
        ->required();
    parser
        ->add_option("--fit", choice->keys,
                     "Keys of the sand, up to four: --fit secondary_factor,secondary_growth")
        ->delimiter(',')
        ->required()
        ->expected(1, 4);
    add_overrides(*parser, choice->overrides, "Replace a key of the file: --set materials.sand.n1_60=10");
}

} // namespace

void add_threads(CLI::App& parser, int& threads)
{
    parser.add_option("--threads", threads, "Threads; all of the machine's when not given")
        ->check(number_in(allowed_thread_count))
        ->type_name("N");
}

void add_overrides(CLI::App& parser, std::vector<std::string>& overrides, const std::string& about)
{
    parser.add_option("--set", overrides, about)
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false); // the word after it may be a scene
}

void add_scene_commands(CLI::App& program, Commands& commands)
{
    add_run(program, commands);
    add_sweep(program, commands);
    add_check(program, commands);
    add_stability(program, commands);
    add_new(program, commands);
    add_element(program, commands);
    add_motion(program, commands);
    add_validity(program, commands);
    add_calibrate(program, commands);
}

} // namespace quicksand
