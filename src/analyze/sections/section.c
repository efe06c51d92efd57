#include "section.h"

#include <math.h>

section section_tail(const section *all, size_t count) {
    if (count > all->count) count = all->count;
    return (section){count, all->dimension, all->points + (all->count - count) * all->dimension};
}

double section_distance(const section *all, size_t a, size_t b) {
    const double *p = all->points + a * all->dimension, *q = all->points + b * all->dimension;
    double sum = 0.0;
    for (size_t i = 0; i < all->dimension; i++) sum += (p[i] - q[i]) * (p[i] - q[i]);
    return sqrt(sum);
}

static double largest_coordinate(const whirl_record *record) {
    double largest = 0.0;
    for (size_t i = 0; i < record->dimension; i++)
        largest = fmax(largest, fmax(fabs(record->low[i]), fabs(record->high[i])));
    return largest;
}

double motion_size(const whirl_record *record) {
    double squares = 0.0;
    for (size_t i = 0; i < record->dimension; i++) {
        const double half = 0.5 * (record->high[i] - record->low[i]);
        squares += half * half;
    }
    return fmax(sqrt(squares), fmax(1e-6 * largest_coordinate(record), 1e-12));
}

double motion_rounding(const whirl_record *record) {
    return fmax(1e-12 * largest_coordinate(record), 1e-18) / motion_size(record);
}
