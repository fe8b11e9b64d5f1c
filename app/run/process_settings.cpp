#include "app/run/process_settings.hpp"

#include <unistd.h>

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

} // namespace quicksand
