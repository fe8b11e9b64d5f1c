#include "app/commands/commands.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/results/stage_table.hpp"

#include <iostream>

namespace quicksand {

ExitCode draw_pictures(const PictureChoice& choice)
{
    PictureRequest request;
    request.output = choice.output;
    request.field = choice.field;
    request.time = choice.time;
    if (!choice.range.empty()) request.range = parse_range(choice.range);
    request.exaggeration = choice.exaggeration;
    request.notify = [](const std::string& text) { std::cerr << text << std::endl; };
    for (const std::filesystem::path& file : draw_results(with_histories(choice.results), request)) {
        std::cout << file.string() << '\n';
    }
    return ExitCode::good;
}

} // namespace quicksand
