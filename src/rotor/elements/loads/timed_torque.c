// A torque over time, from a table. It acts in run-ups alone.
#include "registry.h"

#if VECTOR_ISA == VECTOR_SCALAR
#include <math.h>

#include "table.h"

enum { AT, TIMES, TORQUES, KEY_COUNT };

static const whirl_key keys[KEY_COUNT] = {
    [AT] = STATION_KEY("at", OPTIONAL,
                       "station that it turns; required if stations twist; absent: it turns the shaft as a whole"),
    [TIMES] = CITED_NUMBERS_KEY("times", "", "s", REQUIRED, WHIRL_NOT_NEGATIVE,
                                "rising times at which torques are given; between them monotone cubics, outside them "
                                "the first or the last torque",
                                "Fritsch, Butland 1984"),
    [TORQUES] = CITED_NUMBERS_KEY("torques", "", "N m", REQUIRED, WHIRL_ANY,
                                  "torques at these times, along the rotation; negative where they brake", ""),
};

enum { ROW_TIME, ROW_TORQUE };

static double timed_value(const shaft_torque *own, const torque_place *at, double *slopes) {
    const double *times = own->table[ROW_TIME];
    (void)slopes;
    return table_value(own->count, times, own->table[ROW_TORQUE],
                       fmin(fmax(at->time, times[0]), times[own->count - 1]));
}

static double timed_begins(const shaft_torque *own) {
    return own->table[ROW_TIME][0];
}

static const torque_law timed_law = {.name = "timed_torque", .torque = timed_value, .begins = timed_begins};

static whirl_status timed_build(const key_value *values, assembly *to, element *out) {
    const key_value *times = &values[TIMES], *torques = &values[TORQUES];
    shaft_torque own = {.law = &timed_law, .station = values[AT].given ? values[AT].station[0] : NO_STATION};
    out->lumped = true;
    if (times->count < 2 || times->count != torques->count || times->rows > 1 || torques->rows > 1 ||
        !table_rises(times->count, times->list))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "has %zu times and %zu torques, expected as many of both, at least 2, the times rising",
                          times->count, torques->count);
    own.count = times->count;
    for (size_t i = 0; i < own.count; i++) {
        own.table[ROW_TIME][i] = times->list[i];
        own.table[ROW_TORQUE][i] = torques->list[i];
    }
    return assembly_torque(to, &own);
}

const element_type timed_torque_element = {
    .group = {"timed_torque", "a torque over time that turns or brakes the shaft in a run-up", "", keys, KEY_COUNT,
              NULL, NULL},
    .build = timed_build,
};
#endif
