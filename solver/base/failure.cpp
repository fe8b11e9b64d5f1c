#include "solver/base/failure.hpp"

#include <sstream>
#include <system_error>
#include <utility>

namespace quicksand {

namespace {

std::string describe(const FailureRecord& record)
{
    std::ostringstream text;
    text.precision(8);
    const bool settling = record.stage == Stage::relaxation;
    text << "the run failed " << (settling ? "while settling, " : "") << "in phase '" << record.phase
         << "' of step " << record.step;
    if (!settling) text << ", t = " << record.time << " s";
    text << ", dt = " << record.time_step << " s: " << record.what;
    if (record.identifier >= 0) {
        text << "\n  particle " << record.identifier << " at (" << record.position.x() << ", "
             << record.position.y() << ") m";
    }
    if (!record.causes.empty()) text << "\n  likely causes: " << record.causes;
    return text.str();
}

std::string complete_text(const std::filesystem::path& path, const std::string& problem,
                          const std::string& reason, const std::string& still_good)
{
    std::string text = path.string() + ": " + problem;
    if (!reason.empty()) text += ": " + reason;
    if (!still_good.empty()) text += "; " + still_good;
    return text;
}

} // namespace

NumericalError::NumericalError(FailureRecord record_)
    : std::runtime_error(describe(record_)), record(std::move(record_))
{
}

FileError::FileError(std::filesystem::path path_, const std::string& problem, const std::string& reason,
                     const std::string& still_good)
    : std::runtime_error(complete_text(path_, problem, reason, still_good)), path(std::move(path_))
{
}

std::string system_reason(int error_number)
{
    return error_number == 0 ? std::string() : std::generic_category().message(error_number);
}

void fail_invariant(const char* expression, std::source_location where)
{
    std::ostringstream text;
    text << "internal error: " << expression << " does not hold in " << where.function_name() << " ("
         << where.file_name() << ":" << where.line() << ")";
    throw InternalError(text.str());
}

} // namespace quicksand
