// Static effects of weight on the shafts of a machine: sag, moments, bearing loads, elevations for its couplings.
#include <math.h>
#include <stdlib.h>

#include "analysis.h"
#include "critical_speeds.h"
#include "statics.h"

enum {
    LOAD,
    DEFLECTION,
    SLOPE,
    MOMENT,
    SHEAR,
    MASS,
    ELEVATION,
    AXIAL_FORCE,
    THRUST,
    THRUST_MASS,
    INFLUENCE,
    ECCENTRICITY,
    ATTITUDE,
    FILM,
    PLACE,
    SEAL,
    UNLOADED,
    STIFFNESS,
    DAMPING,
    FIELD_COUNT
};

static size_t every_station(const block_shape *shape) {
    return shape->station_count;
}

static const field_plan fields[FIELD_COUNT] = {
    [LOAD] = {WHIRL_FIELD_STATICS_LOAD, "N",
              "load of the bearings here, upwards on the shaft (missing without a bearing)", WHIRL_PER_STATION, 1,
              NULL},
    [DEFLECTION] = {WHIRL_FIELD_STATICS_DEFLECTION, "length", "deflection of the shaft, upwards", WHIRL_PER_STATION, 1,
                    NULL},
    [SLOPE] = {WHIRL_FIELD_STATICS_SLOPE, "rad", "slope of the shaft, above 0 where it rises along the shaft",
               WHIRL_PER_STATION, 1, NULL},
    [MOMENT] = {WHIRL_FIELD_STATICS_MOMENT, "N m", "bending moment, above 0 where the shaft sags", WHIRL_PER_STATION, 1,
                NULL},
    [SHEAR] = {WHIRL_FIELD_STATICS_SHEAR, "N", "left, right (of the station: all forces from the left end on)",
               WHIRL_PER_STATION, 2, NULL},
    [MASS] = {WHIRL_FIELD_STATICS_MASS, "kg", "left, right (of the station: of the shaft and what it carries)",
              WHIRL_PER_STATION, 2, NULL},
    [ELEVATION] = {WHIRL_FIELD_STATICS_ELEVATION, "length",
                   "elevation of the bearings here, for no moment and no shear at the couplings", WHIRL_PER_STATION, 1,
                   NULL},
    [AXIAL_FORCE] = {WHIRL_FIELD_STATICS_AXIAL_FORCE, "N",
                     "left, right (of the station, in the shaft: above 0 where it is pulled)", WHIRL_PER_STATION, 2,
                     NULL},
    [THRUST] = {WHIRL_FIELD_STATICS_THRUST, "N",
                "load of the thrust bearing of a vertical shaft here, upwards on the shaft (missing without one)",
                WHIRL_PER_STATION, 1, NULL},
    [THRUST_MASS] = {WHIRL_FIELD_STATICS_THRUST_MASS, "kg", "mass of that shaft with all its parts", WHIRL_PER_STATION,
                     1, NULL},
    [INFLUENCE] = {WHIRL_FIELD_STATICS_INFLUENCE, "N/m",
                   "load of the bearings here by raising those at each station (0: no bearing)", WHIRL_PER_STATION, 1,
                   every_station},
    [ECCENTRICITY] = {WHIRL_FIELD_STATICS_ECCENTRICITY, "1",
                      "eccentricity ratio of the journal in its film at rest, from the housing, over the clearance as "
                      "assembled (missing without a film)",
                      WHIRL_PER_STATION, 1, NULL},
    [ATTITUDE] = {WHIRL_FIELD_STATICS_ATTITUDE, "deg",
                  "angle from the load of the film to the journal at rest, with the rotation", WHIRL_PER_STATION, 1,
                  NULL},
    [FILM] = {WHIRL_FIELD_STATICS_FILM, "length", "least radial thickness of the film at rest, over pads with a film",
              WHIRL_PER_STATION, 1, NULL},
    [PLACE] = {WHIRL_FIELD_STATICS_PLACE, "length",
               "x, y (of the journal at rest, from the centre of its bearing or seal as assembled)", WHIRL_PER_STATION,
               2, NULL},
    [SEAL] = {WHIRL_FIELD_STATICS_SEAL, "1", "1: the film is that of a seal, which carries nothing; else 0",
              WHIRL_PER_STATION, 1, NULL},
    [UNLOADED] =
        {WHIRL_FIELD_STATICS_UNLOADED, "1",
         "pads that tilt without a film, their numbers as digits: 23 are pads 2 and 3 (missing where none tilt)",
         WHIRL_PER_STATION, 1, NULL},
    [STIFFNESS] = {WHIRL_FIELD_STATICS_STIFFNESS, "N/m",
                   "kxx, kxy, kyx, kyy (of the bearings here at the speed, of films about the position of rest, with "
                   "internal motions once a revolution; missing without a bearing)",
                   WHIRL_PER_STATION, 4, NULL},
    [DAMPING] = {WHIRL_FIELD_STATICS_DAMPING, "N s/m", "cxx, cxy, cyx, cyy (of these bearings, likewise)",
                 WHIRL_PER_STATION, 4, NULL},
};

