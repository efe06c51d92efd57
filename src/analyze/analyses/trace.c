// Points of branches: orbits and equilibria, stable or not, as numbers of a block, written and read.
#include <math.h>
#include <string.h>

#include "analysis.h"

enum {
    NUMBER,
    PARENT,
    END,
    SPECIAL,
    SECOND,
    REVOLUTIONS,
    PERIOD,
    UNSTABLE,
    LARGEST,
    ANGLE,
    CRITICALITY,
    TOUCH,
    RESIDUAL,
    VOLUME,
    MULTIPLIERS,
    TOUCHES,
    NODES,
    SECTION,
    LOW,
    HIGH,
    AXIAL,
    TWIST,
    FIELD_COUNT
};

static size_t trace_touches(const block_shape *shape) {
    return shape->touch_count;
}

static size_t numbers_of_nodes(const block_shape *shape) {
    return (size_t)shape->options->trace.segments * rows_of_longest_orbit(shape) * shape->dimension;
}

static const field_plan fields[FIELD_COUNT] = {
    [NUMBER] = {WHIRL_FIELD_TRACE_NUMBER, "1", "number of the branch, from 1 in the order in which branches were found",
                WHIRL_PER_POINT, 1, NULL},
    [PARENT] = {WHIRL_FIELD_TRACE_PARENT, "1", "the branch along which it begins; 0: none", WHIRL_PER_POINT, 1, NULL},
    [END] = {WHIRL_FIELD_TRACE_END, "1",
             "why the branch ends here: 0 range, 1 points, 2 closed, 3 lost, 4 at a doubling, 5 stopped, 6 at a "
             "pitchfork; else missing",
             WHIRL_PER_POINT, 1, NULL},
    [SPECIAL] = {WHIRL_FIELD_TRACE_SPECIAL, "1",
                 "0 none, 1 fold, 2 crossing, 3 doubling, 4 Neimark-Sacker, 5 Hopf, 6 graze", WHIRL_PER_POINT, 1, NULL},
    [SECOND] = {WHIRL_FIELD_TRACE_SECOND, "1", "value of the second parameter, in SI; missing where one is followed",
                WHIRL_PER_POINT, 1, NULL},
    [REVOLUTIONS] = {WHIRL_FIELD_TRACE_REVOLUTIONS, "revolution",
                     "revolutions after which the orbit closes; 0: its period is free", WHIRL_PER_POINT, 1, NULL},
    [PERIOD] = {WHIRL_FIELD_TRACE_PERIOD, "rad",
                "period of the orbit, as an angle of the rotor's clock; 0: an equilibrium", WHIRL_PER_POINT, 1, NULL},
    [UNSTABLE] = {WHIRL_FIELD_TRACE_UNSTABLE, "1", "multipliers beyond the unit circle: stable at 0", WHIRL_PER_POINT,
                  1, NULL},
    [LARGEST] = {WHIRL_FIELD_TRACE_LARGEST, "1",
                 "largest modulus of a multiplier; of equilibria largest growth per rad", WHIRL_PER_POINT, 1, NULL},
    [ANGLE] = {WHIRL_FIELD_TRACE_ANGLE, "rad",
               "angle of the pair of multipliers at a Neimark-Sacker point; at a Hopf point per rad", WHIRL_PER_POINT,
               1, NULL},
    [CRITICALITY] = {WHIRL_FIELD_TRACE_CRITICALITY, "1",
                     "cubic coefficient of the normal form: below 0 what begins is stable", WHIRL_PER_POINT, 1, NULL},
    [TOUCH] = {WHIRL_FIELD_TRACE_TOUCH, "1", "row of touches that grazes, from 0", WHIRL_PER_POINT, 1, NULL},
    [RESIDUAL] = {WHIRL_FIELD_TRACE_RESIDUAL, "1", "error by which the orbit closes, over its largest coordinate",
                  WHIRL_PER_POINT, 1, NULL},
    [VOLUME] = {WHIRL_FIELD_TRACE_VOLUME, "1", "sum of ln|multiplier| by the divergence", WHIRL_PER_POINT, 1, NULL},
    [MULTIPLIERS] = {WHIRL_FIELD_TRACE_MULTIPLIERS, "1", "real, imaginary", WHIRL_PER_POINT, 2, rows_per_coordinate},
    [TOUCHES] = {WHIRL_FIELD_TRACE_TOUCHES, "1", "switch, intervals, nearest, share", WHIRL_PER_POINT, 4,
                 trace_touches},
    [NODES] = {WHIRL_FIELD_TRACE_NODES, "1", "states at the beginnings of segments, one after the other",
               WHIRL_PER_POINT, 1, numbers_of_nodes},
    [SECTION] = {WHIRL_FIELD_TRACE_SECTION, "length",
                 "x, y, vx, vy (from the centre; velocities are lengths per unit of the system's time)",
                 WHIRL_PER_STATION, 4, rows_of_longest_orbit},
    [LOW] = {WHIRL_FIELD_TRACE_LOW, "length", "x, y (least at any instant, from the centre)", WHIRL_PER_STATION, 2,
             NULL},
    [HIGH] = {WHIRL_FIELD_TRACE_HIGH, "length", "x, y (most at any instant, from the centre)", WHIRL_PER_STATION, 2,
              NULL},
    [AXIAL] = {WHIRL_FIELD_TRACE_AXIAL, "length",
               "least, largest (axial displacement at any instant; missing where the station does not move along its "
               "shaft)",
               WHIRL_PER_STATION, 2, rows_of_axial},
    [TWIST] = {WHIRL_FIELD_TRACE_TWIST, "rad",
               "least, largest (twist at any instant; missing where the station does not twist, or moves no other way)",
               WHIRL_PER_STATION, 2, rows_of_twist},
};

