// Files and disk gone wrong: full disk, missing rights, damaged results.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace quicksand {

/// A file could not be written or read. The text names the path, the system's reason and what is still good.
class FileError : public std::runtime_error {
public:
    /// `problem` is what was tried ("cannot write"), `reason` why it failed, `still_good` what can be relied
    /// on ("earlier frames are complete"); the last two may be empty.
    FileError(std::filesystem::path path_, const std::string& problem, const std::string& reason,
              const std::string& still_good);
    std::filesystem::path path;
};

/// The system's text for an errno value, "" for 0.
std::string system_reason(int error_number);

} // namespace quicksand
