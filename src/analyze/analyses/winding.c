// Whirl: how often and in which sense every station goes round its mean position, and dry whip.
#include <math.h>

#include "analysis.h"

enum { WINDING, BACKWARD, DIRECTION, CONTACT, DRY_WHIP, FIELD_COUNT };

static const field_plan fields[FIELD_COUNT] = {
    [WINDING] = {WHIRL_FIELD_WINDING_WINDING, "1",
                 "turns round the mean position per revolution, above 0 with the rotation", WHIRL_PER_STATION, 1, NULL},
    [BACKWARD] = {WHIRL_FIELD_WINDING_BACKWARD, "1",
                  "share of the time in which it turns against the rotation (about the mean position)",
                  WHIRL_PER_STATION, 1, NULL},
    [DIRECTION] = {WHIRL_FIELD_WINDING_DIRECTION, "1", "1 forward, -1 backward, 0 mixed", WHIRL_PER_STATION, 1, NULL},
    [CONTACT] = {WHIRL_FIELD_WINDING_CONTACT, "1", "share of the time beyond the gap (missing without a gap)",
                 WHIRL_PER_STATION, 1, NULL},
    [DRY_WHIP] = {WHIRL_FIELD_WINDING_DRY_WHIP, "1",
                  "1 for backward whirl in lasting contact, at no order of the shaft, else 0", WHIRL_PER_STATION, 1,
                  NULL},
};

static const double pi = 3.141592653589793238463;

/// Share of the time over which whirl must keep its direction; share from which on contact is lasting.
static const double constant_share = 0.95, lasting_share = 0.95;

/// The path of one station.
typedef struct path {
    size_t count;
    double way; ///< 1 if the shaft turns counter-clockwise, else -1
    const double *x, *y;
    double centre[2];
    double reach;     ///< square of the largest distance from the centre of the path
    double excursion; ///< square of the largest distance from (0, 0)
} path;

static path path_of(const whirl_record *record, size_t station) {
    path p = {.count = record->sample_count, .x = record->waveform + 2 * station * record->sample_count};
    p.way = whirl_probe_way(&record->probes[station]);
    p.y = p.x + p.count;
    for (size_t j = 0; j < p.count; j++) {
        p.centre[0] += p.x[j] / (double)p.count;
        p.centre[1] += p.y[j] / (double)p.count;
    }
    for (size_t j = 0; j < p.count; j++) {
        const double dx = p.x[j] - p.centre[0], dy = p.y[j] - p.centre[1];
        p.reach = fmax(p.reach, dx * dx + dy * dy);
        p.excursion = fmax(p.excursion, p.x[j] * p.x[j] + p.y[j] * p.y[j]);
    }
    return p;
}

/// Turns round the centre, forward and backward.
typedef struct turns {
    double sum;      ///< forward minus backward
    double backward; ///< share of the samples
} turns;

/// Returns the angle of a point of the path about the centre of the path, in turns, 0 to 1.
static double angle_at(const path *p, size_t j) {
    const double angle = atan2(p->y[j] - p->centre[1], p->x[j] - p->centre[0]) / (2.0 * pi);
    return angle < 0.0 ? angle + 1.0 : angle;
}

/// Counts whole turns, which end where the path crosses the half line to the right of its centre.
static turns count_turns(const path *p) {
    double whole = 0.0, backward = 0.0;
    for (size_t j = 1; j < p->count; j++) {
        const double ax = p->x[j - 1] - p->centre[0], ay = p->y[j - 1] - p->centre[1];
        const double bx = p->x[j] - p->centre[0], by = p->y[j] - p->centre[1];
        const double momentum = ax * by - ay * bx;
        whole += ay < 0.0 && by >= 0.0 && momentum > 0.0 ? 1.0 : 0.0;
        whole -= ay >= 0.0 && by < 0.0 && momentum < 0.0 ? 1.0 : 0.0;
        backward += p->way * momentum < 0.0 ? 1.0 : 0.0;
    }
    const double sum = whole + angle_at(p, p->count - 1) - angle_at(p, 0);
    return (turns){p->way * sum, backward / (double)(p->count - 1)};
}

static double contact_share(const path *p, double gap) {
    double touching = 0.0;
    for (size_t j = 0; j < p->count; j++) touching += p->x[j] * p->x[j] + p->y[j] * p->y[j] > gap * gap ? 1.0 : 0.0;
    return touching / (double)p->count;
}

/// Returns true for dry whip, or dry whirl where it rolls: friction at a lasting contact drives the station backward
/// round its stator. No excitation has that frequency, so it belongs to rotor and stator together, or to rolling (Black
/// 1968; Jiang, Ulbrich 2005). A whole order would be a response to unbalance or an asymmetric shaft.
static bool is_dry_whip(double contact, double direction, double winding, double resolution) {
    return contact >= lasting_share && direction < 0.0 && fabs(winding - round(winding)) > 2.0 * resolution;
}

static void winding_describe(const whirl_record *record, size_t station, const block_view *view) {
    const path p = path_of(record, station);
    const double gap = record->probes[station].gap,
                 revolutions = (double)p.count / (double)record->samples_per_revolution;
    const double contact = gap > 0.0 ? contact_share(&p, gap) : NAN;
    double winding = 0.0, direction = 0.0;
    *view_numbers(view, CONTACT, station) = contact;
    if (p.count > 1 && p.reach > MIN_MOTION * MIN_MOTION * p.excursion) {
        const turns t = count_turns(&p);
        winding = t.sum * (double)p.count / ((double)(p.count - 1) * revolutions);
        direction = t.backward >= constant_share ? -1.0 : t.backward <= 1.0 - constant_share ? 1.0 : 0.0;
        *view_numbers(view, WINDING, station) = winding;
        *view_numbers(view, BACKWARD, station) = t.backward;
        *view_numbers(view, DIRECTION, station) = direction;
    }
    if (gap > 0.0)
        *view_numbers(view, DRY_WHIP, station) =
            is_dry_whip(contact, direction, winding, 1.0 / revolutions) ? 1.0 : 0.0;
}

static whirl_status winding_compute(const whirl_record *record, const whirl_record_options *options,
                                    const block_view *view) {
    (void)options;
    for (size_t s = 0; s < record->probe_count; s++)
        if (record->probes[s].x != record->probes[s].y)
            winding_describe(record, s, view); // a single coordinate has no sense of whirl
    return whirl_ok();
}

const analysis_plan winding_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .needs_waveform = true, .compute = winding_compute};
