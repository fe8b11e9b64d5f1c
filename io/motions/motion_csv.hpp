// A motion as tables: the record itself, its histories and its response spectrum.
#pragma once

#include "solver/problem/response_spectrum.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// Time and acceleration in m/s2, as a scene reads a record. `comments` stand above them. Throws FileError.
void write_record_csv(const std::filesystem::path& path, const SampledMotion& motion,
                      const std::vector<std::string>& comments);

/// Acceleration, velocity and displacement over time. Throws FileError.
void write_histories_csv(const std::filesystem::path& path, const SampledMotion& motion,
                         const std::vector<std::string>& comments);

/// The peaks of oscillators over their period. Throws FileError.
void write_spectrum_csv(const std::filesystem::path& path, const std::vector<OscillatorPeaks>& spectrum,
                        const std::vector<std::string>& comments);

} // namespace quicksand
