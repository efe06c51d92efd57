/// Makes the machine of a point of a result, from the case that the result holds and the values of its parameters
/// there.
#ifndef REPORT_MACHINE_AT_H
#define REPORT_MACHINE_AT_H

#include <stdbool.h>
#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/status.h"

/// Makes the case of a result, with the parameters of the run; free it with whirl_case_free. *machine is NULL if the
/// result has no case, or one that cannot be read. Fails with WHIRL_NO_MEMORY.
whirl_status machine_of(const whirl_result *result, whirl_case **machine);

/// Makes the cases of several results [count]; free them with machines_free, also after a failure. Fails with
/// WHIRL_NO_MEMORY.
whirl_status machines_of(const whirl_result *const *results, size_t count, whirl_case ***machines);
void machines_free(whirl_case **machines, size_t count);

/// Makes *study the study of a case with the second and third parameter of a point, and returns the batch of the table
/// in it; NULL if there is none.
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

/// Returns the walls around a station at a point, or those of the result's stations if the point's machine is unknown.
machine_walls machine_walls_at(const whirl_case *machine, const whirl_result *result, const whirl_table *table,
                               size_t point, size_t station);

/// Wall of the bearing or seal around a station: largest eccentricity in WALL_ANGLES directions from the x axis on, in
/// length scales of the point. All radii of a round wall are equal.
enum { WALL_ANGLES = 720 };
typedef struct machine_wall {
    bool round;
    double radius[WALL_ANGLES];
} machine_wall;

/// Finds the wall from the bearing's geometry: lobes, offset halves, pivots of tilting pads. A circle of radius
/// `clearance` if the machine cannot be made, or pads have no wall.
void machine_wall_at(const whirl_case *machine, const whirl_table *table, size_t point, size_t station,
                     double clearance, machine_wall *out);

/// Returns the radius of a wall in a direction (rad from the x axis), interpolated linearly.
double machine_wall_radius(const machine_wall *wall, double angle);

#endif
