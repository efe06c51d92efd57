/// A disc on a shaft to a journal in a film, with a rub at the disc: the rotor of most studies of oil film and rub, the paper's of
/// 2015 among them. Integrators have loops of their own for it (rk4_pair.inc, dop853_pair.inc), made of these phases of an acceleration.
///
/// The same kernels in the same order as machine.inc and flow.inc call them from their lists, so the same bits. All arrays are
/// vectors one after the other: coordinates of the disc, then of the journal.
#ifndef ROTOR_PAIR_KERNEL_H
#define ROTOR_PAIR_KERNEL_H

#include "film_kernel.h"
#include "pair.h"
#include "rub_kernel.h"
#include "shaft_kernel.h"
#include "station_kernel.h"

enum { PAIR_STATIONS = 2, PAIR_DEGREES = 4, PAIR_JOURNAL = 2 };

/// Where the numbers of the parts begin.
enum {
    PAIR_DISC_NUMBERS = 0,
    PAIR_JOURNAL_NUMBERS = PAIR_DISC_NUMBERS + STATION_NUMBERS,
    PAIR_SHAFT_NUMBERS = PAIR_JOURNAL_NUMBERS + STATION_NUMBERS,
    PAIR_FILM_NUMBERS = PAIR_SHAFT_NUMBERS + SHAFT_NUMBERS,
    PAIR_RUB_NUMBERS = PAIR_FILM_NUMBERS + FILM_NUMBERS,
    PAIR_NUMBERS = PAIR_RUB_NUMBERS + RUB_NUMBERS
};

/// Leaves the divider with the film's root; film_divide goes next.
VECTOR_INLINE void pair_begin(const vec *number, const vec *q, const vec *v, film_work *work, size_t place) {
    const element film = {.station = {1}};
    film_begin(&film, 1, number + PAIR_FILM_NUMBERS, q, v, work, place);
}

/// Stations and shaft, which do not wait for the divider.
VECTOR_INLINE void pair_frame(const struct lanes_pair *pair, const vec *number, const vec *forcing, const vec *q,
                              const vec *v, vec *a) {
    const element shaft = {.station = {0, 1}, .law = pair->shaft.law};
    const vec c = forcing[COS_TAU], s = forcing[SIN_TAU];
    station_kernel(c, s, 1, number + PAIR_DISC_NUMBERS, v, a);
    station_kernel(c, s, 1, number + PAIR_JOURNAL_NUMBERS, v + PAIR_JOURNAL, a + PAIR_JOURNAL);
    shaft_kernel(&shaft, forcing[COS_2TAU], forcing[SIN_2TAU], 1, number + PAIR_SHAFT_NUMBERS, q, a);
}

/// Film and rub, to what pair_frame has left in `frame`; sides as rub_kernel takes them.
VECTOR_INLINE void pair_end(const struct lanes_pair *pair, const vec *number, const vec *sides, const vec *q,
                            const vec *v, const film_work *work, size_t place, vec *frame, vec *a) {
    const element rub = {
        .station = {0}, .law = pair->rub.law, .number = {[RUB_SLIP_SPEED] = pair->rub.number[RUB_SLIP_SPEED]}};
    const film_state film = film_end(work, place);
    film_add(&film, number[PAIR_FILM_NUMBERS + FILM_TWICE_STRENGTH], &frame[PAIR_JOURNAL], &frame[PAIR_JOURNAL + 1]);
    for (size_t d = 0; d < PAIR_DEGREES; d++) a[d] = frame[d];
    rub_kernel(&rub, 1, number + PAIR_RUB_NUMBERS, sides, q, v, a);
}

#endif
