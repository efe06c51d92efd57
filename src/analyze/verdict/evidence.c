#include "evidence.h"

#include <math.h>

#include "birkhoff.h"
#include "mean_growth.h"
#include "record_block.h"
#include "recurrence.h"
#include "section.h"
#include "turns.h"

evidence evidence_gather(const whirl_record *record) {
    evidence e = {.points = record_points(record),
                  .size = motion_size(record),
                  .rounding = motion_rounding(record),
                  .exponent = whirl_lyapunov_largest(record),
                  .second = {NAN, NAN}};
    for (size_t i = 0; record->repeats == 0 && i < record->dimension; i++)
        e.forced = e.forced || turns_on(record->turns, i);
    e.exponents_failed = balance_growth(record).failed;
    if (record->growth_count > 0 && !e.exponents_failed) {
        const size_t aligning = record->growth_count / 10;
        e.growth = record->growth + aligning;
        e.growth_count = record->growth_count - aligning;
        e.second = second_exponent(record);
    }
    e.returns = recurrence_find(&e.points, record->record_count, e.size, recurrence_tolerance);
    e.averages = regularity_find(&e.points, e.size);
    return e;
}

evidence evidence_later_half(const evidence *all) {
    evidence half = *all;
    half.points = section_tail(&all->points, all->points.count / 2);
    half.averages = regularity_find(&half.points, all->size);
    if (all->growth_count > half.points.count) {
        half.growth += all->growth_count - half.points.count;
        half.growth_count = half.points.count;
        half.exponent = estimate_mean(half.growth, half.growth_count);
    }
    return half;
}

double settling_rate(const evidence *e) {
    return log(e->returns.trend) / (0.75 * (double)e->points.count);
}
