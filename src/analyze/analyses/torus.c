// Tori past Neimark-Sacker points, as numbers in a block.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis.h"

enum {
    NUMBER,
    BRANCH,
    POINT,
    BEGINS,
    END,
    LIMIT,
    REVOLUTIONS,
    ROTATION,
    RESONANCE,
    RADIUS,
    UNSTABLE,
    EXPONENT,
    EXPONENT_ERROR,
    VOLUME,
    NODE_COUNT,
    RESIDUAL,
    ERROR,
    TAIL,
    EXPONENTS,
    NODES,
    FREQUENCY,
    AMPLITUDE,
    LOW,
    HIGH,
    SECTION_LOW,
    SECTION_HIGH,
    SECTION,
    AXIAL,
    TWIST,
    FIELD_COUNT
};

static size_t most_nodes(const block_shape *shape) {
    return whirl_trace_torus_nodes(&shape->options->trace);
}

static size_t numbers_of_nodes(const block_shape *shape) {
    return most_nodes(shape) * shape->dimension;
}

static const field_plan fields[FIELD_COUNT] = {
    [NUMBER] = {WHIRL_FIELD_TORUS_NUMBER, "1",
                "number of the branch of tori, from 1 in the order of the points at which they begin", WHIRL_PER_POINT,
                1, NULL},
    [BRANCH] = {WHIRL_FIELD_TORUS_BRANCH, "1", "the branch of orbits along which it begins", WHIRL_PER_POINT, 1, NULL},
    [POINT] = {WHIRL_FIELD_TORUS_POINT, "1", "the point of the table of branches at which it begins, from 1",
               WHIRL_PER_POINT, 1, NULL},
    [BEGINS] = {WHIRL_FIELD_TORUS_BEGINS, "1", "value of the parameter there, in SI", WHIRL_PER_POINT, 1, NULL},
    [END] = {WHIRL_FIELD_TORUS_END, "1",
             "reason for the end of the branch of tori here: 0 range, 1 points, 2 shrinks to an orbit, 3 rough or "
             "locks, 4 lost, 5 stopped, 6 none is found; else missing",
             WHIRL_PER_POINT, 1, NULL},
    [LIMIT] =
        {WHIRL_FIELD_TORUS_LIMIT, "1",
         "value of the parameter, in SI, at which its radius vanishes or its motion locks, from the last two points",
         WHIRL_PER_POINT, 1, NULL},
    [REVOLUTIONS] = {WHIRL_FIELD_TORUS_REVOLUTIONS, "revolution", "revolutions from one section to the next",
                     WHIRL_PER_POINT, 1, NULL},
    [ROTATION] = {WHIRL_FIELD_TORUS_ROTATION, "1", "turns round the closed curve from one section to the next",
                  WHIRL_PER_POINT, 1, NULL},
    [RESONANCE] = {WHIRL_FIELD_TORUS_RESONANCE, "1", "p, q", WHIRL_PER_POINT, 2, NULL},
    [RADIUS] = {WHIRL_FIELD_TORUS_RADIUS, "1",
                "greatest distance of a coordinate of the state from its mean along the closed curve", WHIRL_PER_POINT,
                1, NULL},
    [UNSTABLE] = {WHIRL_FIELD_TORUS_UNSTABLE, "1", "normal exponents above 0 by more than their errors: stable at 0",
                  WHIRL_PER_POINT, 1, NULL},
    [EXPONENT] = {WHIRL_FIELD_TORUS_EXPONENT, "1/revolution", "largest normal Lyapunov exponent", WHIRL_PER_POINT, 1,
                  NULL},
    [EXPONENT_ERROR] = {WHIRL_FIELD_TORUS_EXPONENT_ERROR, "1/revolution", "its error", WHIRL_PER_POINT, 1, NULL},
    [VOLUME] = {WHIRL_FIELD_TORUS_VOLUME, "1/revolution", "sum of all exponents by the divergence", WHIRL_PER_POINT, 1,
                NULL},
    [NODE_COUNT] = {WHIRL_FIELD_TORUS_NODE_COUNT, "1", "nodes of the closed curve", WHIRL_PER_POINT, 1, NULL},
    [RESIDUAL] = {WHIRL_FIELD_TORUS_RESIDUAL, "1",
                  "error by which the curve fails to be carried onto itself at its nodes", WHIRL_PER_POINT, 1, NULL},
    [ERROR] = {WHIRL_FIELD_TORUS_ERROR, "1", "the same error between the nodes, over the radius of the curve",
               WHIRL_PER_POINT, 1, NULL},
    [TAIL] = {WHIRL_FIELD_TORUS_TAIL, "1", "last two harmonics of the curve over its largest", WHIRL_PER_POINT, 1,
              NULL},
    [EXPONENTS] = {WHIRL_FIELD_TORUS_EXPONENTS, "1/revolution", "exponent, error", WHIRL_PER_POINT, 2,
                   rows_per_coordinate},
    [NODES] = {WHIRL_FIELD_TORUS_NODES, "1", "states at equal angles of the closed curve, one after the other",
               WHIRL_PER_POINT, 1, numbers_of_nodes},
    [FREQUENCY] = {WHIRL_FIELD_TORUS_FREQUENCY, "order", "x, y", WHIRL_PER_STATION, 2, NULL},
    [AMPLITUDE] = {WHIRL_FIELD_TORUS_AMPLITUDE, "length", "x, y (0-p amplitudes at its second frequency)",
                   WHIRL_PER_STATION, 2, NULL},
    [LOW] = {WHIRL_FIELD_TORUS_LOW, "length", "x, y (least at any instant, from the centre)", WHIRL_PER_STATION, 2,
             NULL},
    [HIGH] = {WHIRL_FIELD_TORUS_HIGH, "length", "x, y (most at any instant, from the centre)", WHIRL_PER_STATION, 2,
              NULL},
    [SECTION_LOW] = {WHIRL_FIELD_TORUS_SECTION_LOW, "length", "x, y (least in the section, from the centre)",
                     WHIRL_PER_STATION, 2, rows_of_longest_orbit},
    [SECTION_HIGH] = {WHIRL_FIELD_TORUS_SECTION_HIGH, "length", "x, y (most in the section, from the centre)",
                      WHIRL_PER_STATION, 2, rows_of_longest_orbit},
    [SECTION] = {WHIRL_FIELD_TORUS_SECTION, "length",
                 "x, y, vx, vy (from the centre; velocities are lengths per unit of the system's time)",
                 WHIRL_PER_STATION, 4, most_nodes},
    [AXIAL] = {WHIRL_FIELD_TORUS_AXIAL, "length",
               "least, largest (axial displacement at any instant; missing where the station does not move along its "
               "shaft)",
               WHIRL_PER_STATION, 2, rows_of_axial},
    [TWIST] = {WHIRL_FIELD_TORUS_TWIST, "rad",
               "least, largest (twist at any instant; missing where the station does not twist, or moves no other way)",
               WHIRL_PER_STATION, 2, rows_of_twist},
};

