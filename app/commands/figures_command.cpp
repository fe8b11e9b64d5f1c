#include "app/commands/commands.hpp"
#include "app/run/scene_setup.hpp"
#include "io/pictures/figure_set.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/stage_table.hpp"
#include "solver/base/failure.hpp"

#include <iostream>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

bool holds_results(const fs::path& folder)
{
    return fs::exists(ResultsFolder{folder}.manifest());
}

} // namespace

ExitCode draw_scene_figures(const FiguresChoice& choice)
{
    const fs::path source = with_histories(choice.source);
    const bool from_results = choice.results.empty() && holds_results(source);
    const fs::path scene = from_results ? ResultsFolder{source}.scene_copy() : find_scene_file(choice.source);
    fs::path results = choice.results;
    if (results.empty()) results = from_results ? source : default_results(scene);
    results = with_histories(results);
    if (!holds_results(results))
        throw InputError("there are no results in " + results.string() + "\nhint: quicksand run " +
                         choice.source.string() + " makes them; --results names another folder");
    const std::vector<SceneFigure> figures = figures_of_scene(scene);
    if (figures.empty())
        throw InputError(
            "the scene " + scene.string() +
            " asks for no figures\nexpected: tables [figures.NAME]\nhint: quicksand picture draws "
            "the usual set without them");
    const fs::path folder = choice.output.empty() ? results / "figures" : choice.output;
    const auto notify = [](const std::string& text) { std::cerr << text << std::endl; };
    for (const fs::path& file : draw_figures(results, figures, folder, notify)) {
        std::cout << file.string() << '\n';
    }
    return ExitCode::good;
}

} // namespace quicksand
