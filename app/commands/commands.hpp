// The commands of the program: the functions that do them.
#pragma once

#include "app/run/choices.hpp"

#include <string>

namespace quicksand {

ExitCode run_scene(const RunChoice& choice);
ExitCode run_sweep(const SweepChoice& choice);
ExitCode check_scene(const CheckChoice& choice);
ExitCode assess_stability(const StabilityChoice& choice);
ExitCode list_keys(const KeysChoice& choice);
ExitCode run_element_tests(const ElementChoice& choice);
ExitCode examine_motion(const MotionChoice& choice);
ExitCode tell_validity(const ValidityChoice& choice);
ExitCode calibrate_sand(const CalibrateChoice& choice);
ExitCode create_scene(const NewChoice& choice);
ExitCode extract_probe(const ProbeChoice& choice);
ExitCode draw_pictures(const PictureChoice& choice);
ExitCode draw_scene_figures(const FiguresChoice& choice);
ExitCode compare_results(const CompareChoice& choice);
ExitCode write_report(const ReportChoice& choice);
ExitCode run_demo(const DemoChoice& choice);
ExitCode verify_problems(const VerifyChoice& choice);
ExitCode stress_solver(const StressChoice& choice);
ExitCode print_version();

/// Name and version of the program.
std::string version_text();

} // namespace quicksand