static void put_place(const block_view *view, const whirl_torus_trace *trace) {
    *view_numbers(view, NUMBER, 0) = (double)trace->number;
    *view_numbers(view, BRANCH, 0) = (double)trace->branch;
    *view_numbers(view, POINT, 0) = (double)trace->point;
    *view_numbers(view, BEGINS, 0) = trace->begins;
    *view_numbers(view, END, 0) = trace->end;
    *view_numbers(view, LIMIT, 0) = trace->limit;
}

static void put_torus(const block_view *view, const whirl_torus *torus) {
    double *resonance = view_numbers(view, RESONANCE, 0), *exponents = view_numbers(view, EXPONENTS, 0);
    // Write the rotation number, and the resonance near it.
    *view_numbers(view, REVOLUTIONS, 0) = (double)torus->revolutions;
    *view_numbers(view, ROTATION, 0) = torus->rotation;
    if (torus->resonance > 0) {
        resonance[0] = round((double)torus->resonance * torus->rotation);
        resonance[1] = (double)torus->resonance;
    }
    // Write the measures of the curve.
    *view_numbers(view, RADIUS, 0) = torus->radius;
    *view_numbers(view, UNSTABLE, 0) = (double)torus->unstable;
    *view_numbers(view, VOLUME, 0) = torus->volume;
    *view_numbers(view, NODE_COUNT, 0) = (double)torus->node_count;
    *view_numbers(view, RESIDUAL, 0) = torus->residual;
    *view_numbers(view, ERROR, 0) = torus->error;
    *view_numbers(view, TAIL, 0) = torus->tail;
    // Write the exponents of perturbations normal to the curve.
    for (size_t i = 0; i < torus->exponent_count; i++) {
        exponents[2 * i] = torus->exponents[i];
        exponents[2 * i + 1] = torus->exponent_errors[i];
    }
    if (torus->exponent_count > 0) {
        *view_numbers(view, EXPONENT, 0) = torus->exponents[0];
        *view_numbers(view, EXPONENT_ERROR, 0) = torus->exponent_errors[0];
    }
    memcpy(view_numbers(view, NODES, 0), torus->nodes, torus->node_count * torus->dimension * sizeof *torus->nodes);
}

