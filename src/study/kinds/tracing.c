// Branches of orbits, and curves of their special points over two parameters. The table ends with as many points as
// were found.
#include "kinds.h"
#include "pass.h"
#include "study_run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "first_error.h"
#include "rows.h"
#include "settled.h"

/// A branch to be followed from an orbit.
typedef struct leg {
    whirl_orbit *orbit;
    double value;
    int direction;
    whirl_branch *branch; ///< the branch that was found
    first_error error;    ///< why no branch was found
} leg;

enum { MAX_LEGS = 2 };

static whirl_status tracing_machine_of(const rows *r, double value, whirl_machine *machine) {
    return r->run->study->machine(r->run->study->family, r->batch, value, machine);
}

static double span_of(const rows *r) {
    return fabs(r->batch->bounds[1] - r->batch->bounds[0]);
}

static void free_legs(leg legs[MAX_LEGS]) {
    for (size_t i = 0; i < MAX_LEGS; i++) {
        whirl_orbit_free(legs[i].orbit);
        whirl_branch_free(legs[i].branch);
        legs[i] = (leg){.orbit = NULL};
    }
}

// ---------------------------------------------------------------- known branches

/// Interpolates the orbit's node at a value between two rows of one branch. Near a pitchfork at which the branch ends,
/// orbits vary with the square root of the distance from it.
static void tracing_between(const rows *r, size_t row, double value, double *x) {
    const double *a = rows_nodes(r, row), *b = rows_nodes(r, row + 1), from = r->table->values[row];
    double share = (value - from) / (r->table->values[row + 1] - from);
    if (*rows_field(r, row + 1, WHIRL_FIELD_TRACE_END) == WHIRL_END_MIRRORED) share = 1.0 - sqrt(1.0 - share);
    for (size_t i = 0; i < r->run->dimension; i++) x[i] = a[i] + share * (b[i] - a[i]);
}

/// Searches from x, at a value, for an orbit of the same kind as `like`.
static whirl_status search_from(const rows *r, const whirl_system *system, const double *x, const whirl_orbit *like,
                                whirl_orbit **found) {
    const whirl_branch_options options = settled_options(r->batch, 1);
    if (like->period == 0.0) return whirl_orbit_rest(system, x, &options.orbit, found);
    if (like->revolutions == 0) return whirl_orbit_find_free(system, x, like->period, &options.orbit, found);
    return whirl_orbit_find(system, x, like->revolutions, &options.orbit, found);
}

/// Returns true if a search from x, at a value, finds the given orbit, at any of its revolutions. Near a crossing,
/// whose orbit is `crossing` (or NULL), orbits are ill-conditioned. There two orbits count as one if they are closer
/// than a tenth of their distance from the crossing's orbit.
static bool leads_to(const rows *r, double value, const double *x, const whirl_orbit *orbit,
                     const whirl_orbit *crossing) {
    whirl_machine machine;
    whirl_orbit *found = NULL;
    if (tracing_machine_of(r, value, &machine).code != WHIRL_OK) return false;
    bool same = search_from(r, machine.system, x, orbit, &found).code == WHIRL_OK;
    if (same) {
        const double apart = crossing ? whirl_orbit_distance(machine.system, found, crossing->nodes) : 0.0;
        same = whirl_orbit_distance(machine.system, found, orbit->nodes) <= fmax(1e-7, 0.1 * apart);
    }
    whirl_orbit_free(found);
    if (machine.release) machine.release(machine.owner);
    return same;
}

/// Returns true if the value lies between a row and the next one on one branch of orbits with as many revolutions.
static bool tracing_passes(const rows *r, size_t row, double value, const whirl_orbit *orbit) {
    const double *values = r->table->values + row;
    return rows_are_one(r, row, row + 1) &&
           *rows_field(r, row, WHIRL_FIELD_TRACE_REVOLUTIONS) == (double)orbit->revolutions &&
           (values[0] <= value) != (values[1] <= value);
}

/// Returns true if the orbit lies on a known branch: a search from some of its rows finds the same orbit. Orbits with a
/// free period begin at an arbitrary phase and are not compared.
static bool is_known(const rows *r, const whirl_orbit *orbit, double value, const whirl_orbit *crossing) {
    double *x = calloc(orbit->dimension + 1, sizeof *x);
    const bool compared = orbit->revolutions > 0 || orbit->period == 0.0;
    bool known = false;
    for (size_t row = 0; x && row + 1 < r->count && !known && compared; row++) {
        if (!tracing_passes(r, row, value, orbit)) continue;
        tracing_between(r, row, value, x);
        known = leads_to(r, value, x, orbit, crossing);
    }
    free(x);
    return known;
}

