// Choices of the command line, and exit codes.
#pragma once

#include "solver/base/conventions.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Exit codes, fixed for scripts.
enum class ExitCode {
    good = 0,
    input = 2,      // the user's input cannot be run
    numerical = 3,  // the run failed
    files = 4,      // files, disk or memory
    bug = 5,        // our own
    inaccurate = 6, // verify: an error or an order misses its limit
};

/// A scene and what the command line changes of it.
struct SceneChoice {
    std::filesystem::path scene;        // a file, or a folder with scene.toml
    std::vector<std::string> overrides; // --set key=value
    std::optional<double> until;        // end of the run in place of the scene's [s]
    int threads = 0;                    // 0: all of the machine's [-]
};

struct RunChoice {
    SceneChoice scene;
    std::filesystem::path directory; // empty: results/<name of the scene>
    std::string from;                // RESULTS[:STAGE] to go on from; empty: the state as drawn
    bool overwrite = false;
    bool resume = false;
    bool go_on = false; // with what the folder holds of the same run, else from the start
};

struct SweepChoice {
    std::filesystem::path file;      // of the sweep, or a folder with sweep.toml
    std::filesystem::path directory; // empty: results/<name of the file>
    std::string from;                // RESULTS[:STAGE] that all runs go on from; empty: from the drawing
    int jobs = 1;                    // runs at a time
    int threads = 0;                 // of a run, 0: the machine's over the jobs, on other machines 1
    std::string engine = "local";    // or "parallel", "slurm", "snakemake"
    bool collect = false;            // only make tables and pictures of what is there
    bool dry_run = false;            // only list the runs
};

struct CheckChoice {
    SceneChoice scene;
    std::filesystem::path directory; // empty: results/<name of the scene>-check
};

struct StabilityChoice {
    SceneChoice scene;
    std::filesystem::path directory;  // empty: results/<name of the scene>-stability
    double tolerance = 0.005;         // width of the bracket over the factor of safety [-]
    double seismic_coefficient = 0.0; // k_h, horizontal force towards +x over weight [-]
    double residual_strength = 0.0;   // S_r / sigma'_v0 of liquefied sand, 0: as its stresses allow [-]
    double liquefied_ru = 0.8;        // least ru of liquefied sand [-]
};

struct KeysChoice {
    std::string pattern; // part of a key, empty: all
    bool markdown = false;
    bool of_element_tests = false; // instead of a scene's
    bool of_results = false;       // the quantities in results instead of keys
};

struct ElementChoice {
    std::filesystem::path file;         // of tests, or a folder with test.toml
    std::vector<std::string> overrides; // --set key=value
    std::filesystem::path directory;    // empty: results/<name of the file>
};

/// What is done to a record happens in the order of the members.
struct MotionChoice {
    std::filesystem::path file;
    std::string unit;                // "g" or "m/s2"; empty: as the record states
    std::string trim;                // FROM:TO in s, empty: all of it
    std::string baseline = "none";   // or "linear"
    double low_cut = 0.0;            // 0: none [Hz]
    double high_cut = 0.0;           // 0: none [Hz]
    std::string peak;                // with its unit, empty: as it is
    double damping = 5.0;            // of the spectrum [%]
    std::filesystem::path directory; // empty: results/<name of the file>-motion
};

struct ValidityChoice {
    std::filesystem::path file;         // of element tests
    std::vector<std::string> overrides; // --set key=value
};

struct CalibrateChoice {
    std::filesystem::path file, data;   // of element tests; points of cyclic strength
    std::vector<std::string> keys;      // of the material that are fitted
    std::vector<std::string> overrides; // --set key=value
};

struct NewChoice {
    std::string example; // "dike" or "column"
    std::filesystem::path folder;
};

struct ProbeChoice {
    std::filesystem::path results;
    Vector2 at = Vector2::Zero(); // [m]
    std::vector<std::string> fields;
    bool rides_with_soil = false;
    std::filesystem::path file;
};

struct PictureChoice {
    std::filesystem::path results;
    std::filesystem::path output; // .png file or folder, empty: RESULTS/pictures
    std::string field;            // empty: the usual set
    std::optional<double> time;   // none: the last frame [s]
    std::string range;            // of the colours as LOW:HIGH, empty: automatic
    double exaggeration = 1.0;    // of the displacements [-]
};

struct FiguresChoice {
    std::filesystem::path source;  // results folder, or a scene whose results lie in the usual place
    std::filesystem::path results; // of the scene, empty: results/<name of the scene>
    std::filesystem::path output;  // folder, empty: RESULTS/figures
};

struct CompareChoice {
    std::vector<std::filesystem::path> results;
    std::string field;          // of the difference of two frames, empty: the usual ones
    std::optional<double> time; // of these frames, none: the last ones [s]
    std::filesystem::path directory = "results/compare";
};

struct ReportChoice {
    std::filesystem::path results;
    std::optional<double> required_height; // y that the crest must keep [m]
    std::string field;                     // of the animation, empty: ru, in a dry scene displacement
    std::filesystem::path output;          // empty: RESULTS/report.html
};

struct DemoChoice {
    std::filesystem::path directory = "results/demo";
    int threads = 0;
};

struct VerifyChoice {
    std::vector<std::string> problems;  // names in examples/verification, scene files or folders; empty: all
    std::vector<std::string> overrides; // --set key=value
    bool shortened = false;
    std::filesystem::path directory = "results/verification";
    int threads = 0; // runs at the same time, 0: as many as the machine has threads [-]
};

struct BenchChoice {
    std::vector<std::string> words;     // scenes, or problems of verify; empty: what comes with the program
    std::vector<std::string> overrides; // --set key=value
    std::filesystem::path directory = "results/bench";
    std::optional<double> until; // end of the runs of scenes in place of theirs [s]
    int threads = 0;             // 0: as the benchmark is usually taken [-]
    double largest = 3e6;        // of `scale` [particles]
};

struct StressChoice {
    std::vector<std::string> rows; // what the names of the rows to run begin with; empty: all
    std::string row;               // run this one alone in this process; empty: as above
    int random_scenes = 500;
    std::uint64_t seed = 1; // of the random scenes
    bool long_ones = false; // also rows that take minutes
    double limit = 120.0;   // wall time of one row [s]
    std::filesystem::path directory = "results/stress";
    int threads = 0; // rows at the same time, 0: as many as the machine has threads [-]
};

} // namespace quicksand
