#include "app/thread_patience.hpp"

#include <unistd.h>

#include <cstdlib>

namespace quicksand {

namespace {

constexpr const char* spins = "1000"; // some microseconds, what a loop of balanced threads takes to end

} // namespace

void wait_patiently(char** arguments)
{
    if (std::getenv("GOMP_SPINCOUNT") != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
    if (setenv("GOMP_SPINCOUNT", spins, 0) != 0) return;
    // Comes back only when it fails; then the run goes on as it is.
    execv("/proc/self/exe", arguments);
}

} // namespace quicksand
