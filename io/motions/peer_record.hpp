// Acceleration records in the AT2 form of the PEER strong motion databases.
//
// A few lines of text, one of which states the unit ("... IN UNITS OF G"), then the line with the number of
// values and their interval, in any of these forms, then the values, any number a line:
//   NPTS=  4000, DT= .01000 SEC
//   NPTS=   1215, dt=  .02000
//   4096    0.0100    NPTS, DT
#pragma once

#include "io/keys/diagnostics.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

struct PeerRecord {
    std::string unit_name;             // as the header writes it: "G"
    double unit = 0.0;                 // one of it [m/s2]
    double interval = 0.0;             // between the values [s]
    std::vector<double> accelerations; // [m/s2]
};

/// Whether the file's name ends with .at2 or its first lines hold a header of this form.
bool is_peer_record(const std::filesystem::path& file, std::string_view text);

/// What the text holds. What is wrong is added to `findings` at its place in the file, with the line to
/// quote; then the result is empty.
std::optional<PeerRecord> parse_peer_record(const std::filesystem::path& file, std::string_view text,
                                            Diagnostics& findings);

} // namespace quicksand
