/// A pass of a run over points of a batch, all with the same options.
#ifndef STUDY_PASS_H
#define STUDY_PASS_H

#include <stdbool.h>
#include <stddef.h>

#include "study_run.h"
#include "whirl/engine/study.h"

/// One walk over points of a batch, all with the same options. Slots are those of the batch's table.
typedef struct pass {
    size_t batch;
    int round;       ///< round of refinement; 0: the study itself
    bool confirming; ///< computes motions of finished points at the second tolerance
    bool anew;       ///< computes points that are not in the journal, even if the run otherwise only gathers points
    int copy;        ///< number from 1 of perturbed copies that continue finished points; 0: no copies
    whirl_integrate_options integrate;
    whirl_record_options record;
    size_t count;  ///< points
    size_t *slots; ///< its points, or the first point of each piece if points are carried; NULL: all points of the
                   ///< batch
    bool dealt;    ///< true if other runs compute points of this pass, too
} pass;

/// Returns the number of points that are computed one after the other, each from the end of the previous one: 1 if no
/// state is carried on.
static inline size_t pass_carried(const pass *p, const whirl_batch *batch) {
    const bool first = p->round == 0 && !p->confirming && p->copy == 0;
    return first && batch->carry != WHIRL_CARRY_NONE ? batch->count : 1;
}

/// Ratio of step errors at the first and the second tolerance: twice the steps of RK4.
static const double confirm_factor = 16.0;

enum {
    FOLLOW_COPIES = 2 ///< copies of a chaotic motion that is followed
};

/// Returns a pass over the same points at the second tolerance.
pass pass_confirming(const pass *points);

/// Returns true if a pass computes only verdicts, which are compared with those of the points.
static inline bool pass_is_comparison(const pass *p) {
    return p->confirming || p->copy > 0;
}

/// Returns the cost of a revolution, in revolutions of the study.
double pass_weight(const study_run *run, const pass *pass);

/// Returns the weighted revolutions of a point that runs to its end.
double pass_revolutions(const study_run *run, const pass *pass);

/// Returns the number of a pass in the journal (whirl_point_store).
size_t pass_number(const study_run *run, const pass *p);

/// Makes the initial state of a point's perturbed copy [dimension], to be freed; NULL without memory.
double *pass_copy_start(const study_run *run, const pass *p, size_t slot);

/// Returns the slot at whose end a motion from a neighbour begins; for other motions the slot itself.
size_t pass_origin(const study_run *run, size_t batch, size_t slot);

/// Returns true if the run's deadline has passed.
bool pass_time_is_over(const study_run *run);

#endif
