// A scene as the user wrote it, checked and in SI units: plain data, no files, no gmsh.
#pragma once

#include "io/keys/source_place.hpp"
#include "io/tables/scene_stage.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/slip_strength.hpp"
#include "solver/run/staged_run.hpp"
#include "solver/verification/studies/study.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace quicksand {

struct LatticeSampling {
    int per_cell_x = 3; // particles per cell [-]
    int per_cell_y = 3;
};

struct MeshSampling {
    double quad_size = 0.0; // edge length of the quadrilaterals; 0: a third of a chosen cell [m]
};

struct SceneMaterial {
    Material material;
    double saturation_above_water =
        0.0; // fraction of the pores filled with water above the phreatic line [-]
    SourcePlace place;
};

struct SceneRegion {
    std::string name;     // physical surface
    std::string material; // name of a material
    SourcePlace place;
};

/// How two regions slide on each other, see solver/problem/slip_strength.hpp.
struct SceneInterface {
    std::string name;
    std::array<std::string, 2> regions;
    SlipStrength strength;                // without a ratio
    std::optional<double> strength_ratio; // of the soil's own tan(phi) and c [-]
    std::optional<double> thickness;      // of the soil that slides; none: chosen by the grid [m]
    SourcePlace place, regions_place, strength_place, thickness_place;
};

struct SceneBoundary {
    Boundary boundary; // of a physical curve, whose segments the drawing has
    SourcePlace place;
    SourcePlace water_place = {}; // of its head or pore pressure
    bool water_goes_on = false;   // begins as it has become in a stage before
};

enum class ProbeKind {
    material, // rides with the particle nearest to the point
    fixed,    // a point in space; empty where there is no soil
    surface,  // the highest soil at an x
    profile,  // points along a line from `at` to `to`
};

struct SceneProbe {
    std::string name;
    ProbeKind kind = ProbeKind::material;
    std::optional<Vector2> at; // [m]; none: the physical point of the probe's name
    std::optional<Vector2> to; // end of a profile [m]
    int points = 21;           // of a profile [-]
    SourcePlace place;
    std::optional<std::int32_t> rider = std::nullopt; // of a material probe: drawn nearest to its place
};

struct SceneOutput {
    double frame_interval = 0.0;      // between fields.pvd frames [s]
    double probe_interval = 0.0;      // between probe rows [s]
    double history_interval = 0.0;    // between history.csv and steps.csv rows [s]
    double checkpoint_interval = 0.0; // between checkpoints [s of wall time]
};

/// What `verify` is to measure on the scene, and how good it has to be.
struct SceneVerification {
    std::string problem;               // name of a study
    StudyParameters parameters;        // of the study
    double length = 0.0;               // along which cells are counted [m]
    std::vector<int> cells;            // along it, one run each, coarse to fine [-]
    std::vector<int> short_cells;      // of the shortened verification, some of `cells` [-]
    std::vector<std::string> one_cell; // parameters of the drawing that are one cell long
    std::map<std::string, std::vector<double>>
        limits;                                    // largest error by quantity, one for each of `cells` [-]
    std::map<std::string, double> orders;          // least order by quantity [-]
    SourcePlace place, limits_place, orders_place; // of the table and of two of its keys
};

struct Scene {
    std::filesystem::path file;
    std::string text; // as read, for the manifest's hash and the copy in the results
    std::string title;

    std::filesystem::path geometry_file; // resolved against the scene's folder
    std::map<std::string, double> geometry_parameters;
    SourcePlace geometry_place;

    double cell_size = 0.0;                        // h; 0: chosen for the section [m]
    std::optional<Vector2> grid_origin;            // none: chosen for the section [m]
    std::optional<std::pair<int, int>> grid_cells; // none: what covers the section, plus room
    SourcePlace grid_place;                        // of [grid], or else of the drawing's name
    std::variant<LatticeSampling, MeshSampling> sampling;

    Interpolation interpolation = Interpolation::cpdi;
    StrainForm strain = StrainForm::large;
    std::optional<TimeScheme> scheme; // none: the fastest one
    double step_fraction = 1.0;       // of the stable time step [-]
    ColumnsComputed columns = ColumnsComputed::one;

    double gravity = standard_gravity;  // [m/s2]
    std::optional<Water> water;         // none: a dry scene
    std::vector<Vector2> phreatic_line; // in the soil, left to right; none: the water level [m]
    SourcePlace phreatic_place;
    bool starts_seeping = false; // the initial pore pressures are those of a steady flow
    SourcePlace flow_place;      // of the key that says so
    std::vector<SceneMaterial> materials;
    std::vector<SceneRegion> regions;
    std::vector<SceneInterface> interfaces;
    std::vector<SceneBoundary> boundaries;
    double k0 = 0.5;                              // sigma'_h / sigma'_v of the initial state [-]
    double excess_pore_pressure = 0.0;            // everywhere at the start of the run [Pa]
    std::optional<RelaxationControls> relaxation; // none: start from the K0 state as it is
    BaseMotion base_motion;
    std::vector<SceneProbe> probes;
    double end_time = 0.0;           // [s]
    std::optional<SceneStage> stage; // none: the scene has no stages
    SceneOutput output;
    std::optional<SceneVerification> verification; // none: no problem with a known solution
    std::vector<std::string> accepted;             // key paths whose warnings the user has accepted
};

} // namespace quicksand
