// What a measurement was made on, and what the process holds of its memory.
#pragma once

#include <string>

namespace quicksand {

/// Processor, its threads, and the compiler: one line for tables of measurements.
std::string machine_text();

/// Memory of this process that is resident now, less what has been freed [byte]; 0 where the system does not
/// tell.
double resident_bytes();

} // namespace quicksand
