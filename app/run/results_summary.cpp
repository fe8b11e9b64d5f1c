#include "app/run/results_summary.hpp"

#include "app/run/number_format.hpp"
#include "io/pictures/picture_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace quicksand {

namespace {

/// Largest value of a column, NaN without values.
double largest(const PictureTable& table, const char* column)
{
    const std::vector<double>* values = table.find(column);
    double result = std::nan("");
    if (values == nullptr) return result;
    for (const double value : *values) {
        if (!std::isnan(value)) result = std::isnan(result) ? value : std::max(result, value);
    }
    return result;
}

double last(const PictureTable& table, const char* column)
{
    const std::vector<double>* values = table.find(column);
    return values == nullptr || values->empty() ? std::nan("") : values->back();
}

std::string cell(double value, double factor)
{
    return std::isnan(value) ? "-" : short_number(factor * value);
}

std::string probe_row(const std::filesystem::path& file)
{
    const PictureTable table = read_picture_table(file);
    return fmt::format("  {:<16}{:>16}{:>12}{:>14}{:>14}\n", file.stem().string(),
                       cell(largest(table, "excess_pore_pressure_Pa"), 1e-3), cell(largest(table, "ru"), 1.0),
                       cell(last(table, "ux_m"), 1e3), cell(last(table, "uy_m"), 1e3));
}

} // namespace

std::string summarize_probes(const ResultsFolder& folder)
{
    std::string text;
    std::vector<std::filesystem::path> files;
    const std::filesystem::path probes = folder.directory / "probes";
    if (std::filesystem::is_directory(probes)) {
        for (const auto& item : std::filesystem::directory_iterator(probes)) {
            if (item.path().extension() == ".csv") files.push_back(item.path());
        }
    }
    std::sort(files.begin(), files.end());
    if (!files.empty()) {
        text += fmt::format("  {:<16}{:>16}{:>12}{:>14}{:>14}\n", "probe", "peak excess kPa", "ru max",
                            "final ux mm", "final uy mm");
    }
    for (const std::filesystem::path& file : files) text += probe_row(file);
    if (std::filesystem::exists(folder.history())) {
        const double settlement = last(read_picture_table(folder.history()), "crest_settlement_m");
        text += fmt::format("  crest settlement {} mm", cell(settlement, 1e3));
    }
    return text;
}

std::string describe_files(const ResultsFolder& folder)
{
    const std::filesystem::path& directory = folder.directory;
    return fmt::format("Open in ParaView:\n"
                       "  {}   the soil, every particle with its own shape\n"
                       "  {}   the same as connected fields, for Probe and Plot Over Line\n"
                       "Open in a spreadsheet or gnuplot:\n"
                       "  {}   histories at the probes\n"
                       "  {}   crest settlement, energies, extremes",
                       folder.particle_series().string(), folder.grid_series().string(),
                       (directory / "probes" / "*.csv").string(), folder.history().string());
}

} // namespace quicksand
