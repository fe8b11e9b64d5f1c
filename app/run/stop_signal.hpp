// Ctrl-C, kill and a closed terminal, asked for at restart points instead of ending the program in the middle
// of a step.
#pragma once

namespace quicksand {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is remembered, and the first two are answered on
/// standard error; a second SIGINT or SIGTERM ends the program at once. One within the life of another
/// changes nothing.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    static bool received();
};

} // namespace quicksand
