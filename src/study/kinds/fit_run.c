#include "fit_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "kinds.h"
#include "resting_point.h"
#include "two_pi.h"
#include "whirl/engine/running.h"

/// RUN_STENCIL: neighbouring values of an unknown for its derivative, in addition to the value itself. RUN_TOGETHER:
/// runs that are carried together. RUN_NODES: turns between which orders are interpolated.
enum { RUN_STENCIL = 4, RUN_TOGETHER = 8, RUN_NODES = 4 };

/// Bytes of the motions of runs that are carried together, at most.
enum { RUN_BYTES = 1 << 28 };

/// Limits of the number of rows of a run, with a turn in each.
enum { RUN_MIN_ROWS = 64, RUN_MAX_ROWS = 20000 };

/// Distance of neighbouring values, as a part of the size of the unknown. With five values the error of a derivative is
/// of the fourth order: below 1e-6 for resonances with a damping ratio of 0.005 or more.
static const double run_difference = 2.5e-4;

/// Number of turns up to which that distance serves for waveforms. Their derivatives grow with the angle of the shaft
/// that an unknown changes. The distance is shorter for longer runs, so that a change of the rate by twice the distance
/// turns the shaft by 0.1 rad at most. The error of the derivatives is then below 1e-5 up to the third order.
static const double run_waveform_turns = 64.0;

/// Derivatives from five values, by their places in units of the distance: around the value, or on one side of it where
/// a bound is near.
typedef struct run_stencil {
    double at[RUN_STENCIL], weights[RUN_STENCIL], own; ///< own: weight of the value itself
} run_stencil;

static const run_stencil around = {{-2.0, -1.0, 1.0, 2.0}, {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0}, 0.0};
static const run_stencil above = {{1.0, 2.0, 3.0, 4.0}, {4.0, -3.0, 4.0 / 3.0, -0.25}, -25.0 / 12.0};
static const run_stencil below = {{-1.0, -2.0, -3.0, -4.0}, {-4.0, 3.0, -4.0 / 3.0, 0.25}, 25.0 / 12.0};

/// The runs of a place.
typedef struct run_work {
    const fit_place *place;
    const whirl_fit_run *run;
    size_t first, count;      ///< numbers of the run, one after the other
    size_t instants;          ///< of a waveform: number of times; else 0
    size_t together;          ///< largest number of runs that are carried together
    double difference;        ///< distance of neighbouring values, as a part of the size of the unknown
    whirl_analysis_set runup; ///< the analysis
    whirl_record_options record;
    whirl_layout layout;
} run_work;

/// A run among others.
typedef struct run_one {
    double values[WHIRL_MAX_UNKNOWNS];
    fit_place place;
    whirl_machine machine;
    resting_place at;
    whirl_run_motion motion; ///< of a waveform
} run_one;

/// Makes a place request the machine of its run.
static void run_request(fit_place *p, whirl_analysis_set runup, const whirl_record_options *record) {
    p->batch.analyses = runup;
    p->batch.record = *record;
    p->batch.fit_run = 1 + p->motion->run->set;
}

// ---------------------------------------------------------------- rows of a run

/// The turns of a run.
typedef struct run_turns {
    const double *block;
    const whirl_field *time, *speed, *amplitude, *lag;
    size_t count;
    size_t *rows; ///< [count] rows of the turns
    double length;
} run_turns;

/// Lists the whole turns of a run. `rows` has room for all rows.
static void run_list_turns(const whirl_layout *layout, const double *block, double length, size_t *rows,
                           run_turns *out) {
    *out = (run_turns){.block = block,
                       .time = whirl_layout_field(layout, WHIRL_FIELD_RUNUP_TIME),
                       .speed = whirl_layout_field(layout, WHIRL_FIELD_RUNUP_SPEED),
                       .amplitude = whirl_layout_field(layout, WHIRL_FIELD_RUNUP_AMPLITUDE),
                       .lag = whirl_layout_field(layout, WHIRL_FIELD_RUNUP_LAG),
                       .rows = rows,
                       .length = length};
    for (size_t row = 0; row < out->time->rows; row++)
        if (isfinite(block[out->time->offset + row]) &&
            isfinite(block[out->amplitude->offset + row * out->amplitude->columns]))
            rows[out->count++] = row;
}

