// Synchronous response of a machine about its equilibrium: amplitudes, phases, orbits, and the signals of two probes.
#include <math.h>
#include <stdlib.h>

#include "analysis.h"

enum {
    SPEED,
    REST,
    AMPLITUDE,
    LAG,
    AXES,
    INCLINATION,
    PROBE,
    PROBE_LAG,
    PLACED,
    CLEARANCE,
    SEEN,
    SEEN_LAG,
    FIELD_COUNT
};

static size_t unbalance_placed(const block_shape *shape) {
    return shape->options->antinodes_of > 0 || *shape->options->placed_at;
}

static size_t runs_out(const block_shape *shape) {
    return shape->runout_count > 0;
}

static const field_plan fields[FIELD_COUNT] = {
    [SPEED] = {WHIRL_FIELD_UNBALANCE_SPEED, "rad/s", "speed of the shaft", WHIRL_PER_POINT, 1, NULL},
    [REST] = {WHIRL_FIELD_UNBALANCE_REST, "length", "x, y (from the centre)", WHIRL_PER_STATION, 2, NULL},
    [AMPLITUDE] = {WHIRL_FIELD_UNBALANCE_AMPLITUDE, "length", "x, y (0-p amplitudes)", WHIRL_PER_STATION, 2, NULL},
    [LAG] = {WHIRL_FIELD_UNBALANCE_LAG, "deg", "x, y", WHIRL_PER_STATION, 2, NULL},
    [AXES] = {WHIRL_FIELD_UNBALANCE_AXES, "length", "major, minor (0-p amplitudes: semi-axes of the orbit)",
              WHIRL_PER_STATION, 2, NULL},
    [INCLINATION] = {WHIRL_FIELD_UNBALANCE_INCLINATION, "deg", "of the major axis, from the x axis towards y",
                     WHIRL_PER_STATION, 1, NULL},
    [PROBE] = {WHIRL_FIELD_UNBALANCE_PROBE, "length", "first, second (0-p amplitudes)", WHIRL_PER_STATION, 2, NULL},
    [PROBE_LAG] = {WHIRL_FIELD_UNBALANCE_PROBE_LAG, "deg", "first, second", WHIRL_PER_STATION, 2, NULL},
    [PLACED] = {WHIRL_FIELD_UNBALANCE_PLACED, "kg m", "along x, along y (unbalance by rule, when the mark is at x)",
                WHIRL_PER_STATION, 2, unbalance_placed},
    [CLEARANCE] = {WHIRL_FIELD_UNBALANCE_CLEARANCE, "length",
                   "radial clearance, the least of a bearing's and a stator's here (missing without either)",
                   WHIRL_PER_STATION, 1, NULL},
    [SEEN] = {WHIRL_FIELD_UNBALANCE_SEEN, "length", "first, second (0-p amplitudes: not compensated, with runout)",
              WHIRL_PER_STATION, 2, runs_out},
    [SEEN_LAG] = {WHIRL_FIELD_UNBALANCE_SEEN_LAG, "deg", "first, second (not compensated, with runout)",
                  WHIRL_PER_STATION, 2, runs_out},
};

static const double degree = 3.14159265358979323846 / 180.0;

/// Computes the amplitude which a probe along (c, s) reads, and the lag of its peak after the mark, degrees.
static void unbalance_look(const double *x, const double *y, double c, double s, double *amplitude, double *lag) {
    const double real = x[0] * c + y[0] * s, imaginary = x[1] * c + y[1] * s;
    *amplitude = hypot(real, imaginary);
    *lag = *amplitude > 0.0 ? fmod(360.0 - atan2(imaginary, real) / degree, 360.0) : (double)NAN;
}

/// Computes the readings of both probes, the first one at `angle`, with the shaft's runout of order 1, v exp(-i way
/// angle), added to the motion.
static void look_at_surface(const block_view *view, size_t which, const whirl_probe *probe, const double *x,
                            const double *y, double angle) {
    double *amplitude = view_numbers(view, SEEN, which), *lag = view_numbers(view, SEEN_LAG, which);
    const double c = cos(angle), s = sin(angle), back = -whirl_probe_way(probe) * s;
    if (!amplitude || !lag) return;
    for (size_t nth = 0; nth < 2; nth++) {
        const double along[2] = {nth == 0 ? c : -s, nth == 0 ? s : c};
        double seen[2] = {x[0] * along[0] + y[0] * along[1], x[1] * along[0] + y[1] * along[1]};
        for (size_t i = 0; i < probe->runout_count; i++) {
            const double *v = nth == 0 ? probe->runout[i].first : probe->runout[i].second;
            if (probe->runout[i].order != 1) continue;
            seen[0] += v[0] * c - v[1] * back;
            seen[1] += v[1] * c + v[0] * back;
        }
        unbalance_look(seen, (const double[2]){0.0, 0.0}, 1.0, 0.0, &amplitude[nth], &lag[nth]);
    }
}