static void put_station(const block_view *view, const whirl_torus_trace *trace, size_t which) {
    const whirl_probe *probe = &trace->system->probes[which];
    const whirl_torus *torus = trace->torus;
    const whirl_torus_view *seen = trace->view;
    double *section = view_numbers(view, SECTION, which);
    for (size_t j = 0; j < torus->node_count; j++)
        for (size_t c = 0; c < 4; c++) *section++ = whirl_probe_value(probe, torus->nodes + j * torus->dimension, c);
    for (size_t c = 0; c < 2; c++) {
        view_numbers(view, FREQUENCY, which)[c] =
            whirl_probe_sees(probe, c) ? seen->frequency[c ? probe->y : probe->x] : 0.0;
        view_numbers(view, AMPLITUDE, which)[c] = fabs(whirl_probe_value(probe, seen->amplitude, c));
        double bounds[2];
        probe_bounds(probe, seen->low, seen->high, c, bounds);
        view_numbers(view, LOW, which)[c] = bounds[0];
        view_numbers(view, HIGH, which)[c] = bounds[1];
        for (size_t k = 0; k < torus->revolutions; k++) {
            const size_t row = k * seen->dimension;
            probe_bounds(probe, seen->section_low + row, seen->section_high + row, c, bounds);
            view_numbers(view, SECTION_LOW, which)[2 * k + c] = bounds[0];
            view_numbers(view, SECTION_HIGH, which)[2 * k + c] = bounds[1];
        }
    }
}

/// Writes the bounds of the axial displacements and twists.
static void put_extras(const block_view *view, const whirl_system *system, const double *low, const double *high) {
    for (size_t i = 0; i < system->extra_count; i++)
        probe_bounds(&system->probes[system->probe_count + i], low, high, 0,
                     view_numbers(view, system->extras[i].twists ? TWIST : AXIAL, system->extras[i].station));
}

static whirl_status torus_compute(const whirl_torus_trace *trace, const whirl_record_options *options,
                                  const block_view *view) {
    const whirl_torus *torus = trace->torus;
    const size_t most = whirl_trace_torus_nodes(&options->trace), longest_orbit = (size_t)options->trace.longest;
    put_place(view, trace);
    if (!torus) return whirl_ok();
    if (torus->node_count > most || torus->revolutions > longest_orbit)
        return whirl_fail(WHIRL_BAD_INPUT, "a torus of %zu nodes and %zu revolutions, expected at most %zu and %zu",
                          torus->node_count, torus->revolutions, most, longest_orbit);
    put_torus(view, torus);
    for (size_t i = 0; i < trace->system->probe_count; i++) put_station(view, trace, i);
    put_extras(view, trace->system, trace->view->low, trace->view->high);
    return whirl_ok();
}

const analysis_plan torus_analysis = {.fields = fields, .field_count = FIELD_COUNT, .compute_torus = torus_compute};

size_t whirl_trace_torus_nodes(const whirl_trace_options *options) {
    return (size_t)options->torus_nodes | 1u;
}

void whirl_torus_end_text(double end, double p, double q, char *text, size_t size) {
    static const char *const texts[] = {
        [WHIRL_TORUS_END_OF_RANGE] = "the bound is reached",
        [WHIRL_TORUS_END_OF_POINTS] = "there are as many points as were asked for",
        [WHIRL_TORUS_SHRANK] = "it shrinks to an orbit",
        [WHIRL_TORUS_ROUGH] = "its curve is rough: it needs more nodes than allowed",
        [WHIRL_TORUS_LOST] = "no torus is found beyond",
        [WHIRL_TORUS_STOPPED] = "it was stopped",
        [WHIRL_TORUS_NONE] = "none is found at the point",
    };
    if (end == WHIRL_TORUS_ROUGH && q > 0.0)
        snprintf(text, size, "it locks near %.0f/%.0f", p, q);
    else
        snprintf(text, size, "%s", end >= 0.0 && end <= WHIRL_TORUS_NONE ? texts[(size_t)end] : "");
}
