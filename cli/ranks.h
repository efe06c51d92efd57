/// Processes that compute one study together, the ranks of MPI: in `whirl` there is one (alone/ranks.c), in `whirl-mpi`
/// as many as mpirun or srun start (mpi/ranks.c).
///
/// Only the first rank prints. Output of the others is suppressed, except that of a rank whose failure ends all ranks.
#ifndef CLI_RANKS_H
#define CLI_RANKS_H

#include <stddef.h>
#include <stdint.h>

/// Starts the ranks; must be called before anything else. Ends the program on failure.
void ranks_begin(int *argc, char ***argv);

/// Called now and then while a rank waits for others.
typedef void (*ranks_meanwhile)(void);

/// Ends the ranks; must be called after everything else. Returns the exit status of all ranks: the worst one if a rank
/// failed, else that of the first rank.
int ranks_end(int status, ranks_meanwhile meanwhile);

int ranks_count(void);
int ranks_number(void); ///< number of this rank, from 0

/// Continues with the first rank alone: the others only wait for the end.
void ranks_dismiss(void);

/// Returns the default number of threads of a rank: OMP_NUM_THREADS, or its part of the cores of its computer.
int ranks_threads(void);

/// Waits for all ranks, and returns the worst exit status of any. If that is a failure, all ranks must end.
int ranks_agree(int outcome);

/// Waits for all ranks, and copies bytes of the first rank to all.
void ranks_share(void *bytes, size_t size);

/// Number of shared numbers, which all ranks see at any time. They begin at 0; any thread may access them.
enum { RANKS_WORDS = 96 };

/// Adds to shared number `word` and returns its previous value. This takes a millisecond or two on ranks other than the
/// first.
int64_t ranks_add(size_t word, int64_t amount);

/// Adds amounts to `count` shared numbers from `word` on, in one request, and replaces the amounts by the new values.
enum { RANKS_MAX = 8 };
void ranks_add_all(size_t word, size_t count, int64_t *amounts);

/// Raises shared number `word` to `value`, if it is smaller.
void ranks_raise(size_t word, int64_t value);

/// Sleeps for some milliseconds, while waiting.
void ranks_rest(void);

#endif
