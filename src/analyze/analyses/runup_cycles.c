// Cycles of the torques of a run, by rain flow, in classes of their ranges.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "runup_parts.h"
#include "whirl/signals.h"

/// Maximum number of turning points of a torque that are kept. A run with more has no count of cycles.
enum { MAX_TURNING_POINTS = 4000000 };

/// Appends a value. If the history goes on rising or falling from its last two values to the new one, the new value
/// replaces the last one. Returns false without memory.
static bool cycles_add(runup_history *to, double value) {
    const size_t n = to->count;
    const bool on = n >= 2 && (to->values[n - 1] - to->values[n - 2]) * (value - to->values[n - 1]) >= 0.0;
    if (on) {
        to->values[n - 1] = value;
        return true;
    }
    if (n == MAX_TURNING_POINTS) {
        to->full = true;
        return true;
    }
    if (n == to->capacity) {
        const size_t capacity = 2 * n + 256;
        double *longer = realloc(to->values, capacity * sizeof *longer);
        if (!longer) return false;
        to->values = longer;
        to->capacity = capacity;
    }
    to->values[to->count++] = value;
    return true;
}

bool runup_cycles_note(runup_history *histories, size_t torques, double time, const double *torque) {
    bool kept = true;
    for (size_t t = 0; t < torques; t++) {
        runup_history *own = &histories[t];
        const bool idle = torque[t] == 0.0;
        if (own->count == 0) own->began = time;
        // The time between two successive instants counts as without torque: half of it if one of them has no torque,
        // all of it if neither has.
        own->open += 0.5 * (time - own->began - own->time) * ((own->idle && own->count > 0) + idle);
        own->time = time - own->began;
        own->idle = idle;
        kept = cycles_add(own, torque[t]) && kept;
    }
    return kept;
}

/// Sorts cycles [rows][3] into classes of equal width up to the largest range, out [RUNUP_CLASSES][2].
static void cycles_sort(const double *cycles, size_t rows, double *out) {
    double largest = 0.0;
    for (size_t i = 0; i < rows; i++) largest = fmax(largest, cycles[WHIRL_SIGNALS_CYCLE * i]);
    for (size_t k = 0; k < RUNUP_CLASSES; k++) {
        out[2 * k] = largest * (double)(k + 1) / RUNUP_CLASSES;
        out[2 * k + 1] = 0.0;
    }
    for (size_t i = 0; i < rows && largest > 0.0; i++) {
        const double *own = cycles + WHIRL_SIGNALS_CYCLE * i;
        const double place = ceil(own[0] / largest * RUNUP_CLASSES * (1.0 - 1e-12)) - 1.0;
        out[2 * (place > 0.0 ? (size_t)place : 0) + 1] += own[2];
    }
}

/// Sums up the damage of cycles [rows][3] by the S-N curve of a path; nothing without one.
static whirl_status cycles_sum_damage(const whirl_system *system, size_t path, const double *cycles, size_t rows,
                                      double *damage) {
    whirl_torque_curve curve;
    double largest = 0.0;
    if (!system->torsion || !system->torsion->curve(system->model, path, &curve)) return whirl_ok();
    for (size_t i = 0; i < rows; i++) largest = fmax(largest, cycles[WHIRL_SIGNALS_CYCLE * i]);
    damage[1] = curve.count > 1 && largest > curve.ranges[0];
    if (damage[1] > 0.0) return whirl_ok();
    return whirl_signals_damage(cycles, rows, curve.ranges, curve.lives, curve.count, curve.slope, curve.endurance,
                                &damage[0]);
}

whirl_status runup_cycles_count(const runup_history *histories, size_t torques, const whirl_system *system,
                                size_t first, double *out, double *damage) {
    for (size_t t = 0; t < torques; t++) {
        const runup_history *own = &histories[t];
        size_t rows = 0;
        if (own->count < 2 || own->full) continue;
        double *cycles = malloc(WHIRL_SIGNALS_CYCLE * own->count * sizeof *cycles);
        if (!cycles) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the cycles of a torque");
        whirl_status status = whirl_signals_rain_flow(own->values, own->count, cycles, &rows);
        if (status.code == WHIRL_OK && rows > 0) cycles_sort(cycles, rows, out + 2 * t * RUNUP_CLASSES);
        if (status.code == WHIRL_OK && t >= first)
            status = cycles_sum_damage(system, t - first, cycles, rows, damage + 2 * t);
        free(cycles);
        if (status.code != WHIRL_OK) return status;
    }
    return whirl_ok();
}

/// Reserves memory for the turning points of a saved history. Returns false without memory.
static bool cycles_reserve(runup_history *own, size_t count) {
    if (count <= own->capacity) return true;
    double *longer = realloc(own->values, count * sizeof *longer);
    if (!longer) return false;
    own->values = longer;
    own->capacity = count;
    return true;
}

void runup_cycles_archive(runup_history *histories, size_t torques, archive *a) {
    for (size_t t = 0; t < torques; t++) {
        runup_history *own = &histories[t];
        size_t count = own->count;
        archive_count(a, &count, MAX_TURNING_POINTS);
        if (!a->sound || !cycles_reserve(own, count)) {
            a->sound = false;
            return;
        }
        own->count = count;
        archive_part(a, own->values, count * sizeof *own->values);
        archive_part(a, &own->full, sizeof own->full);
        archive_part(a, &own->idle, sizeof own->idle);
        archive_part(a, &own->began, sizeof own->began);
        archive_part(a, &own->time, sizeof own->time);
        archive_part(a, &own->open, sizeof own->open);
    }
}

void runup_cycles_free(runup_history *histories, size_t torques) {
    for (size_t t = 0; histories && t < torques; t++) free(histories[t].values);
    free(histories);
}
