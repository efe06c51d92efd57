/// Processes that compute one study together, the ranks of MPI: in `whirl` there is one (alone/ranks.c), in `whirl-mpi`
/// as many as mpirun or srun start (mpi/ranks.c).
///
/// Only the first one prints. Output of others is suppressed, except that of a rank whose failure ends all of them.
#ifndef CLI_RANKS_H
#define CLI_RANKS_H

#include <stddef.h>
#include <stdint.h>

/// Starts the ranks, before anything else; ends the program on failure.
void ranks_begin(int *argc, char ***argv);

/// Called now and then while a rank waits for others.
typedef void (*ranks_meanwhile)(void);

/// After everything else: gives the exit status of all ranks. That is the worst one of a failure, else the first
/// rank's.
int ranks_end(int status, ranks_meanwhile meanwhile);

int ranks_count(void);
int ranks_number(void); ///< from 0

/// Continues with the first rank alone: the others only end.
void ranks_dismiss(void);

/// Threads that a rank may well use: its part of the cores of its computer, or OMP_NUM_THREADS.
int ranks_threads(void);

/// Waits for all ranks; gives the worst outcome of any (an exit status). When that is a failure, all ranks are to end.
int ranks_agree(int outcome);

/// Waits for all ranks, and copies bytes of the first one to all.
void ranks_share(void *bytes, size_t size);

/// Numbers that all ranks see at any time, 0 at the beginning; any thread may ask.
enum { RANKS_WORDS = 96 };

/// Adds to a number and returns its previous value. This takes a millisecond or two on other ranks than the first.
int64_t ranks_add(size_t word, int64_t amount);

/// Adds to `count` neighbouring numbers from a word on, in one request; returns their new values.
enum { RANKS_MAX = 8 };
void ranks_add_all(size_t word, size_t count, int64_t *amounts);

/// Makes a number at least so large.
void ranks_raise(size_t word, int64_t value);

/// Some milliseconds of rest for one who waits.
void ranks_rest(void);

#endif