static bool film_of_probe(const whirl_system *system, const double *x, size_t probe, whirl_film_gap *out) {
    return system->film && system->film(system->model, x, probe, out);
}

/// Adds to force [2] the force on the journal of a film: the acceleration of the journal's station, of 1 kg, in
/// `slope`. Adds the same for the journals whose films have this station as their housing, such as the inner film of a
/// floating ring.
static void force_of_film(const whirl_system *alone, const double *x, const double *slope, size_t probe, size_t inner,
                          double *force) {
    enum { MAX_INNER = 4 };
    whirl_film_gap gap;
    for (size_t c = 0; c < 2; c++) force[c] += whirl_probe_value(&alone->probes[probe], slope, 2 + c);
    for (size_t p = 0; p < alone->probe_count && inner < MAX_INNER; p++)
        if (film_of_probe(alone, x, p, &gap) && gap.housing == probe)
            force_of_film(alone, x, slope, p, inner + 1, force);
}

/// Computes the forces of the bearings' films on their journals (stations of 1 kg), with the machine at rest at x, as
/// accelerations [probes][2]; NaN without a film.
static whirl_status forces_at(const whirl_resting *point, const double *x, double *force) {
    whirl_machine alone;
    whirl_status status = point->at_speed(point->context, point->speed, WHIRL_BEARINGS_OF_IT, 0.0, &alone);
    if (status.code != WHIRL_OK) return status;
    const whirl_system *system = alone.system;
    const size_t d = system->dimension;
    double *at = calloc((2 + d) * d + 1, sizeof *at), *slope = at ? at + d : NULL;
    if (!at) status = whirl_fail(WHIRL_NO_MEMORY, "no memory for the forces of films");
    if (at) bearings_place(system, at, point->system, x);
    if (at) status = whirl_rest_slope(system, at, slope, slope + d);
    for (size_t p = 0; p < system->probe_count && at; p++) {
        whirl_film_gap gap;
        const bool film = film_of_probe(system, at, p, &gap);
        force[2 * p] = force[2 * p + 1] = film ? 0.0 : NAN;
        if (film) force_of_film(system, at, slope, p, 0, force + 2 * p);
    }
    free(at);
    if (alone.release) alone.release(alone.owner);
    return status;
}

/// Fills in the fields of a film, which has force [2] on its journal.
static void fill_film(const whirl_probe *probe, const whirl_film_gap *gap, const double *force, size_t which,
                      const block_view *view) {
    const double *at = gap->place, radius = hypot(at[0], at[1]);
    const double across = force[1] * at[0] - force[0] * at[1], along = -force[0] * at[0] - force[1] * at[1];
    double unloaded = 0.0;
    for (size_t pad = 0; pad < gap->pads; pad++)
        if (!gap->held[pad]) unloaded = 10.0 * unloaded + (double)pad + 1.0;
    *view_numbers(view, ECCENTRICITY, which) = radius / gap->clearance;
    *view_numbers(view, FILM, which) = gap->least;
    memcpy(view_numbers(view, PLACE, which), at, sizeof gap->place);
    if (gap->pads > 0) *view_numbers(view, UNLOADED, which) = unloaded;
    *view_numbers(view, SEAL, which) = isnan(force[0]) ? 1.0 : 0.0;
    // The film carries the load. A centred journal (within rounding) has no attitude angle.
    if (hypot(force[0], force[1]) > 0.0 && radius > 1e-9 * gap->clearance)
        *view_numbers(view, ATTITUDE, which) =
            whirl_probe_way(probe) * atan2(across, along) * (180.0 / 3.14159265358979323846);
}