/// Returns true if a row's branch, which ended at a doubling, ended at this doubling: the row's value is within the
/// branch's last step of the doubling's, and a search from the mean of the two halves of the row's orbit finds the
/// doubling's orbit.
static bool ended_there(const rows *r, size_t row, const whirl_branch_point *doubling, double *x) {
    const size_t k = doubling->orbit->revolutions, d = doubling->orbit->dimension;
    const double *nodes = rows_nodes(r, row), *later = nodes + k * (size_t)r->batch->record.trace.segments * d;
    const double *values = r->table->values + row;
    const double near = fabs(values[0] - values[-1]) + 1e-6 * span_of(r);
    if (*rows_field(r, row, WHIRL_FIELD_TRACE_REVOLUTIONS) != 2.0 * (double)k ||
        fabs(values[0] - doubling->value) > near)
        return false;
    for (size_t i = 0; i < d; i++) x[i] = 0.5 * (nodes[i] + later[i]);
    return leads_to(r, doubling->value, x, doubling->orbit, NULL);
}

/// Returns true if a known branch ends at a doubling, and therefore is the one that begins there.
static bool tracing_is_taken(const rows *r, const whirl_branch_point *doubling) {
    double *x = calloc(doubling->orbit->dimension + 1, sizeof *x);
    bool taken = false;
    for (size_t row = 1; x && row < r->count && !taken; row++)
        taken = *rows_field(r, row, WHIRL_FIELD_TRACE_END) == WHIRL_END_HALVED && ended_there(r, row, doubling, x);
    free(x);
    return taken;
}

// ---------------------------------------------------------------- following

/// Returns true if the table has space for `count` more branches.
static bool has_room(const rows *r, size_t count) {
    return r->capacity - r->count >= 2 * count;
}

static void tracing_follow(rows *r, size_t count, leg legs[MAX_LEGS]) {
    const whirl_family family = rows_family(r);
    whirl_branch_options options = settled_options(r->batch, (r->capacity - r->count) / count);
    options.found = rows_found;
    options.context = r;
#pragma omp parallel for schedule(dynamic) num_threads(r->run->threads)
    for (size_t i = 0; i < count; i++) {
        const whirl_status status =
            whirl_branch_follow(&family, legs[i].orbit, legs[i].value, legs[i].direction, &options, &legs[i].branch);
        first_error_note(&legs[i].error, &status);
    }
}

/// Adds the points of the branches that were found, without legs that could not be followed. Nothing is added after a
/// stopped leg: the journal would keep it as if that leg did not exist.
static whirl_status add_found(rows *r, size_t count, size_t parent, const leg legs[MAX_LEGS]) {
    const bool going = rows_go_on(r);
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        const bool whole = legs[i].branch && legs[i].branch->end != WHIRL_END_STOPPED;
        if (legs[i].branch)
            status = rows_add(r, legs[i].branch, r->next + i, parent);
        else if (legs[i].error.code == WHIRL_NO_MEMORY)
            status = first_error_status(&legs[i].error);
        if (!going && !whole) break;
    }
    return status;
}

// ---------------------------------------------------------------- where branches begin

/// Finds the orbit on which a motion settles, and gives each leg a copy of it.
static whirl_status tracing_begin_settled(const rows *r, size_t count, leg legs[MAX_LEGS]) {
    whirl_status status = settled_orbit(r->run->study, r->batch, legs[0].value, &legs[0].orbit);
    for (size_t i = 1; i < count && status.code == WHIRL_OK; i++) {
        legs[i].orbit = whirl_orbit_copy(legs[0].orbit);
        if (!legs[i].orbit) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for an orbit");
    }
    return status;
}

/// Follows a branch in both directions, which both have to succeed.
static whirl_status follow_both(rows *r, size_t count, leg legs[MAX_LEGS]) {
    tracing_follow(r, count, legs);
    // A closed branch is complete: the other direction runs along the same one.
    if (legs[0].branch && legs[0].branch->end == WHIRL_END_CLOSED) count = 1;
    for (size_t i = 0; i < count; i++)
        if (!legs[i].branch && rows_go_on(r)) return first_error_status(&legs[i].error);
    return add_found(r, count, 0, legs);
}

/// Begins a branch and follows it in both directions, or in one at a bound of the parameter.
static whirl_status begin_at(rows *r, double value) {
    const double low = fmin(r->batch->bounds[0], r->batch->bounds[1]);
    const double high = fmax(r->batch->bounds[0], r->batch->bounds[1]);
    const size_t count = value > low && value < high ? 2 : 1;
    leg legs[MAX_LEGS] = {{.value = value, .direction = value < high ? 1 : -1}, {.value = value, .direction = -1}};
    whirl_status status = whirl_ok();
    if (!rows_recall(r, count)) {
        status = tracing_begin_settled(r, count, legs);
        if (!rows_go_on(r)) status = whirl_fail(WHIRL_STOPPED, "stopped");
        if (status.code == WHIRL_OK && has_room(r, count) && !is_known(r, legs[0].orbit, value, NULL))
            status = follow_both(r, count, legs);
    }
    free_legs(legs);
    r->next += count;
    return status;
}

