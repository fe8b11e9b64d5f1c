#include "solver/failure.hpp"

#include <sstream>
#include <utility>

namespace quicksand {

namespace {

std::string describe(const FailureRecord& record)
{
    std::ostringstream text;
    text.precision(8);
    text << "the run went bad in phase '" << record.phase << "' of step " << record.step
         << ", t = " << record.time << " s, dt = " << record.time_step << " s: " << record.what;
    if (record.identifier >= 0) {
        text << "\n  particle " << record.identifier << " at (" << record.position.x() << ", "
             << record.position.y() << ") m";
    }
    if (!record.causes.empty()) text << "\n  likely causes: " << record.causes;
    return text.str();
}

} // namespace

NumericalError::NumericalError(FailureRecord record_)
    : std::runtime_error(describe(record_)), record(std::move(record_))
{
}

void fail_invariant(const char* expression, std::source_location where)
{
    std::ostringstream text;
    text << "internal error: " << expression << " does not hold in " << where.function_name() << " ("
         << where.file_name() << ":" << where.line() << ")";
    throw InternalError(text.str());
}

} // namespace quicksand
