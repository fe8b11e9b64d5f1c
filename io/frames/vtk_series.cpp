#include "io/frames/vtk_series.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <charconv>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// Value of attribute="..." in one line of the index, "" when it is missing.
std::string_view attribute(std::string_view line, std::string_view name)
{
    const std::string start = std::string(name) + "=\"";
    const std::size_t begin = line.find(start);
    if (begin == std::string_view::npos) return {};
    const std::string_view rest = line.substr(begin + start.size());
    return rest.substr(0, rest.find('"'));
}

FrameEntry entry_of(std::string_view line, const fs::path& index)
{
    FrameEntry entry;
    const std::string_view time = attribute(line, "timestep");
    const auto parsed = std::from_chars(time.data(), time.data() + time.size(), entry.time);
    entry.file = attribute(line, "file");
    if (parsed.ec != std::errc() || parsed.ptr != time.data() + time.size() || entry.file.empty())
        throw FileError(index, "cannot read the index", "damaged entry: " + std::string(line), "");
    return entry;
}

/// The number in frame_000123.vtu, -1 when there is none.
long frame_number(const fs::path& file)
{
    const std::string name = file.stem().string();
    long number = -1;
    const std::size_t digits = name.find('_') + 1;
    std::from_chars(name.data() + digits, name.data() + name.size(), number);
    return number;
}

} // namespace

bool is_frame_file(const fs::path& file)
{
    const std::string name = file.filename().string();
    return name.starts_with("frame_") && (name.ends_with(".vtu") || name.ends_with(".vtu.tmp"));
}

std::vector<FrameEntry> read_series_index(const fs::path& index)
{
    if (!fs::exists(index))
        throw InputError(index.string() + ": there is no such series. Is this the results folder of a run?");
    const std::string text = read_text(index);
    if (text.find("</VTKFile>") == std::string::npos)
        throw FileError(index, "cannot read the index", "it is cut off or not a .pvd file", "");
    std::vector<FrameEntry> entries;
    std::size_t place = text.find("<DataSet");
    while (place != std::string::npos) {
        const std::size_t end = text.find('>', place);
        entries.push_back(entry_of(std::string_view(text).substr(place, end - place), index));
        place = text.find("<DataSet", end);
    }
    return entries;
}

void write_series_index(const fs::path& index, const std::vector<FrameEntry>& entries)
{
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
                       "  <Collection>\n";
    for (const FrameEntry& entry : entries)
        text += fmt::format("    <DataSet timestep=\"{:.17g}\" part=\"0\" file=\"{}\"/>\n", entry.time,
                            entry.file.generic_string());
    text += "  </Collection>\n</VTKFile>\n";
    write_atomically(index, text);
}

VtkSeries::VtkSeries(fs::path index) : VtkSeries(std::move(index), {}) {}

VtkSeries::VtkSeries(fs::path index, std::vector<FrameEntry> entries)
    : index_(std::move(index)), entries_(std::move(entries))
{
    const fs::path folder = fs::path(index_).replace_extension();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder", error.message(), "");
    // The index first: a kill in between leaves frames without an entry, never entries without a frame.
    write_series_index(index_, entries_);
    remove_stray_frames();
}

VtkSeries VtkSeries::resume(fs::path index, double time)
{
    // A run that stopped before its first frame may have no index yet.
    std::vector<FrameEntry> kept;
    if (fs::exists(index)) kept = read_series_index(index);
    std::erase_if(kept, [&](const FrameEntry& entry) { return entry.time > time; });
    return VtkSeries(std::move(index), std::move(kept));
}

void VtkSeries::append(const Frame& frame)
{
    const long number = entries_.empty() ? 0 : frame_number(entries_.back().file) + 1;
    const fs::path folder = fs::path(index_).replace_extension();
    const fs::path file = folder.filename() / fmt::format("frame_{:06}.vtu", number);
    write_frame(index_.parent_path() / file, frame);
    entries_.push_back({frame.time, file});
    write_series_index(index_, entries_);
}

void VtkSeries::remove_stray_frames() const
{
    std::set<fs::path> wanted;
    for (const FrameEntry& entry : entries_) wanted.insert(entry.file.filename());
    std::error_code ignored;
    for (const auto& item : fs::directory_iterator(fs::path(index_).replace_extension(), ignored))
        if (is_frame_file(item.path()) && !wanted.contains(item.path().filename()))
            fs::remove(item.path(), ignored);
}

} // namespace quicksand
