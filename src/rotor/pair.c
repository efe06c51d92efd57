#include "pair.h"

#include "assembly.h"
#include "element.h"
#include "pair_kernel.h"
#include "registry.h"

/// The elements of a pair: a shaft, a film at one end, a rub at the other end.
enum { SHAFT, FILM, RUB, ELEMENTS_OF_PAIR };

/// Returns true if a machine is a pair, with the coordinates of the disc before or (reversed) after those of the
/// journal.
static bool is_pair(const assembly *of, const element *e, size_t count, bool reversed) {
    const size_t disc = reversed ? 2 : 0, journal = 2 - disc;
    return of->station_count == PAIR_STATIONS && of->degrees == PAIR_DEGREES && of->plane_count == PAIR_STATIONS &&
           of->term_count == 0 && of->mass_count == 0 && count == ELEMENTS_OF_PAIR && e[SHAFT].type == &shaft_element &&
           e[SHAFT].port[2] == 2 && e[FILM].type == &film_element && e[FILM].port[0] == journal &&
           e[RUB].type == &rub_element && e[RUB].port[0] == disc;
}

bool pair_find(const assembly *of, const element *elements, size_t count, size_t order[PAIR_STATIONS],
               int laws[PAIR_LAWS]) {
    const bool reversed = is_pair(of, elements, count, true);
    if (!reversed && !is_pair(of, elements, count, false)) return false;
    order[0] = reversed;
    order[1] = !reversed;
    laws[PAIR_SHAFT_LAW] = elements[SHAFT].law;
    laws[PAIR_RUB_LAW] = elements[RUB].law;
    return true;
}
