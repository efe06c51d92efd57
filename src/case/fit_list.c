#include "fit_list.h"

#include <math.h>
#include <string.h>

/// Makes room for one more motion or number; NULL without memory.
static void *fit_list_grow(fit_maker *m, void *list, size_t count, size_t *capacity, size_t size) {
    if (count < *capacity) return list;
    const size_t more = *capacity > 0 ? 2 * *capacity : 64;
    void *out = arena_take(m->reader->arena, more * size);
    if (out && count > 0) memcpy(out, list, count * size);
    if (out) *capacity = more;
    m->reader->no_memory = m->reader->no_memory || !out;
    return out;
}

void fit_list_sum(fit_maker *m, size_t count, const double *terms) {
    double sum = 1.618033988749895 * m->checksum;
    for (size_t i = 0; i < count; i++) sum += terms[i];
    m->checksum = fmod(sum, 4096.0);
}

whirl_status fit_list_motion(fit_maker *m, const whirl_fit_motion *motion) {
    if (m->fit.motion_count == WHIRL_MAX_FIT_MOTIONS)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d motions", WHIRL_MAX_FIT_MOTIONS);
    m->motions = fit_list_grow(m, m->motions, m->fit.motion_count, &m->motion_capacity, sizeof *m->motions);
    if (!m->motions) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    m->motions[m->fit.motion_count++] = *motion;
    return whirl_ok();
}

whirl_status fit_list_number(fit_maker *m, const whirl_fit_number *number) {
    if (m->fit.number_count == WHIRL_MAX_FIT_NUMBERS)
        return whirl_fail(WHIRL_BAD_INPUT, "there are more than %d numbers", WHIRL_MAX_FIT_NUMBERS);
    m->numbers = fit_list_grow(m, m->numbers, m->fit.number_count, &m->number_capacity, sizeof *m->numbers);
    if (!m->numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a fit");
    m->numbers[m->fit.number_count] = *number;
    m->numbers[m->fit.number_count++].motion = m->fit.motion_count - 1;
    const double terms[] = {number->value * 1e6, number->at, (double)number->quantity, number->noise * 1e3};
    fit_list_sum(m, sizeof terms / sizeof *terms, terms);
    return whirl_ok();
}
