// Places unbalances by rule (API 617): station and size, once for all points of a batch.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whirl/engine/linear.h"
#include "whirl/engine/study.h"

/// A machine on which unbalances are placed.
typedef struct placing {
    const whirl_study *study;
    whirl_batch batch; ///< copy without a parameter
    const whirl_record_options *options;
    double factor;         ///< kg m per kg
    whirl_machine machine; ///< with statics
    whirl_placed *placed;  ///< [probe_count]
    size_t count;
} placing;

static whirl_status placement_machine_of(placing *p, double speed, double stiffness, whirl_variant variant,
                                         whirl_machine *out) {
    p->batch.speed = speed;
    p->batch.variant = variant;
    p->batch.record.bearings = variant == WHIRL_AS_STUDIED;
    return p->study->machine(p->study->family, &p->batch, stiffness, out);
}

static void placement_release(const whirl_machine *machine) {
    if (machine->release) machine->release(machine->owner);
}

static whirl_status at_speed(const void *context, double speed, whirl_variant variant, double value,
                             whirl_machine *machine) {
    placing own = *(const placing *)context;
    return placement_machine_of(&own, speed, value, variant, machine);
}

/// Finds the mean stiffness of all bearings, N/m: sqrt(kxx kyy), or the positive one if the other is not. Each
/// station's mean counts as often as it has bearings; housings are left out.
static whirl_status bearing_stiffness(const placing *p, double *stiffness) {
    const size_t probes = p->machine.system->probe_count;
    const whirl_resting point = {.system = p->machine.system,
                                 .start = p->machine.start,
                                 .clock = p->machine.clock,
                                 .speed = p->machine.speed,
                                 .at_speed = at_speed,
                                 .context = p};
    // Compute the coefficients of all bearings at the highest running speed.
    double *numbers = calloc(8 * probes + 1, sizeof *numbers), sum = 0.0, count = 0.0;
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory to place unbalances");
    const whirl_status status = whirl_bearings_at(&point, p->options->running_high, numbers);
    // Take their mean, weighted by the number of bearings at each station.
    for (size_t i = 0; i < probes; i++) {
        const double kxx = numbers[8 * i], kyy = numbers[8 * i + 3];
        if (!(p->machine.statics[i].bearings > 0.0) || (!(kxx > 0.0) && !(kyy > 0.0))) continue;
        sum += kxx > 0.0 && kyy > 0.0 ? sqrt(kxx * kyy) : fmax(kxx, kyy);
        count += p->machine.statics[i].bearings;
    }
    free(numbers);
    *stiffness = sum / count;
    if (status.code == WHIRL_OK && count == 0.0)
        return whirl_fail(WHIRL_BAD_INPUT,
                          "antinodes_of: no bearing has a stiffness where its journal rests, by which the mode is "
                          "found");
    return status;
}

/// Returns the index of the forward critical speed with that number; the count if there is none.
static size_t find_forward(const whirl_critical_speeds *of, int number) {
    size_t i = 0;
    for (int seen = 0; i < of->count; i++) {
        seen += of->directions[i] > 0.05;
        if (seen == number) break;
    }
    return i;
}

static whirl_status place_at_mode(placing *p, const whirl_critical_speeds *found) {
    const size_t mode = find_forward(found, p->options->antinodes_of);
    if (mode == found->count)
        return whirl_fail(WHIRL_BAD_INPUT, "antinodes_of is %d, but the machine has fewer forward critical speeds",
                          p->options->antinodes_of);
    p->count = whirl_antinodes(p->machine.system, found->vectors + 2 * mode * found->dimension, p->machine.statics,
                               p->factor, p->placed);
    return p->count > 0 ? whirl_ok()
                        : whirl_fail(WHIRL_BAD_INPUT, "antinodes_of: the mode moves no shaft of finite elements");
}

static whirl_status place_at_antinodes(placing *p) {
    const double speed = p->options->running_high;
    whirl_machine own = {.system = NULL}, faster = {.system = NULL};
    whirl_critical_speeds *found = NULL;
    double stiffness = 0.0;
    whirl_status status = bearing_stiffness(p, &stiffness);
    if (status.code == WHIRL_OK) status = placement_machine_of(p, speed, stiffness, WHIRL_AS_STUDIED, &own);
    if (status.code == WHIRL_OK) status = placement_machine_of(p, 2.0 * speed, stiffness, WHIRL_AS_STUDIED, &faster);
    if (status.code == WHIRL_OK) status = whirl_critical_speeds_new(&own, &faster, &found);
    if (status.code == WHIRL_OK) status = place_at_mode(p, found);
    whirl_critical_speeds_free(found);
    placement_release(&faster);
    placement_release(&own);
    return status;
}

/// Returns the overhung mass at a station, kg, outside the outer bearing of its shaft; NaN for other stations.
static double placement_overhang(const placing *p, size_t station) {
    const whirl_probe *probes = p->machine.system->probes;
    double left = NAN, right = NAN, first = INFINITY, last = -INFINITY;
    for (size_t i = 0; i < p->machine.system->probe_count; i++) {
        if (probes[i].shaft != probes[station].shaft || isnan(p->machine.statics[i].carried)) continue;
        if (probes[i].position < first) first = probes[i].position, left = p->machine.statics[i].mass[0];
        if (probes[i].position > last) last = probes[i].position, right = p->machine.statics[i].mass[1];
    }
    const double place = probes[station].position;
    return place < first ? left : place > last ? right : (double)NAN;
}

static whirl_status place_at_station(placing *p) {
    const whirl_system *system = p->machine.system;
    size_t station = 0;
    while (station < system->probe_count && strcmp(system->probes[station].name, p->options->placed_at) != 0) station++;
    if (station == system->probe_count)
        return whirl_fail(WHIRL_BAD_INPUT, "at: '%.63s' is no station", p->options->placed_at);
    const double weight = p->options->placed_weight > 0.0 ? p->options->placed_weight : placement_overhang(p, station);
    if (isnan(weight))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "at: nothing hangs over at station '%.63s', expected weight, the mass of its "
                          "unbalance by rule",
                          p->options->placed_at);
    p->placed[p->count++] = (whirl_placed){.station = station, .moment = p->factor * weight};
    return whirl_ok();
}

whirl_status whirl_study_place(const whirl_study *study, whirl_batch *batch, whirl_placed **placed) {
    const whirl_record_options *options = &batch->record;
    static const double rpm = 0.104719755119659774, rule = 2.0 * 6350.0e-6; // kg m rpm per kg
    placing p = {.study = study, .batch = *batch, .options = options};
    *placed = NULL;
    if (batch->placed || (options->antinodes_of == 0 && !*options->placed_at)) return whirl_ok();
    p.factor = options->placed_factor * rule / (options->running_high / rpm);
    p.batch.parameter[0] = p.batch.second[0] = p.batch.third[0] = '\0';
    whirl_status status = placement_machine_of(&p, options->running_high, 0.0, WHIRL_WITH_STATICS, &p.machine);
    if (status.code == WHIRL_OK) {
        p.placed = calloc(p.machine.system->probe_count + 1, sizeof *p.placed);
        if (!p.placed) status = whirl_fail(WHIRL_NO_MEMORY, "no memory to place unbalances");
    }
    if (status.code == WHIRL_OK) status = *options->placed_at ? place_at_station(&p) : place_at_antinodes(&p);
    placement_release(&p.machine);
    batch->placed = *placed = p.placed;
    batch->placed_count = p.count;
    return status;
}
