#include "app/machine/machine.hpp"

#include "io/results/run_manifest.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace quicksand {

namespace {

/// Of those that kernels are compiled for, see solver/base/lanes.hpp.
const char* widest_vectors()
{
    if (__builtin_cpu_supports("avx512vl")) return "8 doubles (AVX-512)";
    return __builtin_cpu_supports("avx2") ? "4 doubles (AVX2)" : "2 doubles (SSE2)";
}

} // namespace

std::string machine_text()
{
    const std::string processor = processor_name();
    return fmt::format("{}, {} threads, vectors of {}; gcc {}",
                       processor.empty() ? "unknown processor" : processor,
                       std::thread::hardware_concurrency(), widest_vectors(), __VERSION__);
}

double resident_bytes()
{
    malloc_trim(0); // else the next body would stand for nothing on what a former one has left behind
    std::ifstream file("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    file >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace quicksand
