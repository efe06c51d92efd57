// Stability by logarithmic decrements: over the cross coupling of stages with bearings alone (Level I of API 617), and
// with seals and impellers, one station at a time and together (Level II).
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "bracket.h"
#include "whirl/internal/response_peaks.h"

enum {
    SPEED,
    ANTICIPATED,
    LIMIT,
    BASIC,
    DECREMENT,
    COMPLETE,
    FREQUENCY,
    RIGID,
    RATIO,
    DENSITY,
    REGION,
    CROSS_COUPLING,
    CURVE,
    PART,
    FIELD_COUNT
};

/// Points of the curve, and its end as a multiple of the anticipated cross coupling (or of twice the limit if that is
/// less).
enum { CURVE_POINTS = 21, CURVE_END = 10 };

static size_t curve_points(const block_shape *shape) {
    (void)shape;
    return CURVE_POINTS;
}

static const field_plan fields[FIELD_COUNT] = {
    [SPEED] = {WHIRL_FIELD_STABILITY_SPEED, "rad/s", "speed of the shaft", WHIRL_PER_POINT, 1, NULL},
    [ANTICIPATED] = {WHIRL_FIELD_STABILITY_ANTICIPATED, "N/m", "cross coupling of all stages, Q_A", WHIRL_PER_POINT, 1,
                     NULL},
    [LIMIT] =
        {WHIRL_FIELD_STABILITY_LIMIT, "N/m",
         "cross coupling of all stages, each in proportion, at which the decrement is 0, Q_0 (0: it is below without "
         "any; missing: at no less than 1000 times the anticipated one, or without stages)",
         WHIRL_PER_POINT, 1, NULL},
    [BASIC] = {WHIRL_FIELD_STABILITY_BASIC, "1", "logarithmic decrement with bearings alone", WHIRL_PER_POINT, 1, NULL},
    [DECREMENT] = {WHIRL_FIELD_STABILITY_DECREMENT, "1", "logarithmic decrement with bearings and stages",
                   WHIRL_PER_POINT, 1, NULL},
    [COMPLETE] = {WHIRL_FIELD_STABILITY_COMPLETE, "1",
                  "logarithmic decrement with bearings, stages, seals and impellers", WHIRL_PER_POINT, 1, NULL},
    [FREQUENCY] = {WHIRL_FIELD_STABILITY_FREQUENCY, "rad/s", "frequency of the mode with bearings and stages",
                   WHIRL_PER_POINT, 1, NULL},
    [RIGID] = {WHIRL_FIELD_STABILITY_RIGID, "rad/s", "first forward critical speed without damping on rigid supports",
               WHIRL_PER_POINT, 1, NULL},
    [RATIO] = {WHIRL_FIELD_STABILITY_RATIO, "1", "critical speed ratio: the speed over that on rigid supports",
               WHIRL_PER_POINT, 1, NULL},
    [DENSITY] = {WHIRL_FIELD_STABILITY_DENSITY, "kg/m3", "average density of the gas (missing if not given)",
                 WHIRL_PER_POINT, 1, NULL},
    [REGION] = {WHIRL_FIELD_STABILITY_REGION, "1",
                "region of the screening diagram: 0: A, 1: B (missing without the density)", WHIRL_PER_POINT, 1, NULL},
    [CROSS_COUPLING] = {WHIRL_FIELD_STABILITY_CROSS_COUPLING, "N/m", "cross coupling of all stages, along the curve",
                        WHIRL_PER_POINT, 1, curve_points},
    [CURVE] = {WHIRL_FIELD_STABILITY_CURVE, "1", "logarithmic decrement with bearings and that cross coupling",
               WHIRL_PER_POINT, 1, curve_points},
    [PART] = {WHIRL_FIELD_STABILITY_PART, "1",
              "logarithmic decrement with bearings, and with the seals and impellers here alone", WHIRL_PER_STATION, 1,
              NULL},
};

/// The deciding modes with bearings alone, which are followed to every other machine. Choosing them anew there would
/// fail where seals and stages reverse directions of whirl.
typedef struct deciding {
    whirl_modes *modes; ///< with bearings alone
    bool *any;          ///< [modes->count] the mode decides
    size_t *partner;    ///< [modes->count] the followed mode in the other machine
    double clock;
} deciding;

/// A machine whose decrement is computed.
typedef struct probing {
    const whirl_resting *point;
    deciding from;
    double frequency; ///< frequency of the deciding mode in the last machine
    double anticipated;
} probing;

static double frequency_of(const whirl_mode *mode, double clock) {
    return clock * mode->imaginary;
}

