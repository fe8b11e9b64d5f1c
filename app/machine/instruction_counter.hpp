// The processor's own count of what it executes, for benchmarks.
#pragma once

namespace quicksand {

/// Instructions of the thread that makes it, in user mode and from then on.
class InstructionCounter {
public:
    InstructionCounter();
    ~InstructionCounter();
    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;

    /// False where the machine, as most virtual ones, or its settings have no counter for us.
    bool works() const { return file_ >= 0; }

    /// So far [-]; 0 where it does not work.
    double count() const;

private:
    int file_; // of the kernel's event
};

} // namespace quicksand