/// Finds the orbits on both sides of a crossing, or the one that begins at a doubling or Hopf point.
static size_t tracing_leave(const rows *r, const whirl_branch_point *point, leg legs[MAX_LEGS]) {
    const whirl_branch_options options = settled_options(r->batch, 1);
    const whirl_family family = rows_family(r);
    const size_t sides = point->special == WHIRL_BRANCHING ? 2 : 1;
    const whirl_orbit *crossing = point->special == WHIRL_BRANCHING ? point->orbit : NULL;
    size_t count = 0;
    if (point->special == WHIRL_DOUBLING && tracing_is_taken(r, point)) return 0;
    for (size_t side = 0; side < sides; side++) {
        leg *one = &legs[count];
        // The step is small enough to meet no other event, and large enough for another orbit.
        const double step = (side == 0 ? 0.05 : -0.05) * options.step;
        const whirl_status status = whirl_branch_switch(&family, point, step, &options, &one->orbit, &one->value);
        if (status.code != WHIRL_OK) continue;
        const double low = fmin(options.from, options.to), high = fmax(options.from, options.to);
        one->direction = one->value < point->value ? -1 : 1;
        if (one->value < low || one->value > high || is_known(r, one->orbit, one->value, crossing)) {
            whirl_orbit_free(one->orbit);
            one->orbit = NULL;
        } else {
            count++;
        }
    }
    return count;
}

/// Finds the symmetric branch of a pitchfork at which a row's branch ends, in both directions: starts at a value next
/// to the pitchfork, where the symmetric orbit is unique.
static size_t leave_pitchfork(const rows *r, size_t row, const whirl_branch_point *point, leg legs[MAX_LEGS]) {
    const double aside = 1e-3 * span_of(r), before = r->table->values[row - 1];
    const double low = fmin(r->batch->bounds[0], r->batch->bounds[1]);
    const double high = fmax(r->batch->bounds[0], r->batch->bounds[1]);
    double value = point->value + (before > point->value ? -aside : aside);
    if (value < low || value > high) value = 2.0 * point->value - value;
    whirl_machine machine;
    whirl_orbit *orbit = NULL;
    if (tracing_machine_of(r, value, &machine).code != WHIRL_OK) return 0;
    const whirl_status status = search_from(r, machine.system, point->orbit->nodes, point->orbit, &orbit);
    if (machine.release) machine.release(machine.owner);
    const bool new = status.code == WHIRL_OK && !is_known(r, orbit, value, NULL);
    legs[0] = (leg){.orbit = orbit, .value = value, .direction = 1};
    legs[1] = (leg){.orbit = new ? whirl_orbit_copy(orbit) : NULL, .value = value, .direction = -1};
    return legs[1].orbit ? MAX_LEGS : 0;
}

static bool has_others(const rows *r, const whirl_branch_point *point) {
    const size_t twice = 2 * point->orbit->revolutions;
    return point->special == WHIRL_BRANCHING || point->special == WHIRL_HOPF ||
           (point->special == WHIRL_DOUBLING && twice <= (size_t)r->batch->record.trace.longest);
}

/// Follows the branches that begin at a special point, unless they are known.
static whirl_status follow_others(rows *r, const whirl_trace *at) {
    leg legs[MAX_LEGS] = {{.orbit = NULL}, {.orbit = NULL}};
    const bool pitchfork = at->end == WHIRL_END_MIRRORED && r->at > 0;
    whirl_status status = whirl_ok();
    size_t count = 0;
    if (!rows_recall(r, MAX_LEGS))
        count = pitchfork ? leave_pitchfork(r, r->at, &at->point, legs) : tracing_leave(r, &at->point, legs);
    if (count > 0 && has_room(r, count)) {
        tracing_follow(r, count, legs);
        if (pitchfork && legs[0].branch && legs[0].branch->end == WHIRL_END_CLOSED) count = 1;
        status = add_found(r, count, at->branch, legs);
    }
    free_legs(legs);
    r->next += MAX_LEGS;
    return status;
}

/// Follows the branches that begin at a row.
static whirl_status begin_along(rows *r) {
    whirl_trace trace;
    whirl_status status = rows_trace(r, r->at, &trace);
    if (status.code != WHIRL_OK) return status;
    if (has_others(r, &trace.point)) status = follow_others(r, &trace);
    whirl_orbit_free(trace.point.orbit);
    return status;
}