/// Returns the place of a turn along the axis of the table: its time or its speed.
static double turn_along(const run_turns *t, bool by_time, size_t turn) {
    return t->block[(by_time ? t->time : t->speed)->offset + t->rows[turn]];
}

/// Returns the part of an order over a turn, cosine or sine, of a probe's displacement along a direction, m.
static double turn_part(const run_turns *t, const whirl_fit_number *number, bool sine, size_t turn) {
    const size_t columns = t->amplitude->columns;
    const size_t at = (number->station * t->amplitude->rows + t->rows[turn]) * columns + 2 * ((size_t)number->at - 1);
    double parts[2];
    for (size_t axis = 0; axis < 2; axis++) {
        const double size = t->block[t->amplitude->offset + at + axis];
        const double lag = t->block[t->lag->offset + at + axis] * two_pi / 360.0;
        // A part that is too small has no lag.
        parts[axis] = isfinite(lag) ? size * (sine ? sin(lag) : cos(lag)) : 0.0;
    }
    return t->length * (cos(number->angle) * parts[0] + sin(number->angle) * parts[1]);
}

/// Turns around a place, and the weights by which their numbers are interpolated there.
typedef struct run_between {
    size_t count, turns[RUN_NODES];
    double weights[RUN_NODES];
} run_between;

/// Finds the turns around a place along the axis. Returns false if the run does not reach it, or reaches it more than
/// once. A place may be up to a turn before the first or after the last one.
static bool run_find(const run_turns *t, bool by_time, double value, run_between *out) {
    size_t passes = 0, before = 0;
    if (t->count < RUN_NODES) return false;
    for (size_t i = 0; i + 1 < t->count; i++) {
        double a = turn_along(t, by_time, i), b = turn_along(t, by_time, i + 1);
        const double step = b - a;
        if (i == 0) a -= step;
        if (i + 2 == t->count) b += step;
        const bool within = step > 0.0 ? value >= a && value < b : value <= a && value > b;
        passes += within;
        if (within) before = i;
    }
    if (passes != 1) return false;
    // Interpolate by Lagrange's polynomial through the turns around it.
    const size_t low = before > 0 ? before - 1 : 0;
    const size_t first = low + RUN_NODES > t->count ? t->count - RUN_NODES : low;
    out->count = RUN_NODES;
    for (size_t k = 0; k < RUN_NODES; k++) {
        out->turns[k] = first + k;
        out->weights[k] = 1.0;
        const double own = turn_along(t, by_time, first + k);
        for (size_t j = 0; j < RUN_NODES; j++)
            if (j != k)
                out->weights[k] *=
                    (value - turn_along(t, by_time, first + j)) / (own - turn_along(t, by_time, first + j));
    }
    return true;
}

static double run_part(const run_turns *t, const run_between *at, const whirl_fit_number *number, bool sine) {
    double sum = 0.0;
    for (size_t k = 0; k < at->count; k++) sum += at->weights[k] * turn_part(t, number, sine, at->turns[k]);
    return sum;
}