static double decrement_of(const whirl_mode *mode) {
    return 6.283185307179586476925 * (0.0 - mode->real) / mode->imaginary;
}

/// Returns the highest frequency of deciding modes: the speed, or the frequency of the first mode if that is higher.
static double highest_of(const whirl_modes *modes, const bool *any, double clock, double speed) {
    double first = INFINITY;
    for (size_t i = 0; i < modes->count; i++)
        if (any[i]) first = fmin(first, frequency_of(&modes->modes[i], clock));
    return isfinite(first) ? fmax(speed, first) : speed;
}

/// Marks the deciding modes: not clearly backward, and damped less than 0.8 of critically; if there are none, with any
/// damping. In two almost uncoupled planes, modes have no definite direction, and both decide.
static void stability_choose(const whirl_modes *modes, double clock, double speed, bool *any) {
    static const double backward = -0.3, damped[] = {0.8, INFINITY};
    bool found = false;
    for (size_t round = 0; round < 2 && !found; round++) {
        for (size_t i = 0; i < modes->count; i++) {
            const whirl_mode *mode = &modes->modes[i];
            any[i] =
                mode->direction > backward && 0.0 - mode->real < damped[round] * hypot(mode->real, mode->imaginary);
        }
        const double highest = highest_of(modes, any, clock, speed);
        for (size_t i = 0; i < modes->count; i++) {
            any[i] = any[i] && frequency_of(&modes->modes[i], clock) <= highest;
            found = found || any[i];
        }
    }
}

/// Returns the least decrement of the deciding modes [count], and of growing modes up to the highest frequency of
/// these; NaN if there are none. *frequency becomes that of the mode.
static double least_decrement(const whirl_modes *modes, const bool *any, double clock, double speed,
                              double *frequency) {
    const double highest = highest_of(modes, any, clock, speed);
    double best = NAN;
    for (size_t i = 0; i < modes->count; i++) {
        const whirl_mode *mode = &modes->modes[i];
        const bool grows = mode->real > 0.0 && frequency_of(mode, clock) <= highest;
        if ((!any[i] && !grows) || decrement_of(mode) >= best) continue;
        best = decrement_of(mode);
        *frequency = frequency_of(mode, clock);
    }
    return best;
}

/// A variant of the machine whose modes are computed.
typedef struct asked {
    const whirl_resting *point;
    whirl_variant variant;
    double value;
} asked;

static whirl_status at_frequency(const void *context, double frequency, whirl_machine *machine) {
    const asked *own = context;
    return own->point->at_frequency(own->point->context, frequency, own->variant, own->value, machine);
}

/// Marks in any [modes->count] the modes that the deciding ones have become.
static whirl_status stability_follow(const deciding *from, const whirl_modes *modes, double clock, bool *any) {
    const whirl_status status = whirl_modes_match(from->modes, modes, from->clock / clock, from->partner, NULL);
    for (size_t i = 0; i < from->modes->count && status.code == WHIRL_OK; i++)
        if (from->any[i] && from->partner[i] < modes->count) any[from->partner[i]] = true;
    return status;
}

/// Computes the decrement of the deciding modes, followed from the machine with bearings alone. If none of them is
/// left, chooses the deciding modes anew.
static whirl_status stability_report(probing *p, const whirl_machine *machine, const whirl_modes *modes,
                                     double *decrement) {
    const bool known = p->from.modes && p->from.modes->dimension == modes->dimension;
    bool *any = calloc(modes->count + 1, sizeof *any);
    whirl_status status = any ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory to follow modes");
    if (any && known) status = stability_follow(&p->from, modes, machine->clock, any);
    if (status.code == WHIRL_OK)
        *decrement = least_decrement(modes, any, machine->clock, machine->speed, &p->frequency);
    if (status.code == WHIRL_OK && isnan(*decrement)) {
        stability_choose(modes, machine->clock, machine->speed, any);
        *decrement = least_decrement(modes, any, machine->clock, machine->speed, &p->frequency);
    }
    free(any);
    return status;
}

static whirl_status modes_of(const probing *p, whirl_variant variant, double value, whirl_machine *machine,
                             whirl_modes **modes) {
    const asked own = {p->point, variant, value};
    *machine = (whirl_machine){.system = NULL};
    *modes = NULL;
    const whirl_status status = p->point->at_speed(p->point->context, 0.0, variant, value, machine);
    if (status.code != WHIRL_OK) return status;
    return whirl_modes_of(machine, &(whirl_whirling){at_frequency, &own}, modes);
}

