// Converts results back to the user's own units and time: in a study all machines share one time (machine.c), by which
// velocities are derivatives.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "two_pi.h"
#include "user.h"

/// Fields of a table whose numbers depend on the unit of time; NULL for missing ones.
typedef struct timed_fields {
    const whirl_field *section, *nodes;
    const whirl_field *period, *rates[4]; ///< fields of points of branches
} timed_fields;

/// Returns the field with this quantity of motions, orbits or tori; a table has one of the three.
static const whirl_field *field_of_any(const whirl_layout *layout, const char *quantity) {
    static const char *const analyses[] = {"poincare", "trace", "torus"};
    const whirl_field *found = NULL;
    char name[WHIRL_NAME_SIZE];
    for (size_t i = 0; i < sizeof analyses / sizeof *analyses && !found; i++) {
        snprintf(name, sizeof name, "%s/%s", analyses[i], quantity);
        found = whirl_layout_field(layout, name);
    }
    return found;
}

static timed_fields fields_of(const whirl_layout *layout) {
    static const char *const rates[] = {WHIRL_FIELD_TRACE_LARGEST, WHIRL_FIELD_TRACE_MULTIPLIERS,
                                        WHIRL_FIELD_TRACE_VOLUME, WHIRL_FIELD_TRACE_ANGLE};
    timed_fields f = {.section = field_of_any(layout, "section"),
                      .nodes = field_of_any(layout, "nodes"),
                      .period = whirl_layout_field(layout, WHIRL_FIELD_TRACE_PERIOD)};
    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++) f.rates[i] = whirl_layout_field(layout, rates[i]);
    return f;
}

/// Converts the velocities of a section (x, y, vx, vy).
static void restore_section(const whirl_field *section, double scale, double *block) {
    double *numbers = block + section->offset;
    for (size_t n = 0; n < section->repeat * section->rows && section->columns == 4; n++)
        for (size_t k = 2; k < 4; k++) numbers[4 * n + k] /= scale;
}

/// Converts the whole states of an orbit, which follow one another.
static void restore_nodes(const whirl_user_system *system, const whirl_field *nodes, double scale, double *block) {
    const size_t d = system->displacements, n = system->dimension;
    for (size_t i = 0; i < nodes->rows; i++)
        if (i % n >= d && i % n < 2 * d) block[nodes->offset + i] /= scale;
    for (size_t i = 0; i < nodes->rows && system->units; i++) block[nodes->offset + i] *= system->units[i % n];
}

/// Converts the period of a branch's point, and the rates of an equilibrium per unit of time. angle: by which the
/// revolution advances in a unit of time.
static void restore_times(const timed_fields *f, double angle, double *block) {
    const bool rests = block[f->period->offset] == 0.0;
    block[f->period->offset] *= angle;
    for (size_t i = 0; i < 4 && rests; i++)
        for (size_t k = 0; f->rates[i] && k < f->rates[i]->rows * f->rates[i]->columns; k++)
            block[f->rates[i]->offset + k] /= angle;
}

/// Takes the parameters of a point instead of the system's own.
static void take_parameters(const whirl_user_system *system, const whirl_table *table, size_t i, double *parameters) {
    const double varied[USER_AXES] = {table->values[i], whirl_table_second(table, i), whirl_table_third(table, i)};
    const char *const names[USER_AXES] = {table->parameter, table->second, table->third};
    for (size_t k = 0; k < system->axis_count && k < USER_AXES; k++)
        if (*names[k]) parameters[system->axes[k].parameter] = varied[k];
}

whirl_status user_restore(const whirl_user_system *system, whirl_table *table) {
    const timed_fields f = fields_of(&table->layout);
    const bool velocities = system->displacements > 0 && f.section,
               nodes = f.nodes && (system->displacements > 0 || system->units);
    double parameters[USER_MAX_PARAMETERS], common, period;
    for (size_t k = 0; k < system->parameter_count; k++) parameters[k] = system->parameters[k].value;
    whirl_status status = user_period(system, parameters, &common);
    if (!table->blocks || (!velocities && !nodes && !f.period)) return status;
    for (size_t i = 0; i < table->count && status.code == WHIRL_OK; i++) {
        double *block = table->blocks + i * table->layout.size;
        if (!whirl_table_done(table, i)) continue;
        take_parameters(system, table, i, parameters);
        status = user_period(system, parameters, &period);
        if (velocities) restore_section(f.section, period / common, block);
        if (nodes) restore_nodes(system, f.nodes, period / common, block);
        if (f.period) restore_times(&f, two_pi / common, block);
    }
    return status;
}
