// The report on one run: a page for those who review the assessment of a dike.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace quicksand {

struct ReportRequest {
    std::filesystem::path results;
    std::optional<double> required_height; // y that the crest must keep [m]; none: not judged
    std::string field;                     // of the animation; empty: ru, in a dry scene displacement
    std::function<void(const std::string&)> notify; // told what the page has to do without
};

/// The page as HTML without references to other files: what was run and how it ended, the crest against the
/// required height, section, motion and spectrum, figures, an animation, balances, scene and log, and a
/// reviewer's checklist. Throws InputError where there are no results, or no such field, and FileError.
std::string run_page(const ReportRequest& request);

} // namespace quicksand
