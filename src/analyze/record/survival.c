// Lower bound for the lifetime of chaos. Copies escape from the remains of an attractor after times that are
// distributed exponentially, with a mean tau (Grebogi, Ott, Yorke 1983; Lai, Tel 2011). So the probability that n
// copies all run T revolutions without an escape is exp(-n T/tau), and such copies exclude mean lives tau below n T/3
// at 95 %. See docs/theory.md, "Transient chaos".
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "birkhoff.h"
#include "record_block.h"
#include "recurrence.h"
#include "whirl/engine/ensemble.h"
#include "zero_one.h"

/// COPIES: copies of systems that run side by side in lanes. COPIES_ALONE: copies of other systems. LOOKED_AT: number
/// of revolutions by which the end of a copy is judged.
enum { COPIES = 64, COPIES_ALONE = 32, LOOKED_AT = 128 };

/// Mean lives that copies must exclude at 95 %: at least this number of revolutions, and this multiple of the watched
/// number of revolutions.
static const double least_excluded = 12800.0, long_against_watch = 4.0;

/// Displacement of a copy, over the motion's extent in every coordinate, and the number of revolutions within which
/// copies must have diverged from the motion.
static const double displacement = 1e-6, longest_parting = 600.0;

/// Returns true if a copy is no longer chaotic: it is lost, returns or closes in on a return, or is regular.
static bool survival_is_over(const whirl_record *record) {
    const double near_return = 0.02, shrinks = 0.5, regular_walk = 0.2, regular_digits = 4.0;
    if (record->motion != WHIRL_BOUNDED) return true;
    const section points = record_points(record);
    const double size = motion_size(record);
    const recurrence returns = recurrence_find(&points, record->record_count, size, recurrence_tolerance);
    if (returns.distance <= recurrence_tolerance || (returns.distance <= near_return && returns.trend <= shrinks))
        return true;
    return zero_one_test(&points, size) <= regular_walk && regularity_find(&points, size).digits >= regular_digits;
}

/// Picks `count` states of the section, from the first to the last, and displaces each in a direction of its own, the
/// same in every run: starts [count][dimension].
static void place_copies(const whirl_record *record, double share, size_t count, double *starts) {
    const size_t d = record->dimension;
    for (size_t c = 0; c < count; c++) {
        const double *from = record->section + c * record->section_count / count * d;
        for (size_t i = 0; i < d; i++) {
            const double turn = fmod((double)((i + 1) * (c + 1)) * 0.6180339887498949, 1.0);
            starts[c * d + i] = from[i] + share * (record->high[i] - record->low[i]) * (2.0 * turn - 1.0);
        }
    }
}

/// Records the copies side by side, counts those that have ended, and sums their revolutions: for each copy `lived`
/// revolutions after it has diverged from the motion, or fewer if it was lost or settled.
static whirl_status follow_copies(const whirl_system *system, const whirl_integrate_options *integrate,
                                  const whirl_record_options *options, int lived, const double *starts,
                                  whirl_survival *survival) {
    const double parting = options->transient - lived;
    whirl_recorder *recorder;
    int begun = 0;
    size_t turned = 1;
    whirl_status status = whirl_recorder_new(system, integrate, options, 0, &recorder);
    while (status.code == WHIRL_OK && turned > 0) {
        // Fill free lanes with copies.
        status = whirl_recorder_begin(recorder);
        while (status.code == WHIRL_OK && begun < survival->copies && whirl_recorder_has_room(recorder)) {
            const whirl_task task = {system, starts + (size_t)begun++ * system->dimension, NULL};
            status = whirl_recorder_add(recorder, &task, NULL, 0);
        }
        // Carry all by one revolution, and count those that are done.
        if (status.code == WHIRL_OK) status = whirl_recorder_revolve(recorder, &turned);
        whirl_task task;
        whirl_record *record;
        while (status.code == WHIRL_OK && whirl_recorder_take(recorder, &task, &record)) {
            survival->cost += record->revolutions;
            survival->ended += survival_is_over(record);
            survival->revolutions += fmin(fmax(record->revolutions - parting, 1.0), lived);
            whirl_record_free(record);
        }
    }
    whirl_recorder_free(recorder);
    return status;
}

whirl_status whirl_record_survival(const whirl_system *system, const whirl_integrate_options *integrate,
                                   const whirl_record *record, double exponent, whirl_survival *survival) {
    *survival = (whirl_survival){0};
    // Copies need a bounded chaotic motion.
    if (system->turns || record->motion != WHIRL_BOUNDED || record->section_count < COPIES || !(exponent > 0.0))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "copies are followed of a bounded chaotic motion of %d sections without turning phases",
                          COPIES);
    // Displace copies so far that they diverge from the motion within `longest_parting` revolutions.
    const double share = fmax(displacement, exp(-longest_parting * exponent));
    const int count = whirl_ensemble_takes(system, integrate) ? COPIES : COPIES_ALONE;
    const double excluded = fmax(least_excluded, long_against_watch * (double)record->section_count);
    const int lived = (int)ceil(3.0 * excluded / count);
    // Record only as much as a verdict needs.
    whirl_record_options options = whirl_record_default();
    options.transient = (int)ceil(-log(share) / exponent) + lived;
    options.record = options.watch = LOOKED_AT;
    options.settle = true;
    options.waveform = options.spectra = options.orbits = false;
    options.waveform_revolutions = 0;
    options.growth = WHIRL_GROWTH_NONE;
    // Place the copies on the motion, and follow them.
    double *starts = malloc((size_t)count * system->dimension * sizeof *starts);
    if (!starts) return whirl_fail(WHIRL_NO_MEMORY, "no memory to follow copies of a motion");
    place_copies(record, share, (size_t)count, starts);
    survival->copies = count;
    const whirl_status status = follow_copies(system, integrate, &options, lived, starts, survival);
    free(starts);
    return status;
}
