// Computes orbits along branches, stable or not, from the nodes in results.
#include "core.h"

#include <string.h>

/// Returns an orbit's dimensions, without nodes.
static whirl_orbit outline(const plan *p, int revolutions, double period) {
    const size_t round = revolutions > 0 ? (size_t)revolutions : 1;
    const size_t segments = period > 0.0 ? (size_t)p->batch.record.trace.segments : 1;
    return (whirl_orbit){.dimension = p->dimension,
                         .revolutions = revolutions > 0 ? (size_t)revolutions : 0,
                         .period = period,
                         .segment_count = segments * round};
}

EXPORTED size_t explorer_orbit_size(const plan *p, int revolutions, double period) {
    const whirl_orbit orbit = outline(p, revolutions, period);
    return orbit.segment_count * orbit.dimension;
}

static whirl_status write_block(const plan *p, const whirl_system *system, const whirl_orbit *orbit, double *block) {
    const whirl_orbit_options options = whirl_batch_orbits(&p->batch);
    whirl_record *record;
    whirl_status status = whirl_record_along(system, orbit, &options, &p->batch.record, &record);
    if (status.code == WHIRL_OK) status = whirl_analyze(record, &p->batch.record, p->batch.analyses, &p->layout, block);
    whirl_record_free(record);
    return status;
}

EXPORTED int explorer_orbit(const plan *p, double value, int revolutions, double period, const double *nodes,
                            double *block) {
    const whirl_orbit like = outline(p, revolutions, period);
    whirl_orbit *orbit = whirl_orbit_new(&like);
    whirl_machine machine = {.release = NULL};
    whirl_status status = orbit ? p->study.machine(p->study.family, &p->batch, value, &machine)
                                : whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    if (status.code == WHIRL_OK) {
        memcpy(orbit->nodes, nodes, like.segment_count * like.dimension * sizeof *nodes);
        status = write_block(p, machine.system, orbit, block);
    }
    if (machine.release) machine.release(machine.owner);
    whirl_orbit_free(orbit);
    return explorer_good(&status);
}