/// Fills in a station's fields. angle: of the first probe. way: 1 if the shaft turns counter-clockwise, else -1.
static void fill_station(const block_view *view, size_t which, const double *x, const double *y, double angle,
                         double way) {
    double *amplitude = view_numbers(view, AMPLITUDE, which), *lag = view_numbers(view, LAG, which);
    double *probe = view_numbers(view, PROBE, which), *probe_lag = view_numbers(view, PROBE_LAG, which);
    const double c = cos(angle), s = sin(angle);
    unbalance_look(x, y, 1.0, 0.0, &amplitude[0], &lag[0]);
    unbalance_look(x, y, 0.0, 1.0, &amplitude[1], &lag[1]);
    unbalance_look(x, y, c, s, &probe[0], &probe_lag[0]);
    unbalance_look(x, y, -s, c, &probe[1], &probe_lag[1]);
    // x + iy = forward exp(i tau) + backward exp(-i tau).
    const double forward[2] = {0.5 * (x[0] - y[1]), 0.5 * (x[1] + y[0])};
    const double backward[2] = {0.5 * (x[0] + y[1]), 0.5 * (y[0] - x[1])};
    const double f = hypot(forward[0], forward[1]), b = hypot(backward[0], backward[1]);
    view_numbers(view, AXES, which)[0] = f + b;
    view_numbers(view, AXES, which)[1] = way * (f - b);
    const double turned = 0.5 * (atan2(forward[1], forward[0]) + atan2(backward[1], backward[0])) / degree;
    *view_numbers(view, INCLINATION, which) = fmod(turned + 360.0, 180.0);
}

/// Fills in the clearance of each station, and the unbalances that a rule has placed.
static void fill_stations(const whirl_resting *point, const block_view *view) {
    for (size_t p = 0; p < point->system->probe_count; p++) {
        const whirl_probe *probe = &point->system->probes[p];
        const double bearing = probe->clearance > 0.0 ? probe->clearance : (double)NAN;
        *view_numbers(view, CLEARANCE, p) = fmin(bearing, probe->gap > 0.0 ? probe->gap : (double)NAN);
        double *own = view_numbers(view, PLACED, p);
        if (own) own[0] = own[1] = 0.0;
    }
    for (size_t i = 0; i < point->placed_count; i++) {
        double *own = view_numbers(view, PLACED, point->placed[i].station);
        if (!own) continue;
        own[0] += point->placed[i].moment * cos(point->placed[i].angle);
        own[1] += point->placed[i].moment * sin(point->placed[i].angle);
    }
}

static whirl_status unbalance_compute(const whirl_resting *point, const whirl_record_options *options,
                                      const block_view *view) {
    const whirl_system *system = point->system;
    const size_t d = system->dimension;
    double *rest = calloc(3 * d + 1, sizeof *rest), *response = rest ? rest + d : NULL;
    if (!rest) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the response of %zu coordinates", d);
    whirl_status status = whirl_synchronous_check(system, point->speed);
    if (status.code == WHIRL_OK) status = whirl_forced_response(system, point->start, rest, response);
    *view_numbers(view, SPEED, 0) = point->speed;
    fill_stations(point, view);
    for (size_t p = 0; p < system->probe_count && status.code == WHIRL_OK; p++) {
        const whirl_probe *probe = &system->probes[p];
        const double nothing[2] = {0.0, 0.0};
        for (size_t c = 0; c < 2; c++) view_numbers(view, REST, p)[c] = whirl_probe_value(probe, rest, c);
        const double *x = whirl_probe_sees(probe, 0) ? response + 2 * probe->x : nothing;
        const double *y = whirl_probe_sees(probe, 1) ? response + 2 * probe->y : nothing;
        fill_station(view, p, x, y, options->probe_angle, whirl_probe_way(probe));
        look_at_surface(view, p, probe, x, y, options->probe_angle);
    }
    free(rest);
    return status;
}

const analysis_plan unbalance_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute_resting = unbalance_compute};
