// Tori that begin at the Neimark-Sacker points of branches. The branches' batch comes before theirs.
#include "kinds.h"
#include "pass.h"
#include "study_run.h"
#include "two_pi.h"

#include <math.h>
#include <stdlib.h>

#include "first_error.h"
#include "rows.h"
#include "settled.h"

/// A pass over tori.
typedef struct tori {
    rows rows;
    const whirl_table *branches;
    size_t *points; ///< [count] rows of the branches at which tori begin
    size_t count;
    bool ended; ///< a leg was stopped, or the table is full: no more are added
    first_error error;
} tori;

/// A branch of tori that begins at one Neimark-Sacker point.
typedef struct leg {
    size_t which; ///< index in tori.points
    whirl_trace start;
    whirl_torus_branch *found;
    whirl_torus_view **views; ///< [found->count]
    double end;               ///< reason if nothing was found
    bool stopped;             ///< the leg was stopped on the way: what was found is discarded
    first_error error;
} leg;

// ---------------------------------------------------------------- where tori begin

static bool begins_there(const whirl_table *branches, size_t row) {
    return *whirl_table_field(branches, row, WHIRL_FIELD_TRACE_SPECIAL, 0) == WHIRL_NEIMARK_SACKER &&
           *whirl_table_field(branches, row, WHIRL_FIELD_TRACE_REVOLUTIONS, 0) > 0.0;
}

static whirl_status tori_collect(tori *all) {
    const whirl_table *branches = all->branches;
    all->points = calloc(branches->count + 1, sizeof *all->points);
    if (!all->points) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the points at which tori begin");
    for (size_t row = 0; row < branches->count; row++)
        if (begins_there(branches, row)) all->points[all->count++] = row;
    return whirl_ok();
}

static bool tori_advance(void *context, double value, const whirl_torus *torus) {
    (void)value, (void)torus;
    return rows_go_on(context);
}

static whirl_torus_branch_options options_of(rows *r) {
    const whirl_trace_options *trace = &r->batch->record.trace;
    whirl_torus_branch_options options = whirl_torus_branch_default(r->batch->bounds[0], r->batch->bounds[1]);
    options.torus.integrate = settled_options(r->batch, 1).orbit.integrate;
    options.torus.tolerance = fmax(options.torus.tolerance, 100.0 * trace->rtol);
    options.torus.accuracy = trace->torus_accuracy;
    options.torus.most_nodes = whirl_trace_torus_nodes(trace);
    options.most_step = trace->torus_step;
    options.step = fmin(options.step, options.most_step);
    options.least_step = fmin(options.least_step, options.step);
    options.most_points = (size_t)trace->torus_points;
    options.found = tori_advance;
    options.context = r;
    options.stop = r->batch->stop;
    return options;
}

/// Finds the first torus: tries several distances from its orbit until one converges.
static whirl_status tori_begin(const whirl_family *family, const whirl_branch_point *point,
                               const whirl_torus_branch_options *options, whirl_torus **torus, double *value) {
    static const double steps[] = {0.005, 0.02, 0.001};
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        status = whirl_torus_begin(family, point, steps[i], options, torus, value);
        if (status.code != WHIRL_BAD_INPUT) break;
    }
    return status;
}

// ---------------------------------------------------------------- tori that are known

/// Returns the distance from the mean of a row's closed curve to the nearest state at which a revolution of an orbit
/// begins.
static double distance_from(const rows *r, size_t row, const whirl_orbit *orbit) {
    const size_t d = orbit->dimension, apart = orbit->segment_count / orbit->revolutions;
    const size_t count = (size_t)*rows_field(r, row, WHIRL_FIELD_TORUS_NODE_COUNT);
    const double *nodes = rows_field(r, row, WHIRL_FIELD_TORUS_NODES);
    double nearest = INFINITY;
    for (size_t k = 0; k < orbit->revolutions; k++) {
        double away = 0.0;
        for (size_t i = 0; i < d; i++) {
            double mean = 0.0;
            if (r->machine.system->turns && r->machine.system->turns[i] != 0.0) continue;
            for (size_t j = 0; j < count; j++) mean += nodes[j * d + i] / (double)count;
            away = fmax(away, fabs(mean - orbit->nodes[k * apart * d + i]));
        }
        nearest = fmin(nearest, away);
    }
    return nearest;
}

