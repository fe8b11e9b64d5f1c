#include "app/stop_signal.hpp"

#include <csignal>

namespace quicksand {

namespace {

volatile std::sig_atomic_t stop_received = 0;

using Handler = void (*)(int);

void remember_stop(int number)
{
    // A terminal that closes may send several SIGHUP, from its shell and from the system.
    if (stop_received != 0 && number != SIGHUP) {
        std::signal(number, SIG_DFL);
        std::raise(number);
        return;
    }
    stop_received = 1;
}

/// What SIGHUP did before: nohup has it ignored, which stays so.
Handler former_hangup = SIG_DFL;

} // namespace

StopSignal::StopSignal()
{
    stop_received = 0;
    std::signal(SIGINT, remember_stop);
    std::signal(SIGTERM, remember_stop);
    former_hangup = std::signal(SIGHUP, remember_stop);
    if (former_hangup == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

StopSignal::~StopSignal()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, former_hangup);
}

bool StopSignal::received()
{
    return stop_received != 0;
}

} // namespace quicksand
