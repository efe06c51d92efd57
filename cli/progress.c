#include "progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "interrupt.h"
#include "terminal.h"

enum { MAX_COLUMNS = 120, MAX_BAR = 40 };

progress_view progress_begin(void) {
    return (progress_view){.terminal = is_terminal(STDERR_FILENO)};
}

void duration_text(double seconds, char *text, size_t size) {
    const long whole = lround(fmin(fmax(seconds, 0), 1e8));
    if (whole < 60)
        snprintf(text, size, "%ld s", whole);
    else if (whole < 3600)
        snprintf(text, size, "%ld:%02ld min", whole / 60, whole % 60);
    else
        snprintf(text, size, "%ld:%02ld h", whole / 3600, whole / 60 % 60);
}

static double done_share(const whirl_progress *progress) {
    return progress->revolutions_total > 0 ? fmin(progress->revolutions_done / progress->revolutions_total, 1) : 0;
}

/// Writes the state of a run: "37 %, 190 of 521 points, 5310 revolutions/s, 1:04 min left", with "refining, round 2: "
/// or "from neighbours, round 2: " before it in these stages.
static void state_text(const whirl_progress *progress, char *text, size_t size) {
    const double computed = progress->revolutions_done - progress->revolutions_recalled;
    const double rate = progress->seconds > 0 ? computed / progress->seconds : 0;
    char left[32] = "?", round[48] = "";
    // No rate is known in the first second: the first revolutions of all lanes are reported late.
    const bool known =
        rate > 0 && (progress->seconds >= 1.0 || progress->revolutions_done >= progress->revolutions_total);
    const double needed = known ? (progress->revolutions_total - progress->revolutions_done) / rate : (double)INFINITY;
    const double seconds = fmin(needed, interrupt_left());
    if (isfinite(seconds)) duration_text(seconds, left, sizeof left);
    if (progress->round > 0)
        snprintf(round, sizeof round,
                 "%s, round %d: ", progress->stage == WHIRL_STAGE_NEIGHBOURS ? "from neighbours" : "refining",
                 progress->round);
    if (progress->stage == WHIRL_STAGE_TABLES) {
        snprintf(text, size, "%3.0f %%, %zu of %zu film tables made", floor(100 * done_share(progress)),
                 progress->points_done, progress->points_total);
        return;
    }
    // Points at rest have no revolutions, and count as one each.
    const bool resting = progress->revolutions_total == (double)progress->points_total;
    // A point may take minutes, such as a run-up: then only the share done is shown, without points per second.
    char speed[48] = "";
    if (!resting || rate >= 1.0) snprintf(speed, sizeof speed, " %.0f %s/s,", rate, resting ? "points" : "revolutions");
    snprintf(text, size, "%s%3.0f %%, %zu of %zu points%s,%s %s left", round, floor(100 * done_share(progress)),
             progress->points_done, progress->points_total, progress->stage == WHIRL_STAGE_CONFIRM ? " confirmed" : "",
             speed, left);
}

static void draw_bar(const whirl_progress *progress, const char *state) {
    const int columns = terminal_columns(STDERR_FILENO), width = columns < MAX_COLUMNS ? columns : MAX_COLUMNS;
    int bar = width - (int)strlen(state) - 5;
    if (bar > MAX_BAR) bar = MAX_BAR;
    if (bar < 4) {
        fprintf(stderr, "\r%.*s\033[K", width - 1, state);
        return;
    }
    const int filled = (int)(done_share(progress) * bar);
    fputs("\r[", stderr);
    for (int i = 0; i < bar; i++) fputc(i < filled ? '=' : ' ', stderr);
    fprintf(stderr, "] %s\033[K", state);
}

void progress_show(void *view_pointer, const whirl_progress *progress) {
    progress_view *const view = view_pointer;
    char state[160];
    state_text(progress, state, sizeof state);
    if (view->terminal) {
        draw_bar(progress, state);
        view->drawn = true;
        return;
    }
    const int tenth = (int)(10 * done_share(progress));
    // Shares start from 0 again in a round of refinement or with another method, and fall if a map needs more points.
    const bool more = progress->stage == view->stage && view->points > 0 && progress->points_total > view->points;
    const bool goes_on = progress->round == view->round && progress->seconds >= view->seconds && !more;
    view->seconds = progress->seconds;
    view->stage = progress->stage;
    view->points = progress->points_total;
    if (goes_on && tenth <= view->last_tenth) return;
    view->round = progress->round;
    view->last_tenth = tenth;
    fprintf(stderr, "whirl: %s\n", state);
}

void progress_end(progress_view *view) {
    if (view->drawn) fputs("\r\033[K", stderr);
    view->drawn = false;
}
