#include "app/machine.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace quicksand {

namespace {

std::string processor_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

} // namespace

std::string machine_text()
{
    return fmt::format("{}, {} threads, vectors of {}; gcc {}", processor_name(),
                       std::thread::hardware_concurrency(),
                       __builtin_cpu_supports("avx2") ? "4 doubles (AVX2)" : "2 doubles (SSE2)", __VERSION__);
}

double resident_bytes()
{
    std::ifstream file("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    file >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace quicksand
