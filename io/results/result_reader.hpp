// Reading results back: particle frames for pictures, and histories at a point from the written frames.
#pragma once

#include "io/frames/vtk_series.hpp"
#include "io/tables/scene.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace quicksand {

/// The particles of one frame of fields.pvd.
struct ParticleFrame {
    double time = 0.0;                         // [s]
    std::vector<std::vector<Vector2>> domains; // their corners, counter-clockwise [m]
    std::map<std::string, std::vector<double>>
        scalars;                              // one value a domain; "displacement_x", "stress_xy", "ru"
    std::map<std::string, std::string> units; // of `scalars`
    std::vector<std::string> material_names;  // behind the numbers of scalars["material"]
    std::vector<std::string> region_names;    // behind the numbers of scalars["region"]
};

/// Read a frame file of fields.pvd. Throws FileError.
ParticleFrame read_particle_frame(const std::filesystem::path& file);

/// The frames of fields.pvd with their whole paths, one at least. Throws InputError where there is none,
/// FileError.
std::vector<FrameEntry> particle_frames(const std::filesystem::path& results);

/// The first of them.
ParticleFrame read_first_frame(const std::filesystem::path& results);

/// The frame from which the displacements of the results count: their first one, or where a stage goes on
/// with displacements, the first one of the latest stage before it that began without. Throws FileError, and
/// InputError where there is no frame yet.
ParticleFrame read_frame_of_origin(const std::filesystem::path& results);

/// Say that results have no field of that name, and which they have. Throws InputError.
[[noreturn]] void refuse_field(const std::string& name, const std::vector<std::string>& known);

/// What to take from the frames, and where.
struct ExtractRequest {
    Vector2 at = Vector2::Zero();      // [m]
    std::vector<std::string> fields;   // "ru", "displacement" (all its components) or "displacement_y"
    ProbeKind kind = ProbeKind::fixed; // fixed: from grid.pvd; material: from fields.pvd
};

/// A table of histories: rows[k][c] is column c at the k-th frame, NaN where there is no soil or no value.
struct HistoryTable {
    std::vector<std::string> columns; // "time_s", then "name_unit"
    std::vector<std::vector<double>> rows;
};

/// Histories at a point. A fixed point interpolates in the grid; a material point rides with the particle
/// whose place at the start was nearest. Throws InputError for an unknown field or a point that never was in
/// the soil.
HistoryTable extract_history(const std::filesystem::path& results, const ExtractRequest& request);

/// Write the table as CSV; values that are NaN are empty cells. Throws FileError.
void write_history_table(const std::filesystem::path& path, const HistoryTable& table);

} // namespace quicksand
