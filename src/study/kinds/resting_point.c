// Machines of studies at rest as their analyses take them.
#include "resting_point.h"

static whirl_status resting_at_speed(const void *context, double speed, whirl_variant variant, double variant_value,
                                     whirl_machine *machine) {
    const resting_place *at = context;
    whirl_batch batch = *at->batch;
    batch.speed = speed;
    batch.variant = variant;
    batch.variant_value = variant_value;
    return at->study->machine(at->study->family, &batch, at->value, machine);
}

static whirl_status resting_at_frequency(const void *context, double frequency, whirl_variant variant,
                                         double variant_value, whirl_machine *machine) {
    resting_place at = *(const resting_place *)context;
    whirl_batch batch = *at.batch;
    batch.asynchronous = true;
    batch.frequency = frequency;
    at.batch = &batch;
    return resting_at_speed(&at, 0.0, variant, variant_value, machine);
}

static whirl_status resting_with_spools(const void *context, double speed, const double *spools, bool vary,
                                        whirl_machine *machine) {
    resting_place at = *(const resting_place *)context;
    whirl_batch batch = *at.batch;
    batch.spool_count = spools ? WHIRL_MAX_SPOOLS : 0;
    for (size_t k = 0; k < batch.spool_count; k++) batch.spool_speeds[k] = spools[k];
    batch.spools_vary = vary;
    at.batch = &batch;
    return resting_at_speed(&at, speed, WHIRL_AS_GIVEN, 0.0, machine);
}

static whirl_status resting_at_speeds(const void *context, double speed, const double *spools, whirl_machine *machine) {
    return resting_with_spools(context, speed, spools, false, machine);
}

static whirl_status resting_as_given(const void *context, double speed, const double *spools, whirl_machine *machine) {
    return resting_with_spools(context, speed, spools, true, machine);
}

static whirl_status resting_make_running(const void *context, double lowest, double highest, bool driven,
                                         const whirl_spool_range *spools, size_t count, const unsigned char *happened,
                                         whirl_running **running) {
    resting_place at = *(const resting_place *)context;
    whirl_batch batch = *at.batch;
    batch.happened_count = count;
    for (size_t i = 0; i < count; i++) batch.happened[i] = happened[i];
    at.batch = &batch;
    return whirl_running_new(resting_as_given, &at, lowest, highest, driven, spools, running);
}

whirl_resting resting_point_of(const resting_place *at, const whirl_machine *machine) {
    return (whirl_resting){.system = machine->system,
                           .start = machine->start,
                           .clock = machine->clock,
                           .speed = machine->speed,
                           .at_speed = resting_at_speed,
                           .at_speeds = resting_at_speeds,
                           .at_frequency = resting_at_frequency,
                           .running = resting_make_running,
                           .context = at,
                           .drive_speed = machine->drive_speed,
                           .course = machine->course,
                           .run = machine->run,
                           .stop = at->batch->stop,
                           .placed_count = at->batch->placed_count,
                           .placed = at->batch->placed};
}
