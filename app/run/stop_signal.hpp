// Ctrl-C, kill and a closed terminal, asked for at restart points instead of ending the program in the middle
// of a step.
#pragma once

#include <exception>

namespace quicksand {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is remembered, and the first two are answered on
/// standard error; a second SIGINT or SIGTERM ends the program at once.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    static bool received();
};

/// Leaves what is under way, because a stop was asked for.
class StopRequest : public std::exception {
public:
    const char* what() const noexcept override { return "stopped on request"; }
};

} // namespace quicksand
