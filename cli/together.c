#include "together.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "interrupt.h"
#include "progress.h"
#include "ranks.h"

/// Indices of the numbers that all ranks see (ranks_add). Those before WORD_LEFT count, for each batch and pass, the
/// points that were dealt out.
enum {
    WORD_LEFT = 2 * WHIRL_MAX_BATCHES, ///< number of ranks that are done
    WORD_THREADS,                      ///< number of threads of all ranks
    WORD_SHARED                        ///< first of the numbers that ranks exchange
};

_Static_assert((int)WORD_SHARED + (int)SHARED_NUMBERS <= (int)RANKS_WORDS, "the ranks see fewer numbers");
_Static_assert((int)SHARED_NUMBERS <= (int)RANKS_MAX, "ranks exchange fewer numbers at once");

// ---------------------------------------------------------------- opening

int open_together(const journal_wish *wish, const whirl_case *object, run_journal *journal, whirl_result **finished,
                  bool *all_done) {
    const int number = ranks_number(), count = ranks_count();
    journal_names there = {0};
    int outcome = EXIT_DONE;
    *finished = NULL;
    if (number == 0) outcome = open_journal(wish, object, journal, finished);
    *all_done = *finished != NULL;
    outcome = ranks_agree(outcome);
    if (count == 1 || outcome != EXIT_DONE) return outcome;
    ranks_share(all_done, sizeof *all_done);
    if (number > 0) there = find_journals(wish->output);
    // All ranks must have looked for existing journals before any rank begins its own.
    ranks_agree(EXIT_DONE);
    if (number > 0 && !*all_done) outcome = open_rank_journal(wish, object, &there, journal);
    free_journal_names(&there);
    outcome = ranks_agree(outcome);
    if (outcome != EXIT_DONE) abandon_journal(journal);
    return outcome;
}

// ---------------------------------------------------------------- known points

static int make_known(together *t, const whirl_case *object) {
    whirl_result *outline = NULL;
    size_t size = 0;
    const whirl_status status = whirl_case_outline(object, &outline);
    if (status.code != WHIRL_OK) return complain_of(&status);
    t->batch_count = outline->table_count;
    for (size_t i = 0; i < 2 * t->batch_count; i++) size += t->slots[i] = outline->tables[i % t->batch_count].count;
    whirl_result_free(outline);
    t->all_known = calloc(size + 1, 1);
    const whirl_status made = t->all_known ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for %zu points", size);
    for (size_t i = 0, at = 0; t->all_known && i < 2 * t->batch_count; at += t->slots[i++])
        t->known[i] = t->all_known + at;
    return complain_of(&made);
}

/// Sends to all ranks which points the first rank's journal has.
static void share_known(together *t) {
    size_t size = 0, points = 0, known = 0;
    for (size_t i = 0; i < 2 * t->batch_count; size += t->slots[i++])
        for (size_t slot = 0; slot < t->slots[i] && ranks_number() == 0; slot++) {
            t->known[i][slot] = whirl_journal_has(t->journal->journal, i, slot);
            points += i < t->batch_count;
            known += i < t->batch_count && t->known[i][slot];
        }
    t->known_share = points > 0 ? (double)known / (double)points : 0.0;
    ranks_share(t->all_known, size);
}

int together_begin(together *t, const whirl_case *object, run_journal *journal, int threads, progress_view *view) {
    *t = (together){.journal = journal, .view = view, .threads = threads};
    ranks_add(WORD_THREADS, threads);
    const int outcome = ranks_agree(make_known(t, object));
    if (outcome == EXIT_DONE) share_known(t);
    return outcome;
}

void together_free(together *t) {
    free(t->all_known);
    t->all_known = NULL;
}

// ---------------------------------------------------------------- dealing

static bool open_point(void *context, size_t batch, size_t slot) {
    const together *t = context;
    return !t->known[batch][slot];
}

