// Modes of a machine whose coefficients depend on the frequency of whirl. The coefficients must be those at the mode's
// own damped frequency.
//
// At a frequency w the eigenvalues are ranked by falling imaginary part: the first, the second, ... The imaginary part
// of each rank is a continuous function of w, even where modes cross, merge or lose their frequency (then it is 0). The
// modes are the frequencies where this imaginary part equals w, for each rank; each mode is found once.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bracket.h"
#include "modes.h"

/// Parts into which the interval between two neighbouring frequencies of the tables is divided.
enum { PARTS = 2 };

/// A mode that was found: its frequency, and its rank at that frequency.
typedef struct zero {
    double frequency;
    size_t rank;
} zero;

/// A machine with its coefficients at one frequency, and its modes.
typedef struct look {
    double frequency, clock;
    whirl_modes *modes;
} look;

static void look_end(look *own) {
    whirl_modes_free(own->modes);
    own->modes = NULL;
}

/// Computes the modes of the machine at a frequency, about `rest`. If `rest` is NULL, searches the equilibrium and
/// computes them about it.
static whirl_status look_at(const whirl_whirling *others, double frequency, const double *rest, look *out) {
    whirl_machine machine = {.system = NULL};
    *out = (look){.frequency = frequency};
    whirl_status status = others->at(others->context, frequency, &machine);
    if (status.code != WHIRL_OK) return status;
    out->clock = machine.clock;
    status = modes_about(machine.system, rest ? rest : machine.start, rest != NULL, &out->modes);
    if (machine.release) machine.release(machine.owner);
    if (status.code == WHIRL_OK && out->modes->period > 0.0) {
        look_end(out);
        return whirl_fail(WHIRL_BAD_INPUT, "coefficients turn with the shaft, and those of bearings depend on the "
                                           "frequency of whirl: a motion has many, expected one or the other");
    }
    return status;
}

/// Returns the imaginary part of a rank minus the frequency. The imaginary part of a real eigenvalue is 0.
static double excess(const look *at, size_t rank) {
    const whirl_modes *modes = at->modes;
    return (rank < modes->count ? at->clock * modes->modes[modes->count - 1 - rank].imaginary : 0.0) - at->frequency;
}

/// Finds the zero of a rank between two frequencies.
static whirl_status close_in(const whirl_whirling *others, const double *rest, size_t rank, double a, double fa,
                             double b, double fb, double *found) {
    enum { MAX_STEPS = 100 };
    bracket r = bracket_between(a, fa, b, fb);
    for (int step = 0; step < MAX_STEPS && bracket_width(&r) > 1e-13 * b; step++) {
        look at;
        const double c = bracket_next(&r);
        const whirl_status status = look_at(others, c, rest, &at);
        if (status.code != WHIRL_OK) return status;
        const double fc = excess(&at, rank);
        look_end(&at);
        bracket_update(&r, c, fc);
        *found = c;
        if (fabs(fc) <= 1e-14 * c) break;
    }
    return whirl_ok();
}

static int by_frequency(const void *a, const void *b) {
    const zero *p = a, *q = b;
    if (p->frequency != q->frequency) return p->frequency < q->frequency ? -1 : 1;
    return p->rank > q->rank ? -1 : p->rank < q->rank; // of equal frequencies the smaller imaginary part first
}

/// Finds the zeros between two neighbouring frequencies.
static whirl_status find_between(const whirl_whirling *others, const look *a, const look *b, zero *zeros,
                                 size_t *count) {
    const size_t ranks = a->modes->count > b->modes->count ? a->modes->count : b->modes->count;
    whirl_status status = whirl_ok();
    for (size_t rank = 0; rank < ranks && status.code == WHIRL_OK; rank++) {
        const double fa = excess(a, rank), fb = excess(b, rank);
        zero *own = &zeros[*count];
        *own = (zero){.rank = rank, .frequency = b->frequency};
        // A zero exactly at a frequency belongs to the interval that ends there.
        if ((fa > 0.0) == (fb > 0.0) || fa == 0.0) continue;
        if (fb != 0.0)
            status = close_in(others, a->modes->rest, rank, a->frequency, fa, b->frequency, fb, &own->frequency);
        ++*count;
    }
    return status;
}

