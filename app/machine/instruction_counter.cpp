#include "app/machine/instruction_counter.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace quicksand {

InstructionCounter::InstructionCounter()
{
    perf_event_attr event{};
    event.size = sizeof event;
    event.type = PERF_TYPE_HARDWARE;
    event.config = PERF_COUNT_HW_INSTRUCTIONS;
    event.exclude_kernel = 1;
    event.exclude_hv = 1;
    constexpr int this_thread = 0, any_processor = -1, no_group = -1, no_flags = 0;
    file_ = static_cast<int>(
        syscall(SYS_perf_event_open, &event, this_thread, any_processor, no_group, no_flags));
}

InstructionCounter::~InstructionCounter()
{
    if (works()) close(file_);
}

double InstructionCounter::count() const
{
    std::uint64_t instructions = 0;
    if (!works() || read(file_, &instructions, sizeof instructions) != sizeof instructions) return 0.0;
    return static_cast<double>(instructions);
}

} // namespace quicksand