/// Returns true if the tori that end at a row shrink to the orbit of a Neimark-Sacker point.
static bool shrinks_to(const rows *r, size_t row, const whirl_branch_point *point) {
    const double near = 0.01 * fabs(r->batch->bounds[1] - r->batch->bounds[0]), near_turn = 0.05;
    const double angle = two_pi * *rows_field(r, row, WHIRL_FIELD_TORUS_ROTATION);
    return *rows_field(r, row, WHIRL_FIELD_TORUS_END) == WHIRL_TORUS_SHRANK &&
           *rows_field(r, row, WHIRL_FIELD_TORUS_REVOLUTIONS) == (double)point->orbit->revolutions &&
           fabs(*rows_field(r, row, WHIRL_FIELD_TORUS_LIMIT) - point->value) <= near &&
           fabs(cos(angle) - cos(point->angle)) <= near_turn &&
           distance_from(r, row, point->orbit) <= 2.0 * *rows_field(r, row, WHIRL_FIELD_TORUS_RADIUS);
}

/// Returns true if a known branch of tori, begun elsewhere, ends at that point.
static bool tori_is_taken(const rows *r, const whirl_branch_point *point) {
    bool taken = false;
    for (size_t row = 0; row < r->count && !taken; row++) taken = shrinks_to(r, row, point);
    return taken;
}

// ---------------------------------------------------------------- following

static void free_leg(leg *one) {
    for (size_t i = 0; one->views && i < one->found->count; i++) whirl_torus_view_free(one->views[i]);
    free(one->views);
    whirl_torus_branch_free(one->found);
    whirl_orbit_free(one->start.point.orbit);
}

static whirl_status tori_look(const whirl_family *family, const whirl_torus_branch_options *options, leg *one) {
    whirl_status status = whirl_ok();
    one->views = calloc(one->found->count + 1, sizeof(whirl_torus_view *));
    if (!one->views) return whirl_fail(WHIRL_NO_MEMORY, "no memory for views of tori");
    for (size_t i = 0; i < one->found->count && status.code == WHIRL_OK; i++) {
        const whirl_torus_point *point = &one->found->points[i];
        whirl_machine machine;
        status = family->machine(family->context, point->value, &machine);
        if (status.code != WHIRL_OK) return status;
        status = whirl_torus_look(machine.system, point->torus, &options->torus, &one->views[i]);
        if (machine.release) machine.release(machine.owner);
    }
    return status;
}

/// Follows a branch of tori. If none is found or can be followed, the leg's end says why.
static whirl_status tori_follow(tori *all, leg *one) {
    const whirl_family family = rows_family(&all->rows);
    const whirl_torus_branch_options options = options_of(&all->rows);
    const whirl_branch_point *point = &one->start.point;
    whirl_torus *first = NULL;
    double value;
    one->end = WHIRL_TORUS_NONE;
    whirl_status status = tori_begin(&family, point, &options, &first, &value);
    if (status.code != WHIRL_OK) return status.code == WHIRL_BAD_INPUT ? whirl_ok() : status;
    if (value < fmin(options.from, options.to) || value > fmax(options.from, options.to)) {
        one->end = WHIRL_TORUS_END_OF_RANGE;
        whirl_torus_free(first);
        return whirl_ok();
    }
    status = whirl_torus_follow(&family, first, value, value < point->value ? -1 : 1, &options, &one->found);
    whirl_torus_free(first);
    if (status.code == WHIRL_BAD_INPUT) return whirl_ok();
    return status.code == WHIRL_OK ? tori_look(&family, &options, one) : status;
}