/// Reads the numbers of a run from its turns; delay: s, time of the table at which it begins. Unless NULL, speeds and
/// times [motions of the run] get those of the rows.
static whirl_status run_read(const run_work *w, const run_turns *t, double delay, double *numbers, double *speeds,
                             double *times, size_t *lost) {
    const whirl_fit *fit = w->place->of->fit;
    size_t known = SIZE_MAX;
    run_between at = {.count = 0};
    for (size_t i = 0; i < w->count; i++) {
        const whirl_fit_number *number = &fit->numbers[w->first + i];
        const whirl_fit_motion *motion = &fit->motions[number->motion];
        const size_t row = number->motion - w->run->first;
        // Find the place of a new row.
        if (number->motion != known) {
            const double value = w->run->by_time ? motion->time - delay : motion->speed;
            known = number->motion;
            *lost = known;
            if (!run_find(t, w->run->by_time, value, &at))
                return whirl_fail(WHIRL_BAD_INPUT, "its run does not reach a row of its table, or reaches it twice");
            for (size_t k = 0; k < at.count && speeds; k++) {
                speeds[row] += at.weights[k] * turn_along(t, false, at.turns[k]);
                times[row] += at.weights[k] * turn_along(t, true, at.turns[k]);
            }
        }
        const double cosine = run_part(t, &at, number, false), sine = run_part(t, &at, number, true);
        numbers[i] = number->quantity == WHIRL_FIT_COS   ? cosine
                     : number->quantity == WHIRL_FIT_SIN ? sine
                                                         : hypot(cosine, sine);
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- waveforms of a run

/// Counts the times at which displacements were measured; numbers at one time follow each other.
static size_t run_count_instants(const run_work *w) {
    const whirl_fit_number *numbers = &w->place->of->fit->numbers[w->first];
    size_t count = 0;
    for (size_t i = 0; i < w->count; i++) count += i == 0 || numbers[i].at != numbers[i - 1].at;
    return count;
}

/// Returns the bytes of the motion of a run with this number of stations.
static size_t run_motion_bytes(const run_work *w, size_t stations) {
    return w->instants * (2 * stations + 2) * sizeof(double);
}

/// Makes the motion of a run, to be filled in at the measured times. Freed by run_motion_free.
static whirl_status run_motion_make(const run_work *w, const whirl_machine *machine, whirl_run_motion *out) {
    const whirl_fit_number *numbers = &w->place->of->fit->numbers[w->first];
    const size_t probes = machine->system->probe_count;
    double *memory = calloc(run_motion_bytes(w, probes) + 1, 1);
    if (!memory) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the runs of a fit");
    double *times = memory + (2 * probes + 1) * w->instants;
    for (size_t i = 0, k = 0; i < w->count; i++)
        if (i == 0 || numbers[i].at != numbers[i - 1].at) times[k++] = numbers[i].at - machine->delay;
    *out = (whirl_run_motion){.probes = probes,
                              .count = w->instants,
                              .times = times,
                              .x = memory,
                              .angle = memory + 2 * probes * w->instants};
    if (times[0] >= 0.0) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "a time of its table is before the beginning of its run");
}

static void run_motion_free(whirl_run_motion *motion) {
    free(motion->x);
    motion->x = NULL;
}

/// Reads the displacements of a run at the measured times, m, with the runout of the probes.
static whirl_status run_read_motion(const run_work *w, const run_one *own, double *numbers) {
    const whirl_fit_number *of = &w->place->of->fit->numbers[w->first];
    const whirl_run_motion *motion = &own->motion;
    if (motion->filled < motion->count) return whirl_fail(WHIRL_BAD_INPUT, "its run ends before a time of its table");
    for (size_t i = 0, k = 0; i < w->count; i++) {
        if (i > 0 && of[i].at != of[i - 1].at) k++;
        const whirl_probe *probe = &own->machine.system->probes[of[i].station];
        const double turns = motion->angle[k] / two_pi;
        double along[2];
        for (size_t axis = 0; axis < 2; axis++)
            along[axis] = motion->x[(2 * of[i].station + axis) * motion->count + k] +
                          (probe->runout_count > 0 ? whirl_probe_runout(probe, axis, turns) : 0.0);
        numbers[i] = own->machine.length * (cos(of[i].angle) * along[0] + sin(of[i].angle) * along[1]);
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- runs

/// Returns the highest speed of a run, rad/s, as far as it is known before.
static double run_highest(const whirl_machine *machine, const whirl_runup_options *options) {
    double highest = fmax(options->from, options->to);
    if (options->rate > 0.0)
        highest = fmax(highest, options->to > 0.0 ? 0.0 : options->from + options->rate * options->duration);
    if (whirl_runup_driven(options)) highest = fmax(highest, machine->drive_speed);
    for (size_t i = 0; machine->course && i < machine->course->speed_count; i++)
        highest = fmax(highest, machine->course->speeds[i]);
    return highest;
}

/// Returns the length of a run, s.
static double run_length(const whirl_machine *machine, const whirl_runup_options *options) {
    const size_t rows = machine->course ? machine->course->speed_count : 0;
    if (options->duration > 0.0 || options->rate > 0.0) return whirl_runup_duration(options);
    return rows > 0 ? machine->course->speed_times[rows - 1] : 0.0;
}

/// Chooses the number of rows, for orders so that each turn has one, and makes the layout of the results. For waveforms
/// it chooses the distance of neighbouring values, and how many runs are carried together.
static whirl_status run_make_layout(run_work *w) {
    fit_place here = *w->place;
    whirl_machine machine = {.system = NULL};
    here.batch.given = here.given;
    run_request(&here, w->runup, &w->record);
    whirl_status status = fit_place_machine(&here, &machine);
    if (status.code == WHIRL_OK) {
        const whirl_runup_options *options = machine.run ? machine.run : &w->record.runup;
        const double turns = 1.01 * run_length(&machine, options) * run_highest(&machine, options) / two_pi;
        const double rows = w->run->waveform ? RUN_MIN_ROWS : fmin(fmax(ceil(turns), RUN_MIN_ROWS), RUN_MAX_ROWS);
        if (!w->run->sized) w->record.runup.rows = (int)rows;
        if (w->run->waveform) {
            const size_t each = run_motion_bytes(w, machine.system->probe_count);
            w->difference = run_difference * fmin(1.0, run_waveform_turns / turns);
            w->together = each > RUN_BYTES / RUN_TOGETHER ? RUN_BYTES / each : RUN_TOGETHER;
            if (w->together == 0) w->together = 1;
        }
    }
    if (status.code == WHIRL_OK)
        status = whirl_layout_new(machine.system, &w->place->batch.integrate, &w->record, w->runup, &w->layout);
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// A group of runs that are carried together.
typedef struct run_group {
    run_one all[RUN_TOGETHER];
    whirl_resting points[RUN_TOGETHER];
    whirl_status statuses[RUN_TOGETHER];
    double *blocks[RUN_TOGETHER];
} run_group;

/// Returns the speed at which a run begins, rad/s.
static double run_first_speed(const whirl_machine *machine) {
    if (machine->course && machine->course->speed_count > 0) return machine->course->speeds[0];
    return machine->run ? machine->run->from : 0.0;
}

/// Reads the numbers of runs that were carried out. speeds and times, unless NULL, are those of the rows of the first.
static whirl_status run_read_all(const run_work *w, const run_group *g, size_t count, double *numbers, double *speeds,
                                 double *times, size_t *lost) {
    const whirl_field *time = whirl_layout_field(&w->layout, WHIRL_FIELD_RUNUP_TIME);
    size_t *rows = malloc((time->rows + 1) * sizeof *rows);
    whirl_status status = rows ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the runs of a fit");
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        run_turns turns;
        status = g->statuses[i];
        if (status.code != WHIRL_OK) break;
        if (w->run->waveform) {
            status = run_read_motion(w, &g->all[i], numbers + i * w->count);
            if (i == 0 && speeds) speeds[0] = run_first_speed(&g->all[i].machine);
            continue;
        }
        run_list_turns(&w->layout, g->blocks[i], g->all[i].machine.length, rows, &turns);
        status =
            run_read(w, &turns, g->all[i].machine.delay, numbers + i * w->count, i == 0 ? speeds : NULL, times, lost);
    }
    free(rows);
    return status;
}

/// Carries out runs [count, at most RUN_TOGETHER] at their values, and reads their numbers [count][w->count].
static whirl_status run_carry(const run_work *w, run_group *g, size_t count, double *numbers, double *speeds,
                              double *times, size_t *lost) {
    whirl_status status = whirl_ok();
    // Make the machines.
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        run_one *own = &g->all[i];
        fit_place_make(&own->place, w->place->of, w->run->first, own->values);
        run_request(&own->place, w->runup, &w->record);
        own->at = (resting_place){w->place->of->study, &own->place.batch, NAN};
        status = fit_place_machine(&own->place, &own->machine);
        if (status.code != WHIRL_OK) own->machine.release = NULL;
        if (status.code == WHIRL_OK) g->points[i] = resting_point_of(&own->at, &own->machine);
        if (status.code == WHIRL_OK && w->run->waveform) {
            status = run_motion_make(w, &own->machine, &own->motion);
            g->points[i].motion = &own->motion;
        }
        g->blocks[i] = calloc(w->layout.size + 1, sizeof *g->blocks[i]);
        if (status.code == WHIRL_OK && !g->blocks[i])
            status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the runs of a fit");
    }
    // Carry out the runs, and read their rows.
    if (status.code == WHIRL_OK)
        status =
            whirl_analyze_resting_together(count, g->points, &w->record, w->runup, &w->layout, g->blocks, g->statuses);
    if (status.code == WHIRL_OK) status = run_read_all(w, g, count, numbers, speeds, times, lost);
    for (size_t i = 0; i < count; i++) {
        if (g->all[i].machine.release) g->all[i].machine.release(g->all[i].machine.owner);
        run_motion_free(&g->all[i].motion);
        free(g->blocks[i]);
    }
    return status;
}

/// Chooses the neighbouring values of an unknown. Returns their distance.
static double run_choose(const run_work *w, const whirl_fit_unknown *unknown, double value,
                         const run_stencil **stencil) {
    const double range = unknown->high - unknown->low;
    double size = fabs(value);
    if (isfinite(range)) size = fmax(size, 0.01 * range);
    if (size == 0.0) size = 1.0;
    const double h = w->difference * size, reach = 2.0 * h;
    *stencil = value - reach < unknown->low ? &above : value + reach > unknown->high ? &below : &around;
    return h;
}

/// Sets the values of a run: those of the place, or neighbouring ones.
static void run_set_values(const run_work *w, size_t run, double *values) {
    const whirl_fit *fit = w->place->of->fit;
    memcpy(values, w->place->values, fit->unknown_count * sizeof *values);
    if (run == 0) return;
    const size_t unknown = (run - 1) / RUN_STENCIL, node = (run - 1) % RUN_STENCIL;
    const run_stencil *stencil;
    const double h = run_choose(w, &fit->unknowns[unknown], values[unknown], &stencil);
    values[unknown] += h * stencil->at[node];
}

/// Carries out all runs, in groups on all threads: the first at the values of the place, then those at neighbouring
/// values. numbers [runs][count].
static whirl_status run_all(const run_work *w, double *numbers, double *speeds, double *times, size_t *lost) {
    const size_t runs = 1 + RUN_STENCIL * w->place->of->fit->unknown_count, begun = *lost;
    const size_t groups = (runs + w->together - 1) / w->together, most = (runs + groups - 1) / groups;
    whirl_status first = whirl_ok();
    size_t failed = groups;
#pragma omp parallel for num_threads(w->place->of->threads) schedule(dynamic)
    for (size_t k = 0; k < groups; k++) {
        const size_t from = k * most, count = runs - from < most ? runs - from : most;
        size_t row = begun;
        run_group *g = calloc(1, sizeof *g);
        for (size_t i = 0; i < count && g; i++) run_set_values(w, from + i, g->all[i].values);
        const whirl_status status =
            g ? run_carry(w, g, count, numbers + from * w->count, k == 0 ? speeds : NULL, times, &row)
              : whirl_fail(WHIRL_NO_MEMORY, "no memory for the runs of a fit");
        free(g);
        // The first group that fails is reported.
#pragma omp critical(whirl_fit)
        if (status.code != WHIRL_OK && k < failed) {
            failed = k;
            first = status;
            *lost = row;
        }
    }
    return first;
}

/// Derives the numbers by all unknowns: slopes [count][unknowns].
static void run_derive(const run_work *w, const double *numbers, double *slopes) {
    const whirl_fit *fit = w->place->of->fit;
    for (size_t u = 0; u < fit->unknown_count; u++) {
        const run_stencil *stencil;
        const double h = run_choose(w, &fit->unknowns[u], w->place->values[u], &stencil);
        for (size_t i = 0; i < w->count; i++) {
            double sum = stencil->own * numbers[i];
            for (size_t k = 0; k < RUN_STENCIL; k++)
                sum += stencil->weights[k] * numbers[(1 + RUN_STENCIL * u + k) * w->count + i];
            slopes[i * fit->unknown_count + u] = sum / h;
        }
    }
}

/// Sets what is the same for all runs of a motion.
static void run_begin(run_work *w, const fit_place *p) {
    *w = (run_work){.place = p,
                    .run = p->motion->run,
                    .together = RUN_TOGETHER,
                    .difference = run_difference,
                    .record = whirl_record_default()};
    whirl_analysis_add(&w->runup, "runup");
    w->record.runup = *w->run->options;
}

whirl_status fit_run(const fit_place *p, fit_orbit *tried, double *model, double *slopes, size_t *lost) {
    // Find the numbers of the run.
    const whirl_fit *fit = p->of->fit;
    run_work w;
    run_begin(&w, p);
    const size_t rows = w.run->count, end = w.run->first + rows, runs = 1 + RUN_STENCIL * fit->unknown_count;
    while (w.first < fit->number_count && fit->numbers[w.first].motion < w.run->first) w.first++;
    while (w.first + w.count < fit->number_count && fit->numbers[w.first + w.count].motion < end) w.count++;
    if (w.run->waveform) w.instants = run_count_instants(&w);
    // Carry out the runs, and derive their numbers.
    double *numbers = calloc(runs * w.count + 2 * rows + 1, sizeof *numbers);
    double *speeds = numbers + runs * w.count, *times = speeds + rows;
    whirl_status status =
        numbers ? run_make_layout(&w) : whirl_fail(WHIRL_NO_MEMORY, "no memory for the runs of a fit");
    if (status.code == WHIRL_OK) status = run_all(&w, numbers, speeds, times, lost);
    if (status.code == WHIRL_OK) {
        memcpy(model + w.first, numbers, w.count * sizeof *model);
        run_derive(&w, numbers, slopes + w.first * fit->unknown_count);
    }
    // Nothing is followed: the next run begins at its machine's start, too.
    for (size_t i = 0; i < rows && status.code == WHIRL_OK; i++) {
        status = fit_place_note(p, 0, NULL, NULL, &tried[w.run->first + i]);
        if (status.code != WHIRL_OK) break;
        tried[w.run->first + i].speed = speeds[i];
        tried[w.run->first + i].time = times[i];
    }
    free(numbers);
    return status;
}

/// Fails for a run that ends before a time of its table, or begins at another speed than its record.
static whirl_status run_check_table(const run_work *w, const whirl_machine *machine) {
    static const double same = 0.05;
    const whirl_fit *fit = w->place->of->fit;
    const double length = run_length(machine, machine->run ? machine->run : &w->record.runup);
    const double speed = run_first_speed(machine);
    if (w->run->first_speed > 0.0 && fabs(speed - w->run->first_speed) > same * w->run->first_speed)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the run of entry %zu of the data begins at %.6g rad/s, and its record at %.6g rad/s",
                          w->run->set + 1, speed, w->run->first_speed);
    if (!w->run->by_time || !(length > 0.0)) return whirl_ok();
    for (size_t i = 0; i < fit->number_count; i++) {
        const whirl_fit_number *number = &fit->numbers[i];
        const whirl_fit_motion *motion = &fit->motions[number->motion];
        if (motion->run != w->run) continue;
        const double table = w->run->waveform ? number->at : motion->time, time = table - machine->delay;
        if (time < 0.0 || time > length * (1.0 + 1e-9))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the time %.10g s of entry %zu of the data is outside of its run, which lasts from %.10g "
                              "to %.10g s",
                              table, w->run->set + 1, machine->delay, machine->delay + length);
    }
    return whirl_ok();
}

whirl_status fit_runs_check(const whirl_study *study, const whirl_batch *batch) {
    const fit_motions motions = {.study = study, .batch = batch, .fit = batch->fit};
    const whirl_fit *fit = batch->fit;
    double values[WHIRL_MAX_UNKNOWNS];
    for (size_t u = 0; u < fit->unknown_count; u++) values[u] = fit->unknowns[u].start;
    for (size_t i = 0; i < fit->motion_count; i++) {
        if (!fit->motions[i].run || fit->motions[i].run->first != i) continue;
        fit_place p;
        run_work w;
        whirl_machine machine = {.system = NULL};
        fit_place_make(&p, &motions, i, values);
        run_begin(&w, &p);
        run_request(&p, w.runup, &w.record);
        p.batch.outline = true;
        whirl_status status = fit_place_machine(&p, &machine);
        if (status.code == WHIRL_OK) status = run_check_table(&w, &machine);
        if (machine.release) machine.release(machine.owner);
        if (status.code != WHIRL_OK) return status;
    }
    return whirl_ok();
}
