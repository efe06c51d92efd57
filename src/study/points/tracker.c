#include "tracker.h"

#include "clock.h"

/// Seconds between two reports.
static const double report_interval = 0.2;

void tracker_begin(tracker *t, const whirl_run_options *options, double revolutions) {
    *t = (tracker){.options = options, .progress = {.revolutions_total = revolutions}, .started = clock_seconds()};
}

void tracker_stage(tracker *t, whirl_stage stage, size_t points) {
    t->progress.stage = stage;
    t->progress.points_done = 0;
    t->progress.points_total = points;
}

void tracker_round(tracker *t, int round, size_t points, double revolutions) {
    t->progress = (whirl_progress){
        .stage = WHIRL_STAGE_REFINE, .round = round, .points_total = points, .revolutions_total = revolutions};
    t->started = clock_seconds();
    t->reported = 0.0;
}

void tracker_neighbours(tracker *t, int round, size_t points, double revolutions) {
    tracker_round(t, round, points, revolutions);
    t->progress.stage = WHIRL_STAGE_NEIGHBOURS;
}

void tracker_follow(tracker *t, int round, size_t motions, double revolutions) {
    tracker_round(t, round, motions, revolutions);
    t->progress.stage = WHIRL_STAGE_FOLLOW;
}

/// Reports if it is time to, and checks whether the run must end.
static void look_around(tracker *t) {
    const double seconds = clock_seconds() - t->started;
    if (t->options->progress && seconds - t->reported >= report_interval) {
        t->reported = t->progress.seconds = seconds;
        t->options->progress(t->options->context, &t->progress);
    }
    if (whirl_stop_is_set(t->options->stop)) atomic_store(&t->halt, true);
}

bool tracker_advance(tracker *t, double revolutions, size_t points) {
#pragma omp critical(whirl_tracker)
    {
        t->progress.revolutions_done += revolutions;
        t->progress.points_done += points;
        look_around(t);
    }
    return !atomic_load(&t->halt);
}

void tracker_recall(tracker *t, double revolutions, size_t points) {
#pragma omp critical(whirl_tracker)
    {
        t->progress.revolutions_done += revolutions;
        t->progress.revolutions_recalled += revolutions;
        t->progress.points_done += points;
        look_around(t);
    }
}

void tracker_add(tracker *t, double revolutions, size_t points) {
#pragma omp critical(whirl_tracker)
    {
        t->progress.revolutions_total += revolutions;
        t->progress.points_total += points;
    }
}

void tracker_lack(tracker *t, double revolutions, size_t points) {
#pragma omp critical(whirl_tracker)
    {
        t->progress.revolutions_total -= revolutions;
        t->progress.points_total -= points;
    }
}

void tracker_fail(tracker *t, const whirl_status *status) {
#pragma omp critical(whirl_tracker)
    {
        first_error_note(&t->error, status);
        atomic_store(&t->halt, true);
    }
}

void tracker_end(tracker *t) {
    t->progress.seconds = clock_seconds() - t->started;
    if (t->options->progress) t->options->progress(t->options->context, &t->progress);
}
