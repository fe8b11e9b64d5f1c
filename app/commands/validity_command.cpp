#include "app/commands/commands.hpp"
#include "io/element/element_file.hpp"
#include "io/element/validity_sheet.hpp"
#include "solver/base/parallel_tasks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <vector>

namespace quicksand {

namespace {

constexpr std::array blow_counts = {6.0, 9.0, 12.0, 16.0, 22.0};

/// The laws of a material at the blow counts, from the first test that uses it.
std::vector<SkeletonLaw> laws_of(const ValidityChoice& choice, const std::string& material)
{
    std::vector<SkeletonLaw> laws;
    for (const double N : blow_counts) {
        std::vector<std::string> overrides = choice.overrides;
        overrides.push_back(fmt::format("materials.{}.n1_60={:g}", material, N));
        for (const ElementTest& test : read_element_file(choice.file, overrides).programme.tests) {
            if (test.material != material) continue;
            laws.push_back(test.soil.law);
            break;
        }
    }
    return laws;
}

std::vector<SurveyedSand> survey_all(const std::vector<SkeletonLaw>& laws)
{
    std::vector<SurveyedSand> sands(laws.size());
    rethrow_first(attempt_each(laws.size(), [&](std::size_t k) {
        sands[k] = {blow_counts[k], survey(laws[k])};
    }));
    return sands;
}

} // namespace

ExitCode tell_validity(const ValidityChoice& choice)
{
    std::vector<std::string> materials; // in the order of the tests
    for (const ElementTest& test : read_element_file(choice.file, choice.overrides).programme.tests)
        if (std::find(materials.begin(), materials.end(), test.material) == materials.end())
            materials.push_back(test.material);
    std::string page = "# What the sand meets of what laboratories know\n\n";
    page += "Made by `quicksand validity " + choice.file.generic_string() + "`; do not edit.\n";
    for (const std::string& material : materials) {
        int met = 0, judged = 0;
        const std::string table = validity_table(survey_all(laws_of(choice, material)), met, judged);
        page += fmt::format("\n## {}: {} of {} met\n\n", material, met, judged) + table;
    }
    std::cout << page << "\n" << validity_sources();
    return ExitCode::good;
}

} // namespace quicksand