/// Claims points for this rank: an eighth of its part of the remaining points, at the end single points. Returns their
/// number.
static size_t claim(void *context, size_t batch, size_t count, size_t *first) {
    together *t = context;
    const int64_t all = (int64_t)count, left = all - t->dealt[batch];
    const int64_t part = left * t->threads / (8 * (int64_t)t->dealer.threads);
    const int64_t wanted = part > 1 ? part : 1;
    const int64_t before = ranks_add(batch, wanted);
    t->dealt[batch] = before + wanted < all ? before + wanted : all;
    *first = (size_t)before;
    return before < all ? (size_t)(t->dealt[batch] - before) : 0;
}

// ---------------------------------------------------------------- while ranks compute

void together_look(void) {
    const int number = interrupt_signal();
    if (number) ranks_raise(WORD_SHARED + SHARED_STOP, number);
}

/// Adds this rank's work since the last exchange to the shared numbers, and reads those of all ranks. So a signal to
/// one rank reaches all, and a failure of one ends all.
static void exchange(together *t) {
    const whirl_progress *own = &t->own;
    int64_t now[SHARED_NUMBERS], all[SHARED_NUMBERS];
    memcpy(now, t->reported, sizeof now);
    now[own->stage == WHIRL_STAGE_CONFIRM ? SHARED_CONFIRMED : SHARED_POINTS] = (int64_t)own->points_done;
    now[SHARED_REVOLUTIONS] = (int64_t)own->revolutions_done;
    now[SHARED_RECALLED] = (int64_t)own->revolutions_recalled;
    for (size_t i = 0; i < SHARED_NUMBERS; i++) all[i] = t->gathered ? 0 : now[i] - t->reported[i];
    together_look();
    ranks_add_all(WORD_SHARED, SHARED_NUMBERS, all);
    memcpy(t->reported, now, sizeof now);
    t->shown = *own;
    t->shown.points_done = (size_t)all[own->stage == WHIRL_STAGE_CONFIRM ? SHARED_CONFIRMED : SHARED_POINTS];
    t->shown.revolutions_done = (double)all[SHARED_REVOLUTIONS];
    t->shown.revolutions_recalled = (double)all[SHARED_RECALLED];
    t->failed = t->failed || all[SHARED_FAILED] > 0;
    if (t->failed) interrupt_pass_on(SIGTERM);
    if (all[SHARED_STOP] > 0 && !interrupt_signal()) interrupt_pass_on((int)all[SHARED_STOP]);
}

/// Prepares the progress that is shown while points are gathered; only points that were unknown before count.
static void show_gathered(together *t) {
    t->shown = t->own;
    if (t->own.stage <= WHIRL_STAGE_CONFIRM) t->shown.revolutions_recalled = t->known_share * t->own.revolutions_done;
}

static void show(together *t) {
    exchange(t);
    if (t->gathered) show_gathered(t);
    if (t->view && t->own.points_total > 0) progress_show(t->view, &t->shown);
}

static void on_progress(void *context, const whirl_progress *own) {
    const double interval = 0.5; // s: an exchange makes other ranks than the first wait for an answer
    together *t = context;
    if (ranks_number() > 0 && own->seconds < t->own.seconds + interval) return;
    t->own = *own;
    show(t);
}

// ---------------------------------------------------------------- gathering

static whirl_status gather(void *context) {
    enum { ROUNDS = 100 }; // rests of some milliseconds between two exchanges
    together *t = context;
    for (int rests = 0; ranks_add(WORD_LEFT, 0) < ranks_count() - 1 && !t->failed; rests++) {
        if (rests % ROUNDS == 0) show(t);
        ranks_rest();
    }
    exchange(t);
    if (t->failed) return whirl_fail(WHIRL_IO_ERROR, "another rank has failed");
    t->gathered = true;
    return take_rank_journals(t->journal, ranks_count());
}

void together_leave(int outcome) {
    together_look();
    if (outcome == EXIT_DONE || outcome == EXIT_UNFINISHED)
        ranks_add(WORD_LEFT, 1);
    else
        ranks_raise(WORD_SHARED + SHARED_FAILED, 1);
}

void together_join(together *t, whirl_run_options *how) {
    t->dealer = (whirl_dealer){.threads = (int)ranks_add(WORD_THREADS, 0),
                               .open = open_point,
                               .claim = claim,
                               .gather = ranks_number() == 0 ? gather : NULL,
                               .context = t};
    how->dealer = &t->dealer;
    how->progress = on_progress;
    how->context = t;
}
