#include "app/run/stop_signal.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace quicksand {

namespace {

volatile std::sig_atomic_t stop_received = 0;

using Handler = void (*)(int);

/// Calls only what a signal handler may call.
void tell_of_stop()
{
    constexpr char text[] =
        "\nStopping at the next restart point, a few dozen steps on at most. A second Ctrl-C "
        "or kill ends the run at once.\n";
    const int former_error = errno;
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof(text) - 1);
    errno = former_error;
}

void remember_stop(int number)
{
    // A terminal that closes may send several SIGHUP, from its shell and from the system.
    if (stop_received != 0 && number != SIGHUP) {
        std::signal(number, SIG_DFL);
        std::raise(number);
        return;
    }
    stop_received = 1;
    if (number != SIGHUP) tell_of_stop(); // a closed terminal shows nothing
}

/// What SIGHUP did before: nohup has it ignored, which stays so.
Handler former_hangup = SIG_DFL;

int signals_alive = 0;

} // namespace

StopSignal::StopSignal()
{
    if (signals_alive++ > 0) return;
    stop_received = 0;
    std::signal(SIGINT, remember_stop);
    std::signal(SIGTERM, remember_stop);
    former_hangup = std::signal(SIGHUP, remember_stop);
    if (former_hangup == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

StopSignal::~StopSignal()
{
    if (--signals_alive > 0) return;
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, former_hangup);
}

bool StopSignal::received()
{
    return stop_received != 0;
}

} // namespace quicksand