// ---------------------------------------------------------------- to numbers

static void put_point(const block_view *view, const whirl_trace *trace) {
    const whirl_branch_point *point = &trace->point;
    const whirl_orbit *orbit = point->orbit;
    const bool turns = point->special == WHIRL_NEIMARK_SACKER || point->special == WHIRL_HOPF;
    *view_numbers(view, NUMBER, 0) = (double)trace->branch;
    *view_numbers(view, PARENT, 0) = (double)trace->parent;
    *view_numbers(view, END, 0) = trace->end;
    *view_numbers(view, SPECIAL, 0) = point->special;
    *view_numbers(view, SECOND, 0) = point->second;
    *view_numbers(view, REVOLUTIONS, 0) = (double)orbit->revolutions;
    *view_numbers(view, PERIOD, 0) = orbit->period;
    *view_numbers(view, UNSTABLE, 0) = (double)orbit->unstable;
    *view_numbers(view, LARGEST, 0) = whirl_orbit_largest(orbit);
    *view_numbers(view, ANGLE, 0) = turns ? point->angle : (double)NAN;
    *view_numbers(view, CRITICALITY, 0) = point->criticality;
    *view_numbers(view, TOUCH, 0) = point->special == WHIRL_GRAZE ? (double)point->touch : (double)NAN;
    *view_numbers(view, RESIDUAL, 0) = orbit->residual;
    *view_numbers(view, VOLUME, 0) = orbit->volume;
}

static void put_arrays(const block_view *view, const whirl_orbit *orbit) {
    double *out = view_numbers(view, MULTIPLIERS, 0);
    for (size_t i = 0; i < orbit->multiplier_count; i++) {
        out[2 * i] = orbit->multipliers[i].real;
        out[2 * i + 1] = orbit->multipliers[i].imaginary;
    }
    out = view_numbers(view, TOUCHES, 0);
    for (size_t i = 0; i < orbit->touch_count; i++) {
        out[4 * i] = (double)orbit->touches[i].index;
        out[4 * i + 1] = (double)orbit->touches[i].intervals;
        out[4 * i + 2] = orbit->touches[i].nearest;
        out[4 * i + 3] = orbit->touches[i].share;
    }
    memcpy(view_numbers(view, NODES, 0), orbit->nodes, orbit->segment_count * orbit->dimension * sizeof *orbit->nodes);
}

/// Writes a station's section. Orbits with a free period and equilibria have their first node as section.
static void put_station(const block_view *view, const whirl_system *system, const whirl_orbit *orbit, size_t which) {
    const whirl_probe *probe = &system->probes[which];
    const size_t count = orbit->revolutions > 0 ? orbit->revolutions : 1;
    double *out = view_numbers(view, SECTION, which);
    for (size_t k = 0; k < count; k++) {
        const double *state = orbit->nodes + k * (orbit->segment_count / count) * orbit->dimension;
        for (size_t c = 0; c < 4; c++) *out++ = whirl_probe_value(probe, state, c);
    }
    for (size_t c = 0; c < 2; c++) {
        double bounds[2];
        probe_bounds(probe, orbit->low, orbit->high, c, bounds);
        view_numbers(view, LOW, which)[c] = bounds[0];
        view_numbers(view, HIGH, which)[c] = bounds[1];
    }
}

/// Writes the bounds of the axial displacements and twists.
static void put_extras(const block_view *view, const whirl_system *system, const double *low, const double *high) {
    for (size_t i = 0; i < system->extra_count; i++)
        probe_bounds(&system->probes[system->probe_count + i], low, high, 0,
                     view_numbers(view, system->extras[i].twists ? TWIST : AXIAL, system->extras[i].station));
}

static whirl_status trace_compute(const whirl_trace *trace, const whirl_record_options *options,
                                  const block_view *view) {
    const whirl_orbit *orbit = trace->point.orbit;
    const size_t most = (size_t)options->trace.longest;
    if (orbit->revolutions > most || orbit->segment_count > most * (size_t)options->trace.segments)
        return whirl_fail(WHIRL_BAD_INPUT, "an orbit of %zu revolutions in %zu segments, expected at most %zu in %zu",
                          orbit->revolutions, orbit->segment_count, most, most * (size_t)options->trace.segments);
    put_point(view, trace);
    put_arrays(view, orbit);
    for (size_t i = 0; i < trace->system->probe_count; i++) put_station(view, trace->system, orbit, i);
    put_extras(view, trace->system, orbit->low, orbit->high);
    return whirl_ok();
}

