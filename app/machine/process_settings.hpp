// What libraries read from the environment once, when they are loaded, and what becomes of failed writes.
#pragma once

namespace quicksand {

/// Start the program again with settings for OpenMP's and C's libraries, but for those the user has chosen;
/// does nothing where they are made, or with QUICKSAND_STARTED_AGAIN in the environment, as under programs
/// that watch a process and take settings from it.
///
/// Waiting threads sleep soon instead of spinning: a step has many short loops, and on a machine with other
/// work a spinning thread keeps the very one that it waits for from running, for a factor of ten in run time.
/// Memory comes in pages of 2 MB where the system has them, for looking up small ones takes a sixth of a step
/// of 300,000 particles and more, and from one arena: those of several threads keep a tenth of it unused.
void apply_process_settings(char** arguments);

/// Let a write into a pipe whose reader has left (SIGPIPE), or beyond the size that a file may have (SIGXFSZ,
/// ulimit -f), fail as on a full disk instead of ending the program in the middle of its work.
void let_writes_fail();

/// Whether standard output is a pipe whose reader has left, as `| head -1` does.
bool reader_has_left();

} // namespace quicksand
