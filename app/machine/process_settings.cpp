#include "app/machine/process_settings.hpp"

#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace quicksand {

namespace {

constexpr const char* spins = "1000"; // some microseconds, what a loop of balanced threads takes to end
constexpr const char* memory = "glibc.malloc.hugetlb=1:glibc.malloc.arena_max=1";
constexpr const char* started_again = "QUICKSAND_STARTED_AGAIN";

bool is_set(const char* name)
{
    return std::getenv(name) != nullptr;
}

} // namespace

void apply_process_settings(char** arguments)
{
    if (is_set(started_again)) return; // whatever has become of the settings: never twice
    const bool waits_as_chosen = is_set("GOMP_SPINCOUNT") || is_set("OMP_WAIT_POLICY");
    const bool memory_as_chosen = is_set("GLIBC_TUNABLES");
    if (waits_as_chosen && memory_as_chosen) return;
    if (!waits_as_chosen && setenv("GOMP_SPINCOUNT", spins, 0) != 0) return;
    if (!memory_as_chosen && setenv("GLIBC_TUNABLES", memory, 0) != 0) return;
    if (setenv(started_again, "1", 0) != 0) return;
    // Comes back only when it fails; then the run goes on as it is.
    execv("/proc/self/exe", arguments);
}

void let_writes_fail()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

bool reader_has_left()
{
    pollfd output{STDOUT_FILENO, 0, 0};
    return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

} // namespace quicksand