static bool tracing_continues(const rows *r) {
    return r->count < r->capacity && rows_go_on(r);
}

static whirl_status trace_branches(rows *r) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < r->batch->count && status.code == WHIRL_OK && tracing_continues(r); i++)
        status = begin_at(r, r->batch->values[i]);
    for (r->at = 0; r->at < r->count && status.code == WHIRL_OK && tracing_continues(r); r->at++)
        if (*rows_field(r, r->at, WHIRL_FIELD_TRACE_SPECIAL) != WHIRL_REGULAR &&
            rows_depth(r, r->at) < (size_t)r->batch->record.trace.switches)
            status = begin_along(r);
    return status;
}

// ---------------------------------------------------------------- curves

static whirl_status machine_in_plane(const void *context, double value, double second, whirl_machine *machine) {
    const rows *r = context;
    whirl_batch batch = *r->batch;
    batch.second_value = second;
    return r->run->study->machine(r->run->study->family, &batch, value, machine);
}

/// Returns true if a known curve of that kind passes through the value of the first parameter.
static bool is_on_curve(const rows *r, const whirl_branch_point *point) {
    const double near = 5e-3 * span_of(r), second = r->batch->second_value;
    for (size_t row = 0; row + 1 < r->count; row++) {
        const double a = *rows_field(r, row, WHIRL_FIELD_TRACE_SECOND) - second;
        const double b = *rows_field(r, row + 1, WHIRL_FIELD_TRACE_SECOND) - second;
        const double *values = r->table->values + row;
        if (!rows_are_one(r, row, row + 1) || *rows_field(r, row, WHIRL_FIELD_TRACE_SPECIAL) != (double)point->special)
            continue;
        if (a * b > 0.0 || a == b) continue;
        if (fabs(values[0] - a / (b - a) * (values[1] - values[0]) - point->value) < near) return true;
    }
    return false;
}

static void follow_curve(rows *r, const whirl_branch_point *start, leg legs[MAX_LEGS]) {
    const whirl_plane plane = {machine_in_plane, r};
    whirl_branch_options options = settled_options(r->batch, (r->capacity - r->count) / MAX_LEGS);
    const double bounds[2] = {fmin(r->batch->second_bounds[0], r->batch->second_bounds[1]),
                              fmax(r->batch->second_bounds[0], r->batch->second_bounds[1])};
    options.found = rows_found;
    options.context = r;
#pragma omp parallel for schedule(dynamic) num_threads(r->run->threads)
    for (int i = 0; i < MAX_LEGS; i++) {
        const whirl_status status = whirl_curve_follow(&plane, start, r->batch->second_value, i == 0 ? 1 : -1, bounds,
                                                       &options, &legs[i].branch);
        first_error_note(&legs[i].error, &status);
    }
}

/// Follows the curve through a special point; adds none if it cannot be followed.
static whirl_status trace_curve(rows *r, const whirl_trace *start) {
    leg legs[MAX_LEGS] = {{.orbit = NULL}, {.orbit = NULL}};
    whirl_status status = whirl_ok();
    if (!rows_recall(r, MAX_LEGS) && !is_on_curve(r, &start->point) && has_room(r, MAX_LEGS)) {
        follow_curve(r, &start->point, legs);
        status = add_found(r, MAX_LEGS, start->branch, legs);
    }
    free_legs(legs);
    r->next += MAX_LEGS;
    return status;
}

/// Follows the curves through the special points of the branches in the table before.
static whirl_status trace_curves(rows *r) {
    const whirl_table *branches = r->table - 1;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < branches->count && status.code == WHIRL_OK && tracing_continues(r); i++) {
        whirl_trace trace;
        const double kind = *whirl_table_field(branches, i, WHIRL_FIELD_TRACE_SPECIAL, 0);
        if (kind == WHIRL_REGULAR || kind == WHIRL_BRANCHING) continue;
        status = whirl_table_trace(branches, i, &trace);
        if (status.code == WHIRL_OK) status = trace_curve(r, &trace);
        if (status.code == WHIRL_OK) whirl_orbit_free(trace.point.orbit);
    }
    return status;
}

// ---------------------------------------------------------------- a pass

static whirl_status tracing_work(study_run *run, const pass *p) {
    rows r;
    whirl_status status = rows_open(&r, run, p);
    if (status.code == WHIRL_OK && !r.left_out) status = r.batch->second[0] ? trace_curves(&r) : trace_branches(&r);
    if (status.code == WHIRL_OK && !r.left_out) rows_go_on(&r); // notices a stop
    rows_close(&r);
    if (status.code != WHIRL_OK && status.code != WHIRL_STOPPED) tracker_fail(&run->tracker, &status);
    return whirl_ok();
}

const study_kind branch_kind = {.name = "branch", .piece = 0, .work = tracing_work};
