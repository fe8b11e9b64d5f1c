#include "io/file_error.hpp"

#include <system_error>
#include <utility>

namespace quicksand {

namespace {

std::string complete_text(const std::filesystem::path& path, const std::string& problem,
                          const std::string& reason, const std::string& still_good)
{
    std::string text = path.string() + ": " + problem;
    if (!reason.empty()) text += ": " + reason;
    if (!still_good.empty()) text += "; " + still_good;
    return text;
}

} // namespace

FileError::FileError(std::filesystem::path path_, const std::string& problem, const std::string& reason,
                     const std::string& still_good)
    : std::runtime_error(complete_text(path_, problem, reason, still_good)), path(std::move(path_))
{
}

std::string system_reason(int error_number)
{
    return error_number == 0 ? std::string() : std::generic_category().message(error_number);
}

} // namespace quicksand