bool films_any(const whirl_system *system, const double *x) {
    whirl_film_gap gap;
    for (size_t p = 0; p < system->probe_count; p++)
        if (film_of_probe(system, x, p, &gap)) return true;
    return false;
}

/// Fills in the journals' equilibria in their films, if the machine turns and has an equilibrium.
static whirl_status fill_films(const whirl_resting *point, const block_view *view) {
    const whirl_system *system = point->system;
    const size_t d = system->dimension, probes = system->probe_count;
    whirl_film_gap gap;
    if (!films_any(system, point->start)) return whirl_ok();
    double *x = calloc(d + 2 * probes + 1, sizeof *x), *force = x ? x + d : NULL;
    if (!x) return whirl_fail(WHIRL_NO_MEMORY, "no memory for films at rest");
    memcpy(x, point->start, d * sizeof *x);
    whirl_status status = whirl_equilibrium(system, x);
    if (status.code == WHIRL_OK) status = forces_at(point, x, force);
    for (size_t p = 0; p < probes && status.code == WHIRL_OK; p++)
        if (film_of_probe(system, x, p, &gap)) fill_film(&system->probes[p], &gap, force + 2 * p, p, view);
    free(x);
    return status.code == WHIRL_NUMERICAL_FAILURE ? whirl_ok() : status;
}

/// Fills in stiffness and damping of bearings at the equilibrium of a turning machine. They stay missing beyond the
/// speeds of a bearing's table, and for bearings that have neither.
static whirl_status fill_coefficients(const whirl_resting *point, const block_view *view) {
    const size_t probes = point->system->probe_count;
    double *numbers = malloc((8 * probes + 1) * sizeof *numbers);
    if (!numbers) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the coefficients of bearings");
    const whirl_status status = whirl_bearings_at(point, point->speed, numbers);
    for (size_t p = 0; p < probes && status.code == WHIRL_OK; p++) {
        bool any = false;
        for (size_t i = 0; i < 8; i++) any = any || numbers[8 * p + i] != 0.0;
        if (!any) continue;
        memcpy(view_numbers(view, STIFFNESS, p), numbers + 8 * p, 4 * sizeof *numbers);
        memcpy(view_numbers(view, DAMPING, p), numbers + 8 * p + 4, 4 * sizeof *numbers);
    }
    free(numbers);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

static whirl_status statics_compute(const whirl_resting *point, const whirl_record_options *options,
                                    const block_view *view) {
    const size_t probes = point->system->probe_count;
    whirl_machine machine = {.statics = NULL};
    (void)options;
    whirl_status status = point->at_speed(point->context, 0.0, WHIRL_WITH_STATICS, 0.0, &machine);
    if (status.code != WHIRL_OK) return status;
    // Fill in the effects of weight, from the machine at standstill.
    for (size_t p = 0; p < probes && machine.statics; p++) {
        const whirl_station_statics *at = &machine.statics[p];
        *view_numbers(view, LOAD, p) = at->load;
        *view_numbers(view, DEFLECTION, p) = at->deflection / machine.length;
        *view_numbers(view, SLOPE, p) = at->slope;
        *view_numbers(view, MOMENT, p) = at->moment;
        *view_numbers(view, ELEVATION, p) = at->elevation / machine.length;
        *view_numbers(view, THRUST, p) = at->thrust;
        *view_numbers(view, THRUST_MASS, p) = at->thrust_mass;
        for (size_t i = 0; i < 2; i++) view_numbers(view, AXIAL_FORCE, p)[i] = at->axial[i];
        for (size_t i = 0; i < 2; i++) view_numbers(view, SHEAR, p)[i] = at->shear[i];
        for (size_t i = 0; i < 2; i++) view_numbers(view, MASS, p)[i] = at->mass[i];
        memcpy(view_numbers(view, INFLUENCE, p), machine.influence + p * probes, probes * sizeof *machine.influence);
    }
    if (machine.release) machine.release(machine.owner);
    if (!machine.statics) return whirl_fail(WHIRL_BAD_INPUT, "the machine has no statics");
    // Fill in films and coefficients, at the point's speed.
    status = fill_films(point, view);
    return status.code == WHIRL_OK ? fill_coefficients(point, view) : status;
}

const analysis_plan statics_analysis = {
    .fields = fields, .field_count = FIELD_COUNT, .compute_resting = statics_compute};
