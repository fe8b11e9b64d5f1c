#include "app/stop_signal.hpp"

#include <csignal>

namespace quicksand {

namespace {

volatile std::sig_atomic_t stop_received = 0;

void remember_stop(int number)
{
    if (stop_received != 0) {
        std::signal(number, SIG_DFL);
        std::raise(number);
        return;
    }
    stop_received = 1;
}

} // namespace

StopSignal::StopSignal()
{
    stop_received = 0;
    std::signal(SIGINT, remember_stop);
    std::signal(SIGTERM, remember_stop);
}

StopSignal::~StopSignal()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool StopSignal::received()
{
    return stop_received != 0;
}

} // namespace quicksand