static whirl_status stability_probe(probing *p, whirl_variant variant, double value, double *decrement) {
    whirl_machine machine;
    whirl_modes *modes;
    whirl_status status = modes_of(p, variant, value, &machine, &modes);
    if (status.code == WHIRL_OK) status = stability_report(p, &machine, modes, decrement);
    if (status.code == WHIRL_OK && variant == WHIRL_WITH_STAGES) p->anticipated = machine.cross_coupling;
    whirl_modes_free(modes);
    if (machine.release) machine.release(machine.owner);
    return status;
}

/// Chooses the deciding modes of the machine with its bearings alone. Freed by stability_free.
static whirl_status stability_begin(probing *p) {
    deciding *from = &p->from;
    whirl_machine machine;
    whirl_status status = modes_of(p, WHIRL_WITH_STAGES, 0.0, &machine, &from->modes);
    if (status.code == WHIRL_OK) {
        from->clock = machine.clock;
        from->any = calloc(from->modes->count + 1, sizeof *from->any);
        from->partner = calloc(from->modes->count + 1, sizeof *from->partner);
        if (!from->any || !from->partner) status = whirl_fail(WHIRL_NO_MEMORY, "no memory to follow modes");
    }
    if (status.code == WHIRL_OK) stability_choose(from->modes, machine.clock, machine.speed, from->any);
    if (machine.release) machine.release(machine.owner);
    return status;
}

static void stability_free(probing *p) {
    whirl_modes_free(p->from.modes);
    free(p->from.any);
    free(p->from.partner);
}

/// Returns the decrement or, if it is NaN, 10, that of a barely oscillating mode: no mode can grow since all are
/// overdamped or backward.
static double or_overdamped(double decrement) {
    return isnan(decrement) ? 10.0 : decrement;
}

/// Computes the decrement with a multiple of the stages' cross coupling.
static whirl_status probe_stages(probing *p, double share, double *decrement) {
    const whirl_status status = stability_probe(p, WHIRL_WITH_STAGES, share, decrement);
    *decrement = or_overdamped(*decrement);
    return status;
}

/// Finds the multiple of the stages' cross coupling at which the decrement is 0: 0 if it is negative with none; NaN
/// beyond the largest multiple.
static whirl_status find_limit(probing *p, double basic, double *limit) {
    enum { STEPS = 60 };
    static const double most = 1024.0, close = 1e-12;
    double low = 0.0, high = 1.0, decrement = or_overdamped(basic), before = decrement;
    whirl_status status = whirl_ok();
    *limit = decrement > 0.0 ? (double)NAN : 0.0;
    if (!(decrement > 0.0)) return status;
    for (; high <= most && status.code == WHIRL_OK; low = high, before = decrement, high *= 2.0) {
        status = probe_stages(p, high, &decrement);
        if (!(decrement > 0.0)) break;
    }
    if (high > most) return status;
    bracket at = bracket_between(low, before, high, decrement);
    for (int i = 0; i < STEPS && bracket_width(&at) > close * high && at.fb != 0.0 && status.code == WHIRL_OK; i++) {
        const double next = bracket_next(&at);
        status = probe_stages(p, next, &decrement);
        bracket_update(&at, next, decrement);
    }
    *limit = fabs(at.fa) < fabs(at.fb) ? at.a : at.b;
    return status;
}

static whirl_status fill_curve(probing *p, double limit, const block_view *view) {
    const double end = limit > 0.0 ? fmin(CURVE_END, 2.0 * limit) : CURVE_END;
    double *coupling = view_numbers(view, CROSS_COUPLING, 0), *curve = view_numbers(view, CURVE, 0);
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < CURVE_POINTS && status.code == WHIRL_OK; i++) {
        const double share = end * (double)i / (CURVE_POINTS - 1);
        coupling[i] = share * p->anticipated;
        status = stability_probe(p, WHIRL_WITH_STAGES, share, &curve[i]);
    }
    return status;
}

static whirl_status fill_parts(probing *p, double basic, const block_view *view) {
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < p->point->system->probe_count && status.code == WHIRL_OK; s++) {
        double own = NAN;
        status = stability_probe(p, WHIRL_WITH_DRAG_AT, (double)s, &own);
        *view_numbers(view, PART, s) = own == basic ? (double)NAN : own; // equal to the bit: the station has none
    }
    return status;
}

