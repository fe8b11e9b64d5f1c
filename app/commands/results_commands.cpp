#include "app/commands/command.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/number_check.hpp"

namespace quicksand {

namespace {

void add_probe(CLI::App& program, Commands& commands)
{
    struct Words {
        std::vector<double> at;
        std::string kind = "fixed";
    };
    CLI::App* parser = program.add_subcommand("probe", "Take a history at a point out of written frames");
    auto choice = std::make_shared<ProbeChoice>();
    auto words = std::make_shared<Words>();
    parser->add_option("RESULTS", choice->results, "Results folder of a run")->required();
    parser->add_option("--at", words->at, "Place in m")
        ->check(number_in(any_number))
        ->delimiter(',')
        ->expected(2)
        ->allow_extra_args(false)
        ->required()
        ->type_name("X,Y");
    parser->add_option("--fields", choice->fields, "Fields, as excess_pore_pressure,ru")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->required()
        ->type_name("A,B");
    parser->add_option("--kind", words->kind, "fixed in space, or moving with the material")
        ->check(CLI::IsMember({"fixed", "material"}));
    parser->add_option("-o,--output", choice->file, "CSV file to write")->required()->type_name("FILE");
    commands.push_back({parser, [choice, words] {
                            choice->at = {words->at[0], words->at[1]};
                            choice->rides_with_soil = words->kind == "material";
                            return extract_probe(*choice);
                        }});
}

void add_picture(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<PictureChoice>(
        program, commands, "picture", "Draw the results of a run as PNG files, no display needed",
        draw_pictures);
    parser->add_option("RESULTS", choice->results, "Results folder of a run")->required();
    parser
        ->add_option("-o,--output", choice->output,
                     "A .png file or a folder; RESULTS/pictures when not given")
        ->type_name("FILE");
    parser->add_option("--field", choice->field, "Only this field, as excess_pore_pressure or displacement")
        ->type_name("NAME");
    parser
        ->add_option("--time", choice->time, "Time in s, the nearest frame is drawn; the last when not given")
        ->check(number_in(any_number))
        ->type_name("T");
    parser->add_option("--range", choice->range, "Limits of the colours, in the SI unit of the field")
        ->type_name("LOW:HIGH");
    parser->add_option("--exaggeration", choice->exaggeration, "Factor on the displacements drawn")
        ->check(number_in(positive_number))
        ->type_name("F");
}

void add_figures(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<FiguresChoice>(
        program, commands, "figures",
        "Draw the figures of a scene's tables [figures.NAME] from its finished run", draw_scene_figures);
    parser->add_option("SOURCE", choice->source, "Scene, its folder, or the results folder of a run")
        ->required();
    parser->add_option("--results", choice->results, "Results of the scene; results/<scene> when not given")
        ->type_name("DIR");
    parser
        ->add_option("-o,--output", choice->output, "Folder of the PNG files; RESULTS/figures when not given")
        ->type_name("DIR");
}

void add_compare(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<CompareChoice>(
        program, commands, "compare",
        "Draw the histories of runs over each other, and list peaks, final values and differences",
        compare_results);
    parser
        ->add_option("RESULTS", choice->results, "Results folders of runs, the first of them to compare with")
        ->required();
    parser
        ->add_option("--field", choice->field,
                     "Field whose difference is drawn, as excess_pore_pressure; of two runs")
        ->type_name("NAME");
    parser
        ->add_option("--time", choice->time,
                     "Time in s of the frames whose difference is drawn; the last ones "
                     "when not given")
        ->check(number_in(any_number))
        ->type_name("T");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder, its files replaced if there; results/compare when not given")
        ->type_name("DIR");
}

void add_report(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<ReportChoice>(
        program, commands, "report", "Write a page on a run, with all its pictures in one HTML file",
        write_report);
    parser->add_option("RESULTS", choice->results, "Results folder of a run")->required();
    parser
        ->add_option("--required-height", choice->required_height,
                     "Height in m, as y of the drawing, that the crest must keep")
        ->check(number_in(any_number))
        ->type_name("Y");
    parser
        ->add_option("--field", choice->field,
                     "Field of the animation; ru, in a dry scene displacement, when not given")
        ->type_name("NAME");
    parser->add_option("-o,--output", choice->output, "HTML file; RESULTS/report.html when not given")
        ->type_name("FILE");
}

} // namespace

void add_results_commands(CLI::App& program, Commands& commands)
{
    add_probe(program, commands);
    add_picture(program, commands);
    add_figures(program, commands);
    add_compare(program, commands);
    add_report(program, commands);
}

} // namespace quicksand
