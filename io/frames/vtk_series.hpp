// A time series for ParaView: an index file name.pvd and its frames name/frame_000123.vtu.
//
// A frame gets its name when it is complete, and the index its entry after that. So the series is readable at
// any moment, also after a kill or on a full disk.
#pragma once

#include "io/frames/vtk_frame.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace quicksand {

/// One entry of an index file.
struct FrameEntry {
    double time = 0.0;          // [s]
    std::filesystem::path file; // relative to the index file's folder
};

/// The entries of a .pvd file, in its order. Throws InputError when there is none, FileError when it is
/// damaged.
std::vector<FrameEntry> read_series_index(const std::filesystem::path& index);

/// Write a .pvd file with these entries, replacing a former one as a whole. Throws FileError.
void write_series_index(const std::filesystem::path& index, const std::vector<FrameEntry>& entries);

/// Whether the file has the name of a frame, complete or under way.
bool is_frame_file(const std::filesystem::path& file);

class VtkSeries {
public:
    /// A new series, empty until the first frame. `index` ends in .pvd; frames go to the folder of its stem.
    explicit VtkSeries(std::filesystem::path index);

    /// The series as it was at `time`: later entries and frames that have none are removed.
    static VtkSeries resume(std::filesystem::path index, double time);

    /// Write a frame and give it its entry. Throws FileError.
    void append(const Frame& frame);

    const std::vector<FrameEntry>& entries() const { return entries_; }

private:
    VtkSeries(std::filesystem::path index, std::vector<FrameEntry> entries);
    void remove_stray_frames() const;

    std::filesystem::path index_;
    std::vector<FrameEntry> entries_;
};

} // namespace quicksand
