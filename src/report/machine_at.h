/// The machine at a point of a result, which its parameter may change, from the case that the result holds.
#ifndef REPORT_MACHINE_AT_H
#define REPORT_MACHINE_AT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

/// Makes the case of a result, with the parameters of the run; free it with whirl_case_free. NULL if the result has no
/// case, or one that cannot be read. WHIRL_NO_MEMORY.
whirl_status machine_of(const whirl_result *result, whirl_case **machine);

/// Makes the cases of several results [count], freed by machines_free, also after a failure. WHIRL_NO_MEMORY.
whirl_status machines_of(const whirl_result *const *results, size_t count, whirl_case ***machines);
void machines_free(whirl_case **machines, size_t count);

/// Returns the batch of a table in the study of a case, with the second and third parameter of a point; NULL if there
/// is none. A part of *study.
whirl_batch *machine_batch(const whirl_case *machine, const whirl_table *table, size_t point, whirl_study *study);

/// Makes the machine of a point with the values of its batch, but with the case's own unbalances instead of unbalances
/// by rule. The caller releases it. Returns false if it cannot be made.
bool machine_at(const whirl_case *machine, const whirl_table *table, size_t point, whirl_machine *out);

/// Returns the speed at a point, rad/s; NaN if unknown.
double machine_clock(const whirl_case *machine, const whirl_result *result, const whirl_table *table, size_t point);

/// Walls around a station, in length scales of the point; 0: none.
typedef struct machine_walls {
    double clearance; ///< clearance of its bearing
    double gap;       ///< gap to the stator
} machine_walls;

/// Returns the walls at a point, or those of the result's own case if the point's machine is unknown.
machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station);

/// Wall of the bearing or seal around a station: largest eccentricity in WALL_ANGLES directions from the x axis on, in
/// length scales of the point; all the same if it is round.
enum { WALL_ANGLES = 720 };
typedef struct machine_wall {
    bool round;
    double radius[WALL_ANGLES];
} machine_wall;

/// Finds the wall from the bearing's geometry: lobes, offset halves, pivots of tilting pads. A circle of radius
/// `clearance` if the machine cannot be made, or pads have no wall.
void machine_wall_at(const whirl_case *machine, const whirl_table *table, size_t point, size_t station,
                     double clearance, machine_wall *out);

/// Returns the radius in a direction (rad), interpolated linearly.
double machine_wall_radius(const machine_wall *wall, double angle);

#endif
