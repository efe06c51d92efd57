#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "approach.h"
#include "archive.h"
#include "metric.h"
#include "orbit_search.h"
#include "orbits.h"
#include "section.h"
#include "settling.h"
#include "turns.h"

/// Longest orbit that is searched while a motion settles: two of its returns must fit into the kept states.
enum { MAX_REPEATS = 40 };

/// Newton's method is tried if returns are within `near_enough` of the state's size, and have shrunk to `has_shrunk` of
/// the returns before.
static const double near_enough = 3e-3, has_shrunk = 0.75;

/// A return agrees with its prediction if they differ by at most this share of the distance by which the return
/// shortens.
static const double safety = 0.5;

/// fewest_returns: number of consecutive returns that must agree with their predictions. nearer: share of the first
/// distance to which these returns must have reduced it.
static const size_t fewest_returns = 3;
static const double nearer = 0.5;

struct approach {
    const whirl_system *system;
    const whirl_record_options *options;
    double noise;           ///< uncertainty of the state after a revolution, over the state's size
    int next;               ///< first revolution of the next attempt by Newton's method
    double spent;           ///< revolutions by Newton's method
    orbit_search *orbit;    ///< NULL: no stable one was found
    size_t past;            ///< revolutions of the orbit's present period that the motion has completed
    size_t good;            ///< consecutive returns that were predicted correctly
    double far;             ///< distance before the first of these returns
    double last;            ///< present distance
    double begun;           ///< distance when the orbit was found
    double least_shrinking; ///< least share by which a return shortens a distance, in the metric
    double *monodromy;      ///< [kept][kept]
    double *metric;         ///< [kept][kept] quadratic form of distances
    double *before, *now;   ///< [kept] distance from the orbit at the last return and at this one
    double *rest;           ///< [kept] error of the prediction
};

approach *approach_new(const whirl_system *system, const whirl_integrate_options *integrate,
                       const whirl_record_options *options) {
    approach *a = calloc(1, sizeof *a);
    if (!a) return NULL;
    a->system = system;
    a->options = options;
    a->noise = whirl_method_is_adaptive(integrate->method) ? fmax(1e-12, 100.0 * integrate->rtol) : 1e-12;
    return a;
}

static void leave_orbit(approach *a) {
    free(a->orbit);
    free(a->monodromy);
    a->orbit = NULL;
    a->monodromy = NULL;
}

void approach_free(approach *a) {
    if (!a) return;
    leave_orbit(a);
    free(a);
}

orbit_search *approach_orbit(const approach *a) {
    return a->orbit;
}

double approach_spent(const approach *a) {
    return a->spent;
}

/// Allocates the numbers that belong to an orbit: one block, monodromy first.
static bool approach_make_room(approach *a, size_t n) {
    a->monodromy = calloc(2 * n * n + 3 * n + 1, sizeof *a->monodromy);
    if (!a->monodromy) return false;
    a->metric = a->monodromy + n * n;
    a->before = a->metric + n * n;
    a->now = a->before + n;
    a->rest = a->now + n;
    return true;
}

void approach_archive(approach *a, archive *to) {
    size_t revolutions = a->orbit ? a->orbit->revolutions : 0;
    archive_part(to, &a->next, sizeof a->next);
    archive_part(to, &a->spent, sizeof a->spent);
    archive_count(to, &revolutions, MAX_REPEATS);
    if (revolutions == 0 || !to->sound) return;
    if (!a->orbit) {
        a->orbit = orbit_search_new(a->system, revolutions, NULL);
        if (!a->orbit || !approach_make_room(a, a->orbit->kept)) to->sound = false;
    }
    if (!to->sound) return;
    const size_t n = a->orbit->kept;
    orbit_search_archive(a->orbit, to);
    archive_part(to, &a->past, sizeof a->past);
    archive_part(to, &a->good, sizeof a->good);
    archive_part(to, &a->far, sizeof a->far);
    archive_part(to, &a->last, sizeof a->last);
    archive_part(to, &a->begun, sizeof a->begun);
    archive_part(to, &a->least_shrinking, sizeof a->least_shrinking);
    archive_part(to, a->monodromy, (2 * n * n + n) * sizeof *a->monodromy);
}

// ---------------------------------------------------------------- when to try

static double approach_distance(const approach *a, const double *x, const double *y) {
    double sum = 0.0;
    for (size_t i = 0; i < a->system->dimension; i++) {
        if (turns_on(a->system->turns, i)) continue;
        const double away = y ? short_way(a->system->angles, i, x[i] - y[i]) : x[i];
        sum += away * away;
    }
    return sqrt(sum);
}

/// Returns the largest of `count` returns after k revolutions, the last one `back` revolutions ago.
static double largest_return(const approach *a, const settling *s, size_t k, size_t back, size_t count) {
    double most = 0.0;
    for (size_t i = back; i < back + count; i++) {
        const double *x = settling_state(s, i), *before = settling_state(s, i + k);
        most = before ? fmax(most, approach_distance(a, x, before)) : (double)INFINITY;
    }
    return most;
}

/// Returns the number of successive returns that are compared with each other.
static size_t window_of(size_t k, int revolution) {
    const size_t longest = 32, eighth = (size_t)revolution / 8, least = k > 4 ? k : 4;
    return eighth < least ? least : eighth < longest ? eighth : longest;
}

