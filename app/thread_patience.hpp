// How threads wait for each other at the end of a loop.
#pragma once

namespace quicksand {

/// Let waiting threads sleep soon instead of spinning: a step has many short loops, and on a machine with
/// other work a spinning thread keeps the very one that it waits for from running, for a factor of ten in
/// run time. OpenMP's library reads its settings once when it is loaded, so the program starts itself again
/// with them; it does nothing where the user has chosen.
void wait_patiently(char** arguments);

} // namespace quicksand
