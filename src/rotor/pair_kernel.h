/// A disc on a shaft to a journal in a film, with a rub at the disc: the rotor of most studies of oil film and rub,
/// such as the paper of 2015. Integrators have their own loops for it (rk4_pair.inc, dop853_pair.inc), which consist
/// of these phases of an acceleration.
///
/// The phases call the same kernels in the same order as kernels/machine.c does from its lists, so that the bits are
/// the same. Three vectors are in progress at a time, so that the CPU's divider never waits.
#ifndef ROTOR_PAIR_KERNEL_H
#define ROTOR_PAIR_KERNEL_H

#include <stdbool.h>
#include <string.h>

#include "elements/contacts/rub_kernel.h"
#include "elements/films/film_kernel.h"
#include "elements/shafts/shaft_kernel.h"
#include "elements/shafts/station_kernel.h"
#include "lanes.h"
#include "pair.h"

/// Coordinates: those of the disc, which has the only contact, then those of the journal.
enum { PAIR_DEGREES = 4, PAIR_CONTACT = 0, PAIR_JOURNAL = 2 };

/// Coordinates whose sizes are measured together, as in whirl_lanes.
static const size_t pair_groups[] = {0, PAIR_JOURNAL, PAIR_DEGREES};

/// Indices of the first numbers of the parts.
enum {
    PAIR_DISC_NUMBERS = 0,
    PAIR_JOURNAL_NUMBERS = PAIR_DISC_NUMBERS + STATION_NUMBERS,
    PAIR_SHAFT_NUMBERS = PAIR_JOURNAL_NUMBERS + STATION_NUMBERS,
    PAIR_FILM_NUMBERS = PAIR_SHAFT_NUMBERS + SHAFT_NUMBERS,
    PAIR_RUB_NUMBERS = PAIR_FILM_NUMBERS + FILM_NUMBERS,
    PAIR_NUMBERS = PAIR_RUB_NUMBERS + RUB_NUMBERS
};

/// Accelerations in progress, one in each phase. Acceleration n, counted by `begun`, uses index n modulo FILM_PLACES.
typedef struct pair_line {
    bool balanced; ///< no journal has an unbalance (the usual case): its force is not computed
    size_t begun;
    const vec *number[FILM_PLACES], *q[FILM_PLACES], *v[FILM_PLACES];
    const vec *sides[FILM_PLACES];    ///< as for rub_kernel
    const void *forcing[FILM_PLACES]; ///< numbers that all lanes share, or vectors
    vec *a[FILM_PLACES];
    film_work film;
} pair_line;

enum { PAIR_UNDER_WAY = 3, PAIR_MAX_STRIDE = 4 };

/// Returns true if the journal of a vector has no unbalance in any lane.
VECTOR_INLINE bool pair_balanced(size_t stride, const vec *number) {
    const vec *journal = number + PAIR_JOURNAL_NUMBERS * stride;
    const vec in_phase = v_abs(journal[STATION_UNBALANCE_COS * stride]);
    return !v_any(v_less(v_set(0.0), v_max(in_phase, v_abs(journal[STATION_UNBALANCE_SIN * stride]))));
}

VECTOR_INLINE void pair_put(pair_line *line, size_t at, const vec *number, const void *forcing, const vec *sides,
                            const vec *q, const vec *v, vec *a) {
    line->number[at] = number;
    line->forcing[at] = forcing;
    line->sides[at] = sides;
    line->q[at] = q;
    line->v[at] = v;
    line->a[at] = a;
}

/// Begins an acceleration: starts the root of the film in the CPU's divider.
VECTOR_INLINE void pair_send(pair_line *line, size_t stride, const vec *number, const void *forcing, const vec *sides,
                             const vec *q, const vec *v, vec *a) {
    const element film = {.port = {2, 3}};
    const size_t at = line->begun++ % FILM_PLACES;
    film_begin(&film, stride, number + PAIR_FILM_NUMBERS * stride, v_set(2.0), q, v, &line->film, at);
    pair_put(line, at, number, forcing, sides, q, v, a);
}

