// Questions of those who review the analysis of a dike's deformation.
#pragma once

#include <string>

namespace quicksand {

/// The questions with boxes to tick, as HTML, in the groups of Boulanger and Beaty (2016): ground,
/// calibration, numerical model, motions, results. Where the page or a command answers one, it says so.
std::string review_checklist();

} // namespace quicksand
