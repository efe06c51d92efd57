/// Pipeline of films over vectors. Three vectors are in films at a time, one in each phase of film_kernel.h. The
/// vectors of each film follow those of the film before it.
#ifndef ROTOR_FILM_FLOW_H
#define ROTOR_FILM_FLOW_H

#include "block.h"
#include "film_kernel.h"

/// Begins vector k of a film; and finishes it with the result of its last phase.
typedef void film_begins(const element *own, const block *b, size_t k, film_work *work, size_t at);
typedef void film_finishes(const element *own, const block *b, size_t k, const film_state *film);

VECTOR_INLINE void film_flow(const element *first, size_t count, const block *b, film_begins *begin,
                             film_finishes *finish) {
    const element *begun = first, *ended = first;
    const size_t all = count * b->vectors;
    film_work work;
    for (size_t i = 0, k = 0, last = 0; i < all + 2; i++) {
        if (i < all) {
            begin(begun, b, k, &work, i % FILM_PLACES);
            if (++k == b->vectors) begun++, k = 0;
        }
        if (i >= 1 && i <= all) film_divide(&work, (i - 1) % FILM_PLACES);
        if (i < 2) continue;
        const vec quarter = numbers_of(b, ended)[FILM_QUARTER * b->stride + last];
        const film_state film = film_end(&work, (i - 2) % FILM_PLACES, quarter);
        finish(ended, b, last, &film);
        if (++last == b->vectors) ended++, last = 0;
    }
}

#endif
