// What the weight does to the shafts of a machine: sag, moments, loads of bearings, elevations for its couplings.
#include "analysis.h"

enum { LOAD, DEFLECTION, SLOPE, MOMENT, SHEAR, MASS, ELEVATION, INFLUENCE, FIELD_COUNT };

static size_t every_station(const block_shape *shape) {
    return shape->station_count;
}

static const field_plan fields[FIELD_COUNT] = {
    [LOAD] = {WHIRL_FIELD_STATICS_LOAD, "N", "of the bearings here, upwards on the shaft (missing where there is none)",
              WHIRL_PER_STATION, 1, NULL},
    [DEFLECTION] = {WHIRL_FIELD_STATICS_DEFLECTION, "length", "of the shaft, upwards", WHIRL_PER_STATION, 1, NULL},
    [SLOPE] = {WHIRL_FIELD_STATICS_SLOPE, "rad", "of the shaft, rising along it", WHIRL_PER_STATION, 1, NULL},
    [MOMENT] = {WHIRL_FIELD_STATICS_MOMENT, "N m", "bending moment, above 0 where the shaft sags", WHIRL_PER_STATION, 1,
                NULL},
    [SHEAR] = {WHIRL_FIELD_STATICS_SHEAR, "N", "left, right (of the station: all forces from the left end on)",
               WHIRL_PER_STATION, 2, NULL},
    [MASS] = {WHIRL_FIELD_STATICS_MASS, "kg", "left, right (of the station: of the shaft and what it carries)",
              WHIRL_PER_STATION, 2, NULL},
    [ELEVATION] = {WHIRL_FIELD_STATICS_ELEVATION, "length",
                   "of the bearings here, for no moment and no shear at the couplings", WHIRL_PER_STATION, 1, NULL},
    [INFLUENCE] = {WHIRL_FIELD_STATICS_INFLUENCE, "N/m",
                   "load of the bearings here by raising those at each station (0: there are none)", WHIRL_PER_STATION,
                   1, every_station},
};

static whirl_status compute(const whirl_resting *point, const whirl_record_options *options, const block_view *view) {
    const size_t probes = point->system->probe_count;
    whirl_machine machine = {.statics = NULL};
    (void)options;
    const whirl_status status = point->at_speed(point->context, 0.0, WHIRL_WITH_STATICS, 0.0, &machine);
    if (status.code != WHIRL_OK) return status;
    for (size_t p = 0; p < probes && machine.statics; p++) {
        const whirl_station_statics *at = &machine.statics[p];
        *view_numbers(view, LOAD, p) = at->load;
        *view_numbers(view, DEFLECTION, p) = at->deflection / machine.length;
        *view_numbers(view, SLOPE, p) = at->slope;
        *view_numbers(view, MOMENT, p) = at->moment;
        *view_numbers(view, ELEVATION, p) = at->elevation / machine.length;
        for (size_t i = 0; i < 2; i++) view_numbers(view, SHEAR, p)[i] = at->shear[i];
        for (size_t i = 0; i < 2; i++) view_numbers(view, MASS, p)[i] = at->mass[i];
        memcpy(view_numbers(view, INFLUENCE, p), machine.influence + p * probes, probes * sizeof *machine.influence);
    }
    if (machine.release) machine.release(machine.owner);
    return machine.statics ? status : whirl_fail(WHIRL_BAD_INPUT, "the machine does not tell what its weight does");
}

const analysis_plan statics_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute_resting = compute};