const analysis_plan trace_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute_trace = trace_compute};

// ---------------------------------------------------------------- and back

/// A block that is read.
typedef struct reading {
    const whirl_layout *layout;
    const double *block;
} reading;

static const whirl_field *field_of(const reading *r, size_t field) {
    return whirl_layout_field(r->layout, fields[field].name);
}

/// Returns a field's numbers, NULL if the layout has none.
static const double *read_numbers(const reading *r, size_t field) {
    const whirl_field *found = field_of(r, field);
    return found ? r->block + found->offset : NULL;
}

static bool is_size(double number) {
    return number >= 0.0 && number <= 1e6;
}

/// Returns the number of leading rows without missing numbers.
static size_t trace_filled(const double *numbers, size_t rows, size_t columns) {
    size_t count = 0;
    while (count < rows && !isnan(numbers[columns * count])) count++;
    return count;
}

static void take_arrays(const reading *r, whirl_orbit *orbit) {
    const double *in = read_numbers(r, MULTIPLIERS);
    for (size_t i = 0; i < orbit->multiplier_count; i++)
        orbit->multipliers[i] = (whirl_multiplier){in[2 * i], in[2 * i + 1]};
    in = read_numbers(r, TOUCHES);
    for (size_t i = 0; i < orbit->touch_count; i++)
        orbit->touches[i] =
            (whirl_touch){(size_t)in[4 * i], (size_t)in[4 * i + 1], in[4 * i + 2], fmin(in[4 * i + 3], 1.0)};
    memcpy(orbit->nodes, read_numbers(r, NODES), orbit->segment_count * orbit->dimension * sizeof *orbit->nodes);
}

static whirl_orbit *take_orbit(const reading *r, const whirl_record_options *options) {
    const double revolutions = *read_numbers(r, REVOLUTIONS), period = *read_numbers(r, PERIOD);
    const double *multipliers = read_numbers(r, MULTIPLIERS), *contacts = read_numbers(r, TOUCHES);
    const size_t dimension = field_of(r, MULTIPLIERS)->rows;
    const size_t segments = period > 0.0 ? (size_t)options->trace.segments : 1;
    const whirl_orbit like = {.dimension = dimension,
                              .revolutions = (size_t)revolutions,
                              .period = period,
                              .segment_count = segments * (revolutions > 0.0 ? (size_t)revolutions : 1),
                              .multiplier_count = trace_filled(multipliers, dimension, 2),
                              .touch_count = contacts ? trace_filled(contacts, field_of(r, TOUCHES)->rows, 4) : 0};
    whirl_orbit *orbit = whirl_orbit_new(&like);
    if (!orbit) return NULL;
    orbit->unstable = (size_t)*read_numbers(r, UNSTABLE);
    orbit->residual = *read_numbers(r, RESIDUAL);
    orbit->volume = *read_numbers(r, VOLUME);
    take_arrays(r, orbit);
    return orbit;
}

whirl_status whirl_block_trace(const whirl_layout *layout, const double *block, double value,
                               const whirl_record_options *options, whirl_trace *out) {
    static const size_t sizes[] = {NUMBER, PARENT, SPECIAL, REVOLUTIONS, PERIOD, UNSTABLE};
    const reading r = {layout, block};
    bool good = field_of(&r, NUMBER) && field_of(&r, MULTIPLIERS) && field_of(&r, NODES);
    for (size_t i = 0; good && i < sizeof sizes / sizeof *sizes; i++) good = is_size(*read_numbers(&r, sizes[i]));
    if (!good || *read_numbers(&r, SPECIAL) > WHIRL_GRAZE || *read_numbers(&r, REVOLUTIONS) > options->trace.longest)
        return whirl_fail(WHIRL_BAD_INPUT, "a block holds no point of a branch");
    const double touch = *read_numbers(&r, TOUCH), angle = *read_numbers(&r, ANGLE);
    *out = (whirl_trace){.point = {.value = value,
                                   .second = *read_numbers(&r, SECOND),
                                   .special = (whirl_special)*read_numbers(&r, SPECIAL),
                                   .angle = isnan(angle) ? 0.0 : angle,
                                   .criticality = *read_numbers(&r, CRITICALITY),
                                   .touch = is_size(touch) ? (size_t)touch : 0,
                                   .orbit = take_orbit(&r, options)},
                         .branch = (size_t)*read_numbers(&r, NUMBER),
                         .parent = (size_t)*read_numbers(&r, PARENT),
                         .end = *read_numbers(&r, END)};
    return out->point.orbit ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
}
