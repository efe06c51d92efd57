#include "phases.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "whirl/engine/report.h"

/// Periods of the forces of a batch's machines, in revolutions.
typedef struct phases {
    size_t fitting;     ///< number of machines whose forces repeat
    size_t least, most; ///< shortest and longest period
} phases;

static void phases_note(phases *seen, const whirl_system *system) {
    const size_t repeats = system->repeats;
    if (repeats == 0) return;
    seen->least = seen->fitting == 0 || repeats < seen->least ? repeats : seen->least;
    seen->most = repeats > seen->most ? repeats : seen->most;
    seen->fitting++;
}

static const char *plural(size_t count) {
    return count == 1 ? "" : "s";
}

/// Prints that forces do not repeat; who: "forces", or those of some machines.
static void print_never(const char *who) {
    printf(
        "%s fit no period up to %d revolutions: stable motions that follow them are called quasi-periodic (forced)\n",
        who, WHIRL_MAX_REPEATS);
}

static void phases_print(const phases *seen, size_t looked_at) {
    const bool always = seen->fitting == looked_at;
    char least[32] = "";
    if (seen->least < seen->most) snprintf(least, sizeof least, "%zu to ", seen->least);
    if (always && seen->least == seen->most)
        printf("  forces repeat after %zu revolution%s: motions that follow them are P-%zu\n", seen->most,
               plural(seen->most), seen->most);
    else if (seen->fitting > 0)
        printf("  forces repeat after %s%zu revolution%s at %zu of %zu values\n", least, seen->most, plural(seen->most),
               seen->fitting, looked_at);
    if (seen->fitting == 0)
        print_never("  forces");
    else if (seen->fitting < looked_at)
        print_never("  forces at the others");
}

/// Prints that periods are too long for the watched revolutions.
static void print_watch(const phases *seen, int watched) {
    const size_t always = 64, three = 3 * seen->most;
    if (seen->most > always && (size_t)watched < three)
        printf("  a period of %zu revolutions is found if %zu are watched; %d are (study.integrate.watch)\n",
               seen->most, three, watched);
}

whirl_status print_phases(const whirl_study *study, const whirl_batch *batch, const whirl_rotor *rotor) {
    const size_t most = 1000, count = batch->values && batch->count < most ? batch->count : batch->values ? most : 1;
    phases seen = {0};
    whirl_batch own = *batch;
    own.outline = true;
    // Note the periods of all machines, or of a thousand of them.
    for (size_t i = 0; i < count; i++) {
        whirl_machine machine;
        const size_t at = batch->count * i / count;
        const whirl_status status = whirl_study_machine(study, &own, at, &machine);
        if (status.code != WHIRL_OK) return status;
        const bool turning = machine.system->turns != NULL;
        phases_note(&seen, machine.system);
        if (machine.release) machine.release(machine.owner);
        if (!turning) return whirl_ok(); // no machine has such forces: those of a batch differ only in numbers
    }
    // Print the phase that defines sections, then the others.
    if (*whirl_rotor_keyphasor(rotor))
        whirl_write_keyphasor(whirl_rotor_keyphasor(rotor), whirl_rotor_clock(rotor), stdout);
    else
        printf("  sections: once a revolution of the shaft\n");
    phases_print(&seen, count);
    print_watch(&seen, whirl_record_watch(&batch->record));
    return whirl_ok();
}
