/// Unit of frequencies in figures over a parameter.
#ifndef REPORT_SPEED_UNIT_H
#define REPORT_SPEED_UNIT_H

#include "figure_kinds.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/result.h"

#include <stdbool.h>

typedef struct speed_unit {
    double size; ///< rad/s
    char name[WHIRL_NAME_SIZE];
    bool of_speed; ///< the parameter is the speed of the shaft
} speed_unit;

/// Returns the parameter's unit if the parameter is the shaft's speed (field `speeds` of every point), else Hz.
speed_unit speed_unit_of(const drawing *of, const whirl_table *table, const char *speeds);

#endif