/// Computes the leg of one point, unless another one ends there or a stop was requested.
static void work_at(tori *all, leg *one) {
    bool needed;
    whirl_status status = whirl_table_trace(all->branches, all->points[one->which], &one->start);
    first_error_note(&one->error, &status);
    if (status.code != WHIRL_OK) return;
#pragma omp critical(whirl_tori)
    needed = !all->ended && !tori_is_taken(&all->rows, &one->start.point);
    if (needed && rows_go_on(&all->rows)) status = tori_follow(all, one);
    one->stopped = !rows_go_on(&all->rows);
    if (!one->stopped) first_error_note(&one->error, &status);
}

// ---------------------------------------------------------------- rows

static whirl_status add_row(tori *all, const leg *one, size_t index, bool last) {
    rows *r = &all->rows;
    const whirl_torus_branch *found = one->found;
    const bool full = r->count + 1 == r->capacity;
    const whirl_torus_trace trace = {.system = r->machine.system,
                                     .torus = found ? found->points[index].torus : NULL,
                                     .view = found ? one->views[index] : NULL,
                                     .number = one->which + 1,
                                     .branch = one->start.branch,
                                     .point = all->points[one->which] + 1,
                                     .begins = one->start.point.value,
                                     .end = !found ? one->end
                                            : last ? (double)found->end
                                            : full ? (double)WHIRL_TORUS_END_OF_POINTS
                                                   : (double)NAN,
                                     .limit = found && last ? found->limit : (double)NAN};
    const whirl_status status =
        whirl_analyze_torus(&trace, &r->pass->record, &r->table->layout, rows_block(r, r->count));
    if (status.code == WHIRL_OK) rows_take(r, found ? found->points[index].value : trace.begins);
    return status;
}

static whirl_status add_rows(tori *all, const leg *one) {
    rows *r = &all->rows;
    const size_t first = r->count, count = one->found ? one->found->count : 1;
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && r->count < r->capacity && status.code == WHIRL_OK; i++)
        status = add_row(all, one, i, i + 1 == count);
    all->ended = r->count == r->capacity;
    return status.code == WHIRL_OK ? rows_keep(r, first, true) : status;
}

/// Adds a leg when its turn has come, unless an earlier one ends where it begins.
static void tori_add(tori *all, const leg *one) {
#pragma omp critical(whirl_tori)
    if (all->error.code == WHIRL_OK && !all->ended) {
        all->error = one->error;
        all->ended = one->stopped;
        if (all->error.code == WHIRL_OK && !one->stopped && !tori_is_taken(&all->rows, &one->start.point)) {
            const whirl_status added = add_rows(all, one);
            first_error_note(&all->error, &added);
        }
        all->rows.next++;
    }
}

/// Follows tori from all points in parallel; their rows keep the order of the points.
static void trace_tori(tori *all) {
    while (all->rows.next <= all->count && rows_recall(&all->rows, 1)) all->rows.next++;
    const size_t first = all->rows.next - 1, end = all->count;
#pragma omp parallel for ordered schedule(dynamic) num_threads(all->rows.run->threads)
    for (size_t which = first; which < end; which++) {
        leg one = {.which = which};
        work_at(all, &one);
#pragma omp ordered
        tori_add(all, &one);
        free_leg(&one);
    }
}

static whirl_status tori_work(study_run *run, const pass *p) {
    tori all = {.branches = whirl_result_role(run->result, WHIRL_ROLE_BRANCHES)};
    whirl_status status = rows_open(&all.rows, run, p);
    const bool wanted = status.code == WHIRL_OK && !all.rows.left_out;
    if (wanted) status = tori_collect(&all);
    if (wanted && status.code == WHIRL_OK) {
        trace_tori(&all);
        status = first_error_status(&all.error);
    }
    if (wanted) rows_go_on(&all.rows); // notices a stop
    rows_close(&all.rows);
    free(all.points);
    if (status.code != WHIRL_OK && status.code != WHIRL_STOPPED) tracker_fail(&run->tracker, &status);
    return whirl_ok();
}

const study_kind torus_kind = {.name = "torus", .piece = 0, .work = tori_work};