/// Finds the first forward critical speed of the machine on springs; NaN without one.
static whirl_status held_at(const whirl_resting *point, double stiffness, double *speed) {
    whirl_machine slow = {.system = NULL}, fast = {.system = NULL};
    whirl_critical_speeds *found = NULL;
    *speed = NAN;
    whirl_status status = point->at_speed(point->context, point->speed, WHIRL_HELD, stiffness, &slow);
    if (status.code == WHIRL_OK)
        status = point->at_speed(point->context, 2.0 * point->speed, WHIRL_HELD, stiffness, &fast);
    if (status.code == WHIRL_OK) status = whirl_critical_speeds_new(&slow, &fast, &found);
    for (size_t i = 0; found && i < found->count && isnan(*speed); i++)
        if (found->directions[i] > 0.05) *speed = found->speeds[i];
    whirl_critical_speeds_free(found);
    if (fast.release) fast.release(fast.owner);
    if (slow.release) slow.release(slow.owner);
    return status;
}

/// Finds the critical speed on rigid supports: stiffens springs until a factor of ten changes it by less than 1e-6,
/// then extrapolates in 1/stiffness. NaN without such a speed.
static whirl_status find_rigid(const whirl_resting *point, double *speed) {
    static const double softest = 1e7, stiffest = 1e18, close = 1e-6;
    double before = NAN;
    whirl_status status = whirl_ok();
    *speed = NAN;
    for (double k = softest; k <= stiffest && status.code == WHIRL_OK; k *= 10.0) {
        double own;
        status = held_at(point, k, &own);
        if (status.code == WHIRL_OK && isnan(own)) break;
        if (status.code == WHIRL_OK && fabs(own - before) <= close * own) {
            *speed = own + (own - before) / 9.0;
            break;
        }
        before = own;
    }
    // A machine without undamped critical speeds has no critical speed ratio.
    return status.code == WHIRL_BAD_INPUT ? whirl_ok() : status;
}

// Boundary of the regions (Level I screening of API 617, 7th edition of 2002, 2.6.5, as API 684 draws it; the user
// checks which edition applies): 2.5 up to 16.53 kg/m3, then straight to 2.0 at 60 kg/m3; beyond that all is B.
double whirl_screening_ratio(double density) {
    static const double light = 16.53, dense = 60.0, most = 2.5, least = 2.0;
    if (density > dense) return 0.0;
    return density <= light ? most : most + (least - most) * (density - light) / (dense - light);
}

static whirl_status fill_screening(const whirl_resting *point, double density, const block_view *view) {
    double rigid;
    const whirl_status status = find_rigid(point, &rigid);
    const double ratio = fabs(point->speed) / rigid;
    *view_numbers(view, RIGID, 0) = rigid;
    *view_numbers(view, RATIO, 0) = ratio;
    if (!(density > 0.0)) return status;
    *view_numbers(view, DENSITY, 0) = density;
    if (isfinite(ratio)) *view_numbers(view, REGION, 0) = ratio > whirl_screening_ratio(density);
    return status;
}

static whirl_status stability_compute(const whirl_resting *point, const whirl_record_options *options,
                                      const block_view *view) {
    probing p = {.point = point};
    double basic = NAN, anticipated = NAN, complete = NAN, limit = NAN;
    whirl_status status = stability_begin(&p);
    if (status.code == WHIRL_OK) status = stability_probe(&p, WHIRL_WITH_STAGES, 0.0, &basic);
    if (status.code == WHIRL_OK) status = fill_screening(point, options->gas_density, view);
    if (status.code == WHIRL_OK) status = stability_probe(&p, WHIRL_AS_GIVEN, 0.0, &complete);
    if (status.code == WHIRL_OK) status = fill_parts(&p, basic, view);
    if (status.code == WHIRL_OK && p.anticipated > 0.0) status = find_limit(&p, basic, &limit);
    if (status.code == WHIRL_OK && p.anticipated > 0.0) status = fill_curve(&p, limit, view);
    if (status.code == WHIRL_OK) status = stability_probe(&p, WHIRL_WITH_STAGES, 1.0, &anticipated);
    stability_free(&p);
    *view_numbers(view, SPEED, 0) = point->speed;
    *view_numbers(view, ANTICIPATED, 0) = p.anticipated;
    *view_numbers(view, LIMIT, 0) = limit * p.anticipated;
    *view_numbers(view, BASIC, 0) = basic;
    *view_numbers(view, DECREMENT, 0) = anticipated;
    *view_numbers(view, COMPLETE, 0) = complete;
    *view_numbers(view, FREQUENCY, 0) = p.frequency;
    return status;
}

const analysis_plan stability_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute_resting = stability_compute};
