#include "io/reports/review_checklist.hpp"

#include "io/reports/html_page.hpp"

#include <fmt/format.h>

#include <array>

namespace quicksand {

namespace {

struct Question {
    const char* group;
    const char* question;
    const char* answered_by; // a part of the page or a command
};

// clang-format off
constexpr std::array questions = {
    Question{"ground", "Do section, layers and water levels agree with the investigations, and are their uncertainties covered by variants?", "Section; scene.toml"},
    Question{"ground", "Is the liquefaction of each layer first judged by a simplified procedure?", "to be added by hand"},
    Question{"calibration", "Has each sand been taken through the element laboratory at its stresses, and does its cyclic strength meet the target?", "quicksand element"},
    Question{"calibration", "Do stiffness, damping, conductivity and residual strength have a source?", "scene.toml; quicksand check"},
    Question{"numerical model", "Do the initial stresses and pore pressures balance, and is the factor of safety before the shaking plausible?", "log.txt; quicksand stability"},
    Question{"numerical model", "Are the sides far enough away, and does the base absorb waves where the rock does?", "Section; boundaries of scene.toml"},
    Question{"numerical model", "Do half the cell size and other schemes give the same answer?", "quicksand compare"},
    Question{"numerical model", "Do energy, momentum and water balance?", "Balances"},
    Question{"motions", "Are there enough motions for the hazard, and is it said whether they are those of outcrop or base?", "Motion of the base; quicksand compare"},
    Question{"motions", "Are baseline, filter and scale of each motion documented, and is its velocity zero at the end?", "Motion of the base; quicksand motion"},
    Question{"results", "Does the pattern of deformation have a mechanism that an engineer can explain?", "In time; Pictures"},
    Question{"results", "Is the crest above the required height with a margin for what the analysis does not cover: settlement by drainage, cracks, later loads?", "Crest"},
    Question{"results", "Has the state after the shaking been checked with the pore pressures and residual strengths that are left?", "quicksand stability"},
};
// clang-format on

} // namespace

std::string review_checklist()
{
    std::string html = "<table>\n<tr><th></th><th>about</th><th>question</th><th>look at</th></tr>\n";
    for (const Question& row : questions)
        html +=
            fmt::format("<tr><td><span class=\"box\"></span></td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        html_text(row.group), html_text(row.question), html_text(row.answered_by));
    return html + "</table>\n";
}

} // namespace quicksand
