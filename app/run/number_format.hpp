// Numbers as people read them in reports: short, with units.
#pragma once

#include <string>

namespace quicksand {

/// Few digits: 0.042, 2.6e-6, 1.9e6.
std::string short_number(double value, int digits = 3);

/// 12s, 3m12s, 2h05m.
std::string duration_text(double seconds);

/// 800 B, 12 kB, 1.3 MB, 2.4 GB.
std::string bytes_text(double bytes);

/// 11,344
std::string grouped(long long count);

/// "1 thread", "2 threads".
std::string threads_text(int count);

} // namespace quicksand
