#include "io/motions/motion_csv.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "solver/problem/motion_processing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace quicksand {

namespace {

void add_line(std::string& text, const std::vector<double>& values)
{
    CsvRow cells;
    for (const double value : values) cells.push_back(csv_number(value));
    text += fmt::format("{}\n", fmt::join(cells, ","));
}

/// k intervals without the digits of rounding: 0.015, not 0.015000000000000001.
double time_of(const SampledMotion& motion, std::size_t k)
{
    return csv_value(fmt::format("{:.12g}", motion.interval * static_cast<double>(k)));
}

} // namespace

void write_record_csv(const std::filesystem::path& path, const SampledMotion& motion,
                      const std::vector<std::string>& comments)
{
    std::string text = csv_header(comments, {"time_s", "acceleration_m_s2"});
    for (std::size_t k = 0; k < motion.accelerations.size(); ++k)
        add_line(text, {time_of(motion, k), motion.accelerations[k]});
    write_atomically(path, text);
}

void write_histories_csv(const std::filesystem::path& path, const SampledMotion& motion,
                         const std::vector<std::string>& comments)
{
    const MotionHistories histories = histories_of(motion);
    std::string text =
        csv_header(comments, {"time_s", "acceleration_m_s2", "velocity_m_s", "displacement_m"});
    for (std::size_t k = 0; k < motion.accelerations.size(); ++k)
        add_line(text, {time_of(motion, k), motion.accelerations[k], histories.velocities[k],
                        histories.displacements[k]});
    write_atomically(path, text);
}

void write_spectrum_csv(const std::filesystem::path& path, const std::vector<OscillatorPeaks>& spectrum,
                        const std::vector<std::string>& comments)
{
    std::string text = csv_header(comments, {"period_s", "pseudo_acceleration_m_s2", "pseudo_velocity_m_s",
                                             "displacement_m", "velocity_m_s", "absolute_acceleration_m_s2"});
    for (const OscillatorPeaks& peaks : spectrum)
        add_line(text, {peaks.period, peaks.pseudo_acceleration(), peaks.pseudo_velocity(),
                        peaks.displacement, peaks.velocity, peaks.absolute_acceleration});
    write_atomically(path, text);
}

} // namespace quicksand
