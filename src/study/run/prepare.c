// Makes the film tables of a study before its points, on all threads.
#include <omp.h>
#include <stdlib.h>

#include "clock.h"
#include "film_tables.h"
#include "first_error.h"
#include "whirl/engine/study.h"
#include "whirl/internal/film_tables.h"

/// Points, over all batches, whose tables are made beforehand; other tables are made when their points are computed.
enum { PREPARED = 64 };

/// A point of a batch.
typedef struct place {
    size_t batch, point;
} place;

/// Progress of the preparation.
typedef struct preparation {
    const whirl_study *study;
    const whirl_run_options *options;
    size_t count; ///< number of places
    place places[PREPARED];
    whirl_film_tables tables; ///< tables of these points
    size_t missing;           ///< tables that must be made
    double started, reported;
    first_error error;
} preparation;

/// Builds and releases the machine of a point, which makes its tables. Errors of the machine are reported when the
/// point is computed.
static whirl_status prepare_visit(const whirl_study *study, const place *at, bool outline, const whirl_stop *stop) {
    whirl_batch batch = study->batches[at->batch];
    whirl_machine machine;
    batch.outline = outline;
    batch.stop = stop;
    const whirl_status status = whirl_study_machine(study, &batch, at->point, &machine);
    if (status.code == WHIRL_OK && machine.release) machine.release(machine.owner);
    return status.code == WHIRL_NO_MEMORY || status.code == WHIRL_STOPPED ? status : whirl_ok();
}

/// Adds a point to the places, and the tables of its outline to the set.
static whirl_status add_place(preparation *p, size_t batch, size_t point) {
    const place at = {batch, point};
    if (p->count == PREPARED) return whirl_ok();
    p->places[p->count++] = at;
    whirl_film_tables_watch(&p->tables);
    const whirl_status status = prepare_visit(p->study, &at, true, NULL);
    whirl_film_tables_watch(NULL);
    return status;
}

/// Chooses the first, the middle and the last point of every batch, which also decide the method; if these have
/// different tables, others between them.
static whirl_status choose_places(preparation *p) {
    whirl_status status = whirl_ok();
    size_t of_first = 0;
    for (size_t b = 0; b < p->study->batch_count && status.code == WHIRL_OK; b++) {
        const size_t count = p->study->batches[b].count, at[] = {0, count / 2, count - 1};
        for (size_t i = 0; i < 3 && status.code == WHIRL_OK; i++) {
            if (i == 0 || at[i] != at[i - 1]) status = add_place(p, b, at[i]);
            if (b == 0 && i == 0) of_first = whirl_film_tables_count(&p->tables);
            // All machines of a study have the same elements: if the first one has no tables, none has.
            if (of_first == 0) return status;
        }
    }
    if (whirl_film_tables_count(&p->tables) == of_first) return status;
    const size_t most = PREPARED / (p->study->batch_count + 1);
    for (size_t b = 0; b < p->study->batch_count && status.code == WHIRL_OK; b++) {
        const size_t count = p->study->batches[b].count, some = count < most ? count : most;
        for (size_t i = 0; i < some && status.code == WHIRL_OK; i++) status = add_place(p, b, count * i / some);
    }
    return status;
}

static void prepare_report(preparation *p) {
    const double seconds = clock_seconds() - p->started;
    if (!p->options->progress || seconds - p->reported < 0.2) return;
    const size_t missing = whirl_film_tables_missing(&p->tables);
    const size_t done = missing < p->missing ? p->missing - missing : 0;
    p->reported = seconds;
    p->options->progress(p->options->context, &(whirl_progress){.stage = WHIRL_STAGE_TABLES,
                                                                .points_done = done,
                                                                .points_total = p->missing,
                                                                .revolutions_done = (double)done,
                                                                .revolutions_total = (double)p->missing,
                                                                .seconds = seconds});
}

whirl_status whirl_study_prepare(const whirl_study *study, const whirl_run_options *options) {
    preparation p = {.study = study, .options = options, .started = clock_seconds()};
    const int threads = options->threads > 0 ? options->threads : omp_get_num_procs();
    const whirl_status status = choose_places(&p);
    p.missing = whirl_film_tables_missing(&p.tables);
    if (status.code != WHIRL_OK || whirl_film_tables_count(&p.tables) == 0) return status;
        // Threads that want the same table make it together, so all threads visit the points in one order.
#pragma omp parallel num_threads(threads)
    for (size_t i = 0; i < p.count; i++) {
        const whirl_status own = prepare_visit(study, &p.places[i], false, options->stop);
#pragma omp critical(whirl_prepare)
        {
            first_error_note(&p.error, &own);
            prepare_report(&p);
        }
        if (own.code != WHIRL_OK) break;
    }
    return first_error_status(&p.error);
}

whirl_status study_add_film_tables(const whirl_study *study, whirl_result *result) {
    char text[WHIRL_FILM_TABLES_TEXT];
    preparation p = {.study = study};
    const whirl_status status = choose_places(&p);
    if (status.code != WHIRL_OK) return status;
    whirl_film_tables_text(&p.tables, text);
    return *text ? whirl_result_add_fact(result, "film tables", text) : whirl_ok();
}
