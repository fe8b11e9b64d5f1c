// When threads pay.
#pragma once

#include <cstddef>

namespace quicksand {

/// Work on fewer particles or nodes than this stays on one thread: starting and joining the others costs more
/// than they save, much more on a machine that is busy with other work [-].
inline constexpr std::size_t least_parallel_work = 2000;

} // namespace quicksand