/// Returns true if the motion nearly returns after k revolutions, and closer than before.
static bool closes_in(const approach *a, const settling *s, size_t k, int revolution, double size) {
    const size_t window = window_of(k, revolution);
    const double *first = settling_state(s, 2 * window + k - 1);
    if (!first || approach_distance(a, settling_state(s, 0), settling_state(s, k)) > near_enough * size) return false;
    const double late = largest_return(a, s, k, 0, window);
    if (late > near_enough * size) return false;
    return late <= a->noise * size || late <= has_shrunk * largest_return(a, s, k, window, window);
}

/// Returns the least divisor of k after which the motion returns nearly as well as after k. A motion may spiral towards
/// an orbit of a shorter period, and go round it once in k revolutions: then it returns closest after k.
static size_t approach_shortest(const approach *a, const settling *s, size_t k, size_t repeats, int revolution) {
    const double as_well = 3.0;
    const size_t window = window_of(k, revolution);
    const double late = largest_return(a, s, k, 0, window);
    for (size_t j = repeats; j < k; j += repeats)
        if (k % j == 0 && largest_return(a, s, j, 0, window) <= as_well * late) return j;
    return k;
}

size_t approach_tries(approach *a, const settling *s, int revolution) {
    enum { MIN_PAUSE = 4 };
    const size_t repeats = a->system->turns ? a->system->repeats : 1;
    if (a->orbit || revolution < a->next || repeats == 0) return 0;
    a->next = revolution + (revolution / 16 > MIN_PAUSE ? revolution / 16 : MIN_PAUSE);
    const double size = approach_distance(a, settling_state(s, 0), NULL);
    for (size_t k = repeats; k <= MAX_REPEATS && k <= (size_t)a->options->record; k += repeats)
        if (orbits_pay(a->system->dimension, a->options, k, a->spent) && closes_in(a, s, k, revolution, size))
            return approach_shortest(a, s, k, repeats, revolution);
    return 0;
}

// ---------------------------------------------------------------- what was found

/// Compares a return with its prediction by the derivative. The prediction is correct if its error is below `safety`
/// times the distance by which the return shortens.
static void note_return(approach *a, const double *x) {
    const size_t n = a->orbit->kept;
    const double from = metric_length(n, a->metric, a->before);
    double rest = 0.0;
    orbit_search_difference(a->orbit, x, a->now);
    for (size_t i = 0; i < n; i++) {
        a->rest[i] = a->now[i];
        for (size_t k = 0; k < n; k++) a->rest[i] -= a->monodromy[i * n + k] * a->before[k];
        rest += a->rest[i] * a->rest[i];
    }
    const bool predicted = sqrt(rest) <= a->noise * approach_distance(a, x, NULL) ||
                           metric_length(n, a->metric, a->rest) <= safety * a->least_shrinking * from;
    if (a->good == 0) a->far = from;
    a->good = predicted ? a->good + 1 : 0;
    memcpy(a->before, a->now, n * sizeof *a->now);
    a->last = metric_length(n, a->metric, a->now);
}

/// Checks the returns that are already known.
static void note_past(approach *a, const settling *s) {
    const size_t k = a->orbit->revolutions;
    size_t known = 0;
    while (settling_state(s, (known + 1) * k)) known++;
    orbit_search_difference(a->orbit, settling_state(s, known * k), a->before);
    a->past = a->good = 0;
    a->last = metric_length(a->orbit->kept, a->metric, a->before);
    while (known > 0) note_return(a, settling_state(s, --known * k));
    a->begun = a->last;
}

/// Computes the metric in which the map about the orbit shortens distances. Returns false if the orbit is not stable.
static bool approach_measure(approach *a, bool *memory) {
    const double margin = 1e-6;
    const size_t n = a->orbit->kept;
    const whirl_multiplier *largest = a->orbit->values;
    double *work = malloc((3 * n * n + 1) * sizeof *work);
    *memory = work && approach_make_room(a, n);
    bool stable = *memory && a->orbit->found && (n == 0 || hypot(largest->real, largest->imaginary) < 1.0 - margin);
    if (stable) {
        orbit_search_monodromy(a->orbit, a->monodromy, work);
        stable = metric_make(n, a->monodromy, a->metric, &a->least_shrinking, work);
    }
    free(work);
    return stable;
}

whirl_status approach_take(approach *a, orbit_search *s, const settling *states, int revolution) {
    enum { MIN_PAUSE = 8 };
    bool memory;
    a->spent += s->carried;
    a->next = revolution + (revolution / 4 > MIN_PAUSE ? revolution / 4 : MIN_PAUSE);
    a->orbit = s;
    if (approach_measure(a, &memory))
        note_past(a, states);
    else
        leave_orbit(a);
    return memory ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to look for an orbit");
}

void approach_goes_on(approach *a, const settling *states) {
    const double gone = 4.0;
    if (!a->orbit) return;
    a->past++;
    if (a->past % a->orbit->revolutions != 0) return;
    note_return(a, settling_state(states, 0));
    if (a->last > gone * a->begun) leave_orbit(a);
}

bool approach_arrives(const approach *a, const settling *states) {
    const double rounding = 10.0;
    if (!a->orbit || a->past % a->orbit->revolutions != 0 || a->good < fewest_returns) return false;
    return a->last <= nearer * a->far ||
           a->last <= rounding * a->noise * approach_distance(a, settling_state(states, 0), NULL);
}
