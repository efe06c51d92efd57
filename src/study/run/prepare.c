// Tables of films are made before the points of a study, by all threads.
#include <omp.h>
#include <stdlib.h>

#include "clock.h"
#include "first_error.h"
#include "passes.h"
#include "whirl/engine/film_tables.h"

/// Points of which the tables are made beforehand, over all batches; those of others are made when their turn comes.
enum { PREPARED = 64 };

/// A point of a batch.
typedef struct place {
    size_t batch, point;
} place;

/// How far it is.
typedef struct preparation {
    const whirl_study *study;
    const whirl_run_options *options;
    size_t count, tables; ///< of places, and of tables that are missing in the beginning
    place places[PREPARED];
    double started, told;
    first_error error;
} preparation;

/// Builds the machine of a point and lets it go; what it needs stays. What is wrong with it is found where it is used.
static whirl_status visit(const whirl_study *study, const place *at, bool outline, const volatile bool *stop) {
    whirl_batch batch = study->batches[at->batch];
    whirl_machine machine;
    batch.outline = outline;
    batch.integrate.stop = stop;
    const whirl_status status = whirl_study_machine(study, &batch, at->point, &machine);
    if (status.code == WHIRL_OK && machine.release) machine.release(machine.owner);
    return status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED ? status : whirl_ok();
}

/// Goes on with the outline of a point; its tables count among those that are asked for.
static whirl_status add_place(preparation *p, size_t batch, size_t point) {
    const place at = {batch, point};
    if (p->count == PREPARED) return whirl_ok();
    p->places[p->count++] = at;
    return visit(p->study, &at, true, NULL);
}

/// The first, the middle and the last point of every batch, by which methods are chosen; where these have different
/// tables, others between them.
static whirl_status choose_places(preparation *p) {
    whirl_status status = whirl_ok();
    size_t asked;
    for (size_t b = 0; b < p->study->batch_count && status.code == WHIRL_OK; b++) {
        const size_t count = p->study->batches[b].count, at[] = {0, count / 2, count - 1};
        for (size_t i = 0; i < 3 && status.code == WHIRL_OK; i++)
            if (i == 0 || at[i] != at[i - 1]) status = add_place(p, b, at[i]);
        // Machines of a study have the same elements.
        (void)whirl_film_tables_missing(&asked);
        if (asked == 0) return status;
    }
    const size_t most = PREPARED / (p->study->batch_count + 1);
    for (size_t b = 0; b < p->study->batch_count && status.code == WHIRL_OK; b++) {
        const size_t count = p->study->batches[b].count, some = count < most ? count : most;
        (void)whirl_film_tables_missing(&asked);
        for (size_t i = 0; i < some && status.code == WHIRL_OK; i++) {
            status = add_place(p, b, count * i / some);
        }
    }
    return status;
}

static void tell(preparation *p) {
    const double seconds = clock_seconds() - p->started;
    size_t asked;
    if (!p->options->progress || seconds - p->told < 0.2) return;
    const size_t missing = whirl_film_tables_missing(&asked);
    const size_t done = missing < p->tables ? p->tables - missing : 0;
    p->told = seconds;
    p->options->progress(p->options->context, &(whirl_progress){.stage = WHIRL_STAGE_TABLES,
                                                                .points_done = done,
                                                                .points_total = p->tables,
                                                                .revolutions_done = (double)done,
                                                                .revolutions_total = (double)p->tables,
                                                                .seconds = seconds});
}

whirl_status whirl_study_prepare(const whirl_study *study, const whirl_run_options *options) {
    preparation p = {.study = study, .options = options, .started = clock_seconds()};
    const int threads = options->threads > 0 ? options->threads : omp_get_num_procs();
    size_t asked;
    whirl_film_tables_watch();
    const whirl_status status = choose_places(&p);
    p.tables = whirl_film_tables_missing(&asked);
    if (status.code != WHIRL_OK || p.tables == 0) return status;
        // Threads that want the same table make it together: all of them go the same way.
#pragma omp parallel num_threads(threads)
    for (size_t i = 0; i < p.count; i++) {
        const whirl_status own = visit(study, &p.places[i], false, options->stop);
#pragma omp critical(whirl_prepare)
        {
            first_error_note(&p.error, &own);
            tell(&p);
        }
        if (own.code != WHIRL_OK) break;
    }
    return first_error_status(&p.error);
}