/// Finds all zeros, zeros [dimension times (1 + number of parts)]. *first becomes the machine at the first frequency.
static whirl_status find_all(const whirl_system *system, const whirl_whirling *others, zero *zeros, size_t *count,
                             look *first) {
    look last;
    whirl_status status = look_at(others, system->frequencies[0], NULL, first);
    *count = 0;
    if (status.code != WHIRL_OK) return status;
    for (size_t rank = 0; rank < first->modes->count; rank++)
        if (excess(first, rank) == 0.0) zeros[(*count)++] = (zero){first->frequency, rank};
    last = *first;
    for (size_t i = 1; i < system->frequency_count && status.code == WHIRL_OK; i++)
        for (int part = 1; part <= PARTS && status.code == WHIRL_OK; part++) {
            const double low = system->frequencies[i - 1], high = system->frequencies[i];
            look next;
            status =
                look_at(others, part == PARTS ? high : low + (high - low) * part / PARTS, first->modes->rest, &next);
            if (status.code == WHIRL_OK) status = find_between(others, &last, &next, zeros, count);
            if (last.modes != first->modes) look_end(&last);
            last = next;
        }
    if (last.modes != first->modes) look_end(&last);
    qsort(zeros, *count, sizeof *zeros, by_frequency);
    return status;
}

static void whirling_take(const look *from, const zero *own, whirl_modes *out) {
    const size_t d = out->dimension, at = from->modes->count - 1 - own->rank;
    whirl_mode *mode = &out->modes[out->count];
    *mode = from->modes->modes[at];
    memcpy(out->vectors + 2 * out->count++ * d, from->modes->vectors + 2 * at * d, 2 * d * sizeof *out->vectors);
    out->growth = isnan(out->growth) ? mode->real : fmax(out->growth, mode->real);
}

/// Computes the shapes at each zero. Equal zeros are computed together, so that each mode has its own shape.
static whirl_status take_all(const whirl_whirling *others, const zero *zeros, size_t count, whirl_modes *out) {
    look at = {.modes = NULL};
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < count && status.code == WHIRL_OK; i++) {
        if (!at.modes || zeros[i].frequency > (1.0 + 1e-9) * at.frequency) {
            look_end(&at);
            status = look_at(others, zeros[i].frequency, out->rest, &at);
        }
        if (status.code == WHIRL_OK && zeros[i].rank < at.modes->count) whirling_take(&at, &zeros[i], out);
    }
    look_end(&at);
    return status;
}

/// Copies the equilibrium from the first frequency and, if that frequency is 0, the real eigenvalues.
static void take_first(const look *first, whirl_modes *out) {
    const whirl_modes *from = first->modes;
    memcpy(out->rest, from->rest, from->dimension * sizeof *out->rest);
    if (first->frequency != 0.0) return;
    out->free = from->free;
    out->real_count = from->real_count;
    memcpy(out->reals, from->reals, from->real_count * sizeof *out->reals);
    if (from->real_count > 0) out->growth = from->reals[0];
}

whirl_status whirl_modes_of(const whirl_machine *machine, const whirl_whirling *others, whirl_modes **out) {
    const whirl_system *system = machine->system;
    const size_t d = system->dimension, most = d * (PARTS * system->frequency_count + 1);
    look first = {.modes = NULL};
    size_t count = 0;
    *out = NULL;
    if (system->frequency_count == 0) return whirl_modes_new(system, machine->start, out);
    // Find the frequencies, then the shapes at each of them.
    zero *zeros = calloc(most + 1, sizeof *zeros);
    whirl_status status = zeros ? find_all(system, others, zeros, &count, &first)
                                : whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of %zu coordinates", d);
    whirl_modes *modes = status.code == WHIRL_OK ? modes_allocate(d, count > d ? count : d) : NULL;
    if (status.code == WHIRL_OK && !modes)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the modes of %zu coordinates", d);
    if (status.code == WHIRL_OK) {
        modes->growth = NAN;
        take_first(&first, modes);
        status = take_all(others, zeros, count, modes);
        if (status.code == WHIRL_OK) status = modes_put_overdamped_last(modes);
    }
    look_end(&first);
    free(zeros);
    if (status.code == WHIRL_OK)
        *out = modes;
    else
        whirl_modes_free(modes);
    return status;
}
