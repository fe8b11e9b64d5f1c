// The kinds of failure: the user's input (InputError), a run that failed (NumericalError), files and disk
// (FileError) and our own bug (ENSURE).
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/base/stage.hpp"

#include <cstdint>
#include <filesystem>
#include <source_location>
#include <stdexcept>
#include <string>

namespace quicksand {

/// The user's input cannot be run. The text is complete: place, what is wrong, what is allowed, a hint.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What helps a run that went bad from its last restart point on.
enum class Remedy : std::uint8_t {
    shorter_steps,
    explicit_steps // of a semi-implicit run: they do not damp the sound of the water
};

/// Where and why a run failed.
struct FailureRecord {
    std::string phase;                  // phase of the step, e.g. "gather"
    std::string what;                   // what was found, with the numbers
    std::string causes;                 // likely causes, the most likely first
    Stage stage = Stage::shaking;       // time counts in the shaking alone
    std::int64_t step = 0;              // step number [-]
    double time = 0.0;                  // t [s]
    double time_step = 0.0;             // dt [s]
    std::int64_t identifier = -1;       // the particle's lasting number [-], -1 when no particle is involved
    Vector2 position = Vector2::Zero(); // [m]
    Remedy remedy = Remedy::shorter_steps;
};

/// Why a run becomes unstable, the most likely cause first.
inline constexpr const char* causes_of_instability =
    "the time step is too long (a smaller analysis.step_share shows it); a wall or a side is held or "
    "moved "
    "in "
    "a way that the step does not bear (look at the last good frame for the place where it began); a "
    "material parameter or a load is far from what the soil can carry";

/// The run went bad: the state is no longer meaningful and nothing of it should be written.
class NumericalError : public std::runtime_error {
public:
    explicit NumericalError(FailureRecord record_);
    FailureRecord record;
};

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

/// Our own bug: an invariant of the program does not hold.
class InternalError : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

[[noreturn]] void fail_invariant(const char* expression, std::source_location where);

} // namespace quicksand

/// Check an invariant of the program; a violation is our bug, never the user's.
#define ENSURE(expression)                                                                                   \
    (static_cast<bool>(expression)                                                                           \
         ? void(0)                                                                                           \
         : quicksand::fail_invariant(#expression, std::source_location::current()))