/// Computes the accelerations by stations and shaft, which do not wait for the divider, in `frame`.
VECTOR_INLINE void pair_frame(const int *laws, size_t stride, const pair_line *line, size_t at, bool shared,
                              vec *frame) {
    const element shaft = {.port = {0, 1, 2, 3}, .law = laws[PAIR_SHAFT_LAW]};
    const vec *number = line->number[at], *q = line->q[at], *v = line->v[at], *own = line->forcing[at];
    const double *all = line->forcing[at];
    const size_t journal = PAIR_JOURNAL * stride;
    const vec c = shared ? v_set(all[COS_TAU]) : own[COS_TAU * stride];
    const vec s = shared ? v_set(all[SIN_TAU]) : own[SIN_TAU * stride];
    const vec c2 = shared ? v_set(all[COS_2TAU]) : own[COS_2TAU * stride];
    const vec s2 = shared ? v_set(all[SIN_2TAU]) : own[SIN_2TAU * stride];
    station_kernel(c, s, stride, number + PAIR_DISC_NUMBERS * stride, v, frame);
    if (line->balanced)
        station_balanced(stride, number + PAIR_JOURNAL_NUMBERS * stride, v + journal, frame + journal);
    else
        station_kernel(c, s, stride, number + PAIR_JOURNAL_NUMBERS * stride, v + journal, frame + journal);
    shaft_kernel(&shaft, c2, s2, stride, number + PAIR_SHAFT_NUMBERS * stride, q, frame);
}

/// Adds the accelerations by film and rub.
VECTOR_INLINE void pair_end(const int *laws, size_t stride, const pair_line *line, size_t at, vec *frame) {
    const element rub = {.port = {0, 1}, .law = laws[PAIR_RUB_LAW]};
    const vec *number = line->number[at];
    const size_t x = PAIR_JOURNAL * stride, y = x + stride;
    const film_state film = film_end(&line->film, at, v_set(1.57079632679489661923));
    vec *a = line->a[at];
    film_add(&film, number[(PAIR_FILM_NUMBERS + FILM_STRENGTH) * stride], &frame[x], &frame[y]);
    for (size_t d = 0; d < PAIR_DEGREES; d++) a[d * stride] = frame[d * stride];
    rub_kernel(&rub, stride, number + PAIR_RUB_NUMBERS * stride, line->sides[at], line->q[at], line->v[at], a);
}

/// Finishes the acceleration that was begun PAIR_UNDER_WAY - 1 before the last one.
VECTOR_INLINE void pair_receive(const int *laws, size_t stride, pair_line *line, bool shared) {
    const size_t divided = (line->begun - 2) % FILM_PLACES, ended = (line->begun - 3) % FILM_PLACES;
    vec frame[PAIR_DEGREES * PAIR_MAX_STRIDE];
    pair_frame(laws, stride, line, ended, shared, frame);
    film_divide(&line->film, divided);
    pair_end(laws, stride, line, ended, frame);
}

/// Computes a single acceleration. The arguments are as for pair_send.
VECTOR_INLINE void pair_alone(const int *laws, size_t stride, const vec *number, const void *forcing, bool shared,
                              const vec *sides, const vec *q, const vec *v, vec *a) {
    pair_line line;
    vec frame[PAIR_DEGREES * PAIR_MAX_STRIDE];
    line.begun = 0;
    line.balanced = pair_balanced(stride, number);
    pair_send(&line, stride, number, forcing, sides, q, v, a);
    pair_frame(laws, stride, &line, 0, shared, frame);
    film_divide(&line.film, 0);
    pair_end(laws, stride, &line, 0, frame);
}

/// Finishes one more acceleration without beginning another.
VECTOR_INLINE void pair_drain(const int *laws, size_t stride, pair_line *line, bool shared) {
    line->begun++;
    pair_receive(laws, stride, line, shared);
}

/// Prepares a line. The first results, which were never begun, are written to `nowhere`.
VECTOR_INLINE void pair_open(pair_line *line, bool balanced, const vec *number, const void *forcing, const vec *sides,
                             const vec *q, const vec *v, vec *nowhere) {
    memset(&line->film, 0, sizeof line->film);
    line->begun = 0;
    line->balanced = balanced;
    for (size_t at = 0; at < FILM_PLACES; at++) pair_put(line, at, number, forcing, sides, q, v, nowhere);
}

#endif
