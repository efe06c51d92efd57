/// Kinds of points that studies compute (whirl_kind), and how points of each kind are computed and shared. A new kind
/// is a file of this folder, and an entry in the registry (kinds.c).
#ifndef STUDY_KINDS_H
#define STUDY_KINDS_H

#include "pass.h"
#include "resting_point.h"
#include "study_run.h"
#include "whirl/engine/study.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct study_kind {
    const char *name; ///< name of its whirl_kind
    size_t piece; ///< points of a piece, which one run or shard computes as a whole; 0: all. In a carried sweep a piece
                  ///< is a whole direction instead
    size_t (*piece_of)(const whirl_batch *batch); ///< returns `piece` of a batch; NULL: the same for all
    /// Computes the points of a pass, on all threads. The tracker reports errors and stops. WHIRL_NO_MEMORY. NULL:
    /// the main loop (run/passes.c) computes the points, which are motions, together with those of other passes.
    whirl_status (*work)(study_run *run, const pass *p);
} study_kind;

/// Returns the kind of a batch's points.
const study_kind *study_kind_of(const whirl_batch *batch);

extern const study_kind rest_kind, branch_kind, torus_kind, fit_kind;

// ---------------------------------------------------------------- critical
// Events between two neighbouring points of a study of machines at rest.

/// A machine of a batch at rest, with its modes.
typedef struct resting_machine {
    whirl_machine machine;
    whirl_modes *modes;
    size_t *before; ///< [modes->count] number (from 1) of the mode at the previous point, 0: none; NULL: unknown
    double value;
} resting_machine;

/// Makes the machine of a batch at a value of its parameter, with its modes. Errors as those of the machine and of
/// whirl_modes_new.
whirl_status resting_new(const whirl_study *study, const whirl_batch *batch, double value, resting_machine *out);
void resting_free(resting_machine *r);

/// Matches the modes of a point with those of the point before. WHIRL_NO_MEMORY.
whirl_status resting_follow(const resting_machine *from, resting_machine *to);

/// Locates critical speeds and thresholds of stability between two points, to 1e-10 of the parameter: at most `most`
/// are written to found, *count is their number.
whirl_status critical_locate(const whirl_study *study, const whirl_batch *batch, const resting_machine *from,
                             const resting_machine *to, whirl_critical *found, size_t most, size_t *count);

// Other equilibria, to which those of neighbouring points lead.

/// Equilibrium of a point's machine, as found from its start.
typedef struct known_rest {
    bool known;
    size_t slot, dimension;
    double *x; ///< [dimension]; NULL: no equilibrium was found
} known_rest;

/// Equilibria of three points in a row.
typedef struct known_rests {
    known_rest of[3];
} known_rests;

void known_rests_free(known_rests *rests);

/// Searches for another equilibrium of a point's machine, from those of the points before and after it (in its row of a
/// map). *elsewhere [dimension], to be freed, is NULL if there is none; *growth is the largest real part of its
/// eigenvalues; *rest is the point's own equilibrium, which `rests` owns. WHIRL_NO_MEMORY, WHIRL_STOPPED.
whirl_status elsewhere_find(const whirl_study *study, const whirl_batch *batch, const double *values, size_t slot,
                            const whirl_machine *machine, known_rests *rests, const double **rest, double **elsewhere,
                            double *growth);

#endif
