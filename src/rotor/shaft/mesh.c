// Makes nodes and finite elements from segments and stations.
#include "mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "registry.h"

// ---------------------------------------------------------------- segments

/// A segment and its extent.
typedef struct span {
    size_t element; ///< index in the design
    size_t shaft;
    double from, to;
    const key_value *values;
    material of;
} span;

/// State of the meshing.
typedef struct meshing {
    const whirl_design *design;
    mesh *out;
    span *spans;
    size_t span_count, *culprit;
    double *position; ///< [station_count] NaN: not on a shaft
    size_t *shaft;    ///< [station_count]
    double *breaks;   ///< positions of nodes on the present shaft
    size_t break_count;
    size_t capacity;
} meshing;

static whirl_status find_material(const whirl_design *design, const key_value *own, const key_value *shafts,
                                  material *out) {
    const key_value *said = own->given ? own : shafts;
    *out = shaft_steel;
    if (!said->given || said->station[0] == design->material_count) return whirl_ok(); // steel
    const design_part *found = &design->materials[said->station[0]];
    const whirl_status status = material_from(found->values, out);
    if (status.code == WHIRL_OK) return status;
    return whirl_fail(status.code, "material '%s' %.300s", found->name, status.message);
}

static whirl_status shaft_of(const whirl_design *design, const key_value *value, size_t *shaft) {
    *shaft = value->given ? value->station[0] : 0;
    if (!value->given && design->shaft_count > 1)
        return whirl_fail(WHIRL_BAD_INPUT, "is on none of %zu shafts, expected its key shaft", design->shaft_count);
    return whirl_ok();
}

static double diameter_at_end(const key_value *values, int end, int begin) {
    return values[values[end].given ? end : begin].number;
}

static whirl_status check_bore(const key_value *values) {
    const double outer[2] = {values[SEGMENT_OUTER].number, diameter_at_end(values, SEGMENT_OUTER_END, SEGMENT_OUTER)};
    const double inner[2] = {values[SEGMENT_INNER].number, diameter_at_end(values, SEGMENT_INNER_END, SEGMENT_INNER)};
    for (int end = 0; end < 2; end++) {
        if (!(inner[end] < outer[end]))
            return whirl_fail(WHIRL_BAD_INPUT, "has a bore of %g m in a diameter of %g m, expected a smaller one",
                              inner[end], outer[end]);
        if (values[SEGMENT_FLATS].given && !(values[SEGMENT_FLATS].number > inner[end]))
            return whirl_fail(WHIRL_BAD_INPUT, "has flats %g m apart and a bore of %g m, expected a smaller bore",
                              values[SEGMENT_FLATS].number, inner[end]);
    }
    return whirl_ok();
}

/// Sets the position of a station at the end of a segment.
static whirl_status place_station(meshing *m, const key_value *value, size_t shaft, double z) {
    if (!value->given) return whirl_ok();
    const size_t station = value->station[0];
    if (!isnan(m->position[station]))
        return whirl_fail(WHIRL_BAD_INPUT, "puts station '%s' on a shaft, where it lies already",
                          m->design->stations[station].name);
    m->position[station] = z;
    m->shaft[station] = shaft;
    return whirl_ok();
}

static whirl_status add_span(meshing *m, size_t index) {
    const key_value *values = m->design->elements[index].values;
    span *own = &m->spans[m->span_count];
    *own = (span){.element = index, .values = values};
    // Check the segment, and find its material.
    whirl_status status = shaft_of(m->design, &values[SEGMENT_SHAFT], &own->shaft);
    if (status.code == WHIRL_OK) status = check_bore(values);
    if (status.code == WHIRL_OK && values[SEGMENT_FLATS].given &&
        (m->out->shafts[own->shaft].spool || m->out->shafts[own->shaft].ratio != 1.0))
        status = whirl_fail(WHIRL_BAD_INPUT, "has flats on a shaft of another speed, expected a shaft of ratio 1");
    if (status.code == WHIRL_OK && values[SEGMENT_FLATS].given &&
        m->design->shafts[own->shaft].values[SHAFT_TWIST].choice == 1)
        status =
            whirl_fail(WHIRL_BAD_INPUT, "has flats on a shaft that twists, expected round segments: the torsion of "
                                        "others is not known");
    if (status.code == WHIRL_OK)
        status = find_material(m->design, &values[SEGMENT_MATERIAL],
                               &m->design->shafts[own->shaft].values[SHAFT_MATERIAL], &own->of);
    if (status.code != WHIRL_OK) return status;
    // Begin it where the previous segment ends, or where its key says.
    own->from = 0.0;
    for (size_t i = 0; i < m->span_count; i++)
        if (m->spans[i].shaft == own->shaft) own->from = m->spans[i].to;
    if (values[SEGMENT_START].given) own->from = values[SEGMENT_START].number;
    own->to = own->from + values[SEGMENT_LENGTH].number;
    m->span_count++;
    // Place the stations at the ends of the segment.
    status = place_station(m, &values[SEGMENT_FROM], own->shaft, own->from);
    return status.code == WHIRL_OK ? place_station(m, &values[SEGMENT_TO], own->shaft, own->to) : status;
}

static whirl_status add_spans(meshing *m) {
    for (size_t i = 0; i < m->design->element_count; i++) {
        if (m->design->elements[i].type != &segment_element) continue;
        const whirl_status status = add_span(m, i);
        *m->culprit = i;
        if (status.code != WHIRL_OK) return status;
    }
    *m->culprit = WHIRL_NO_ELEMENT;
    return whirl_ok();
}

/// Reads the keys of all shafts, and finds which of them have segments and which have a speed of their own.
static whirl_status read_shafts(meshing *m) {
    const whirl_design *design = m->design;
    mesh *out = m->out;
    for (size_t i = 0; i < design->element_count; i++) {
        const key_value *shaft = &design->elements[i].values[SEGMENT_SHAFT];
        if (design->elements[i].type == &segment_element)
            out->shafts[shaft->given ? shaft->station[0] : 0].meshed = true;
    }
    for (size_t s = 0; s < design->shaft_count; s++) {
        const key_value *speed = &design->shafts[s].values[SHAFT_SPEED];
        const bool meshed = out->shafts[s].meshed;
        const whirl_status status = shaft_settings_from(design->shafts[s].values, &out->shafts[s]);
        if (status.code != WHIRL_OK)
            return whirl_fail(status.code, "shaft '%s' %.200s", design->shafts[s].name, status.message);
        out->shafts[s].meshed = meshed;
        out->shafts[s].reduced = meshed && out->shafts[s].reduced;
        if (!speed->given) continue;
        if (out->spool_count == WHIRL_MAX_SPOOLS)
            return whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' is one more with a speed of its own, expected at most %d",
                              design->shafts[s].name, WHIRL_MAX_SPOOLS);
        whirl_spool *own = &out->spools[out->spool_count];
        *own = (whirl_spool){.speed = fabs(speed->number), .sense = speed->number < 0.0 ? -1.0 : 1.0};
        if (design->spool_count > 0) own->speed = design->spool_speeds[out->spool_count];
        snprintf(own->name, sizeof own->name, "%s", design->shafts[s].name);
        out->shafts[s].spool = ++out->spool_count;
        out->shafts[s].ratio = own->sense * own->speed / assembly_pace_of(design->speed);
    }
    return whirl_ok();
}

static whirl_status add_positions(meshing *m) {
    for (size_t s = 0; s < m->design->station_count; s++) {
        const design_part *station = &m->design->stations[s];
        const key_value *position = &station->values[STATION_POSITION], *shaft = &station->values[STATION_SHAFT];
        m->position[s] = (double)NAN;
        m->out->lumped[s] = NO_SHAFT;
        // Stations of shafts without segments are lumped.
        if (shaft->given && !m->out->shafts[shaft->station[0]].meshed) {
            if (position->given)
                return whirl_fail(WHIRL_BAD_INPUT,
                                  "station '%s' has a position on shaft '%s', which has no segment, expected segments, "
                                  "or no position",
                                  station->name, m->design->shafts[shaft->station[0]].name);
            m->out->lumped[s] = shaft->station[0];
            continue;
        }
        if (shaft->given && !position->given)
            return whirl_fail(WHIRL_BAD_INPUT, "station '%s' lies on a shaft without its key position", station->name);
        if (!position->given) continue;
        if (m->span_count == 0 && m->design->shaft_count == 0)
            return whirl_fail(WHIRL_BAD_INPUT, "station '%s' has a position and there is no shaft, expected segments",
                              station->name);
        const whirl_status status = shaft_of(m->design, shaft, &m->shaft[s]);
        if (status.code != WHIRL_OK)
            return whirl_fail(status.code, "station '%s' %.200s", station->name, status.message);
        m->position[s] = position->number;
    }
    return whirl_ok();
}

// ---------------------------------------------------------------- nodes

static int compare_numbers(const void *one, const void *other) {
    const double a = *(const double *)one, b = *(const double *)other;
    return a < b ? -1 : a > b;
}

/// Finds the ends of a shaft. Returns false if it has no segment.
static bool ends_of(const meshing *m, size_t shaft, double *from, double *to) {
    *from = INFINITY;
    *to = -INFINITY;
    for (size_t i = 0; i < m->span_count; i++) {
        if (m->spans[i].shaft != shaft) continue;
        *from = fmin(*from, m->spans[i].from);
        *to = fmax(*to, m->spans[i].to);
    }
    return *to > *from;
}

static whirl_status add_break(meshing *m, double z) {
    if (m->break_count == m->capacity) {
        double *longer = realloc(m->breaks, (2 * m->capacity + 64) * sizeof *longer);
        if (!longer) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the nodes of a shaft");
        m->breaks = longer;
        m->capacity = 2 * m->capacity + 64;
    }
    m->breaks[m->break_count++] = z;
    return whirl_ok();
}

/// Returns the largest length of pieces that the segments over a stretch allow. At mesh_to, the wave number of a
/// bending wave times this length is 0.6, where a cubic beam errs by 1e-4 ((k h)^4/1440; Leung 1978).
static double finest_over(const meshing *m, size_t shaft, double from, double to) {
    const double omega = 6.283185307179586476925 * m->out->shafts[shaft].mesh_to;
    double finest = INFINITY;
    for (size_t i = 0; i < m->span_count && omega > 0.0; i++) {
        const span *own = &m->spans[i];
        if (own->shaft != shaft || !(own->from < to && own->to > from)) continue;
        const double outer =
            fmin(own->values[SEGMENT_OUTER].number, diameter_at_end(own->values, SEGMENT_OUTER_END, SEGMENT_OUTER));
        const double inner = own->values[SEGMENT_INNER].number;
        // sqrt(EI/(rho A)) of a ring is its speed of sound times the radius of gyration.
        const double speed = sqrt(own->of.modulus / own->of.density) * sqrt(outer * outer + inner * inner) / 4.0;
        finest = fmin(finest, 0.6 * sqrt(speed / omega));
    }
    return finest;
}

static whirl_status too_many_nodes(void) {
    return whirl_fail(WHIRL_BAD_INPUT,
                      "the mesh and the stations have more than %d nodes, expected fewer elements or a lower mesh_to",
                      WHIRL_MAX_STATIONS);
}

/// Adds breaks that divide a stretch into equal pieces no longer than `finest`.
static whirl_status refine_stretch(meshing *m, double from, double to, double finest) {
    const double pieces = ceil((to - from) / finest - 1e-9);
    whirl_status status = whirl_ok();
    if (!(pieces <= (double)WHIRL_MAX_STATIONS)) return too_many_nodes();
    for (int i = 1; i < (int)pieces && status.code == WHIRL_OK; i++)
        status = add_break(m, from + (to - from) * i / pieces);
    return status;
}

/// Sorts the breaks, and merges those whose distance is rounding.
static void merge_breaks(meshing *m, double length) {
    size_t kept = 0;
    qsort(m->breaks, m->break_count, sizeof *m->breaks, compare_numbers);
    for (size_t i = 0; i < m->break_count; i++)
        if (kept == 0 || m->breaks[i] - m->breaks[kept - 1] > 1e-9 * length) m->breaks[kept++] = m->breaks[i];
    m->break_count = kept;
}

static whirl_status find_breaks(meshing *m, size_t shaft, double from, double to) {
    whirl_status status = whirl_ok();
    m->break_count = 0;
    for (size_t i = 0; i < m->span_count && status.code == WHIRL_OK; i++) {
        const span *own = &m->spans[i];
        const int pieces = (int)own->values[SEGMENT_ELEMENTS].number;
        if (own->shaft != shaft) continue;
        for (int k = 0; k <= pieces && status.code == WHIRL_OK; k++)
            status = add_break(m, k == pieces ? own->to : own->from + (own->to - own->from) * k / pieces);
    }
    for (size_t s = 0; s < m->design->station_count && status.code == WHIRL_OK; s++)
        if (m->shaft[s] == shaft && !isnan(m->position[s])) status = add_break(m, m->position[s]);
    if (status.code != WHIRL_OK) return status;
    merge_breaks(m, to - from);
    const size_t coarse = m->break_count;
    if (coarse > WHIRL_MAX_STATIONS) return too_many_nodes();
    for (size_t i = 0; i + 1 < coarse && status.code == WHIRL_OK; i++)
        status =
            refine_stretch(m, m->breaks[i], m->breaks[i + 1], finest_over(m, shaft, m->breaks[i], m->breaks[i + 1]));
    if (status.code == WHIRL_OK) merge_breaks(m, to - from);
    return status;
}

/// Adds a node at z: the design's station there, or a hidden station.
static whirl_status add_node(meshing *m, size_t shaft, double z, double length) {
    mesh *out = m->out;
    size_t station = m->design->station_count + out->hidden;
    for (size_t s = 0; s < m->design->station_count; s++) {
        if (m->shaft[s] != shaft || !(fabs(m->position[s] - z) <= 1e-9 * length)) continue;
        if (station < m->design->station_count)
            return whirl_fail(WHIRL_BAD_INPUT, "stations '%s' and '%s' lie on the same place of a shaft",
                              m->design->stations[station].name, m->design->stations[s].name);
        station = s;
    }
    out->hidden += station >= m->design->station_count;
    if (m->design->station_count + out->hidden > WHIRL_MAX_STATIONS) return too_many_nodes();
    out->nodes[out->node_count++] = (mesh_node){shaft, z, station};
    return whirl_ok();
}

static shaft_piece piece_between(const span *own, const shaft_settings *shaft, double from, double to) {
    const key_value *values = own->values;
    const double whole = own->to - own->from;
    shaft_piece piece = {.length = to - from,
                         .flats = values[SEGMENT_FLATS].given ? values[SEGMENT_FLATS].number : 0.0,
                         .of = own->of,
                         .shear = shaft->shear,
                         .rotary = shaft->rotary,
                         .axial = {values[SEGMENT_AXIAL_FORCE].number, values[SEGMENT_AXIAL_FORCE].number}};
    for (int end = 0; end < 2; end++) {
        const double at = ((end == 0 ? from : to) - own->from) / whole;
        const double outer = values[SEGMENT_OUTER].number, inner = values[SEGMENT_INNER].number;
        piece.outer[end] = outer + at * (diameter_at_end(values, SEGMENT_OUTER_END, SEGMENT_OUTER) - outer);
        piece.inner[end] = inner + at * (diameter_at_end(values, SEGMENT_INNER_END, SEGMENT_INNER) - inner);
    }
    return piece;
}

/// Adds the pieces between two nodes, one for every segment there. Returns false if there is none.
static bool add_pieces(meshing *m, size_t left) {
    mesh *out = m->out;
    const mesh_node *one = &out->nodes[left], *other = one + 1;
    const double middle = 0.5 * (one->z + other->z);
    const size_t before = out->piece_count;
    for (size_t i = 0; i < m->span_count; i++) {
        const span *own = &m->spans[i];
        if (own->shaft != one->shaft || !(own->from < middle && middle < own->to)) continue;
        const shaft_settings settings = segment_settings_from(own->values, &out->shafts[own->shaft]);
        out->pieces[out->piece_count++] = (mesh_piece){.shaft = own->shaft,
                                                       .node = {left, left + 1},
                                                       .angle = own->values[SEGMENT_FLATS_ANGLE].number,
                                                       .settings = settings,
                                                       .piece = piece_between(own, &settings, one->z, other->z)};
    }
    return out->piece_count > before;
}

static whirl_status check_stations(const meshing *m, size_t shaft, double from, double to) {
    bool any = false;
    const double little = 1e-9 * (to - from);
    for (size_t s = 0; s < m->design->station_count; s++) {
        if (m->shaft[s] != shaft || isnan(m->position[s])) continue;
        any = true;
        if (m->position[s] < from - little || m->position[s] > to + little)
            return whirl_fail(WHIRL_BAD_INPUT, "station '%s' lies at %g m of shaft '%s', expected %g m to %g m",
                              m->design->stations[s].name, m->position[s], m->design->shafts[shaft].name, from, to);
    }
    if (any) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' has no station, expected one with a position on it",
                      m->design->shafts[shaft].name);
}

static whirl_status mesh_shaft(meshing *m, size_t shaft) {
    double from, to;
    mesh *out = m->out;
    bool lumped = false;
    for (size_t s = 0; s < m->design->station_count; s++) lumped = lumped || out->lumped[s] == shaft;
    if (!ends_of(m, shaft, &from, &to))
        return lumped ? whirl_ok()
                      : whirl_fail(WHIRL_BAD_INPUT,
                                   "shaft '%s' has no segment and no station, expected a segment, or stations with "
                                   "shaft: %s",
                                   m->design->shafts[shaft].name, m->design->shafts[shaft].name);
    whirl_status status = check_stations(m, shaft, from, to);
    if (status.code == WHIRL_OK) status = find_breaks(m, shaft, from, to);
    const size_t first = out->node_count;
    for (size_t i = 0; i < m->break_count && status.code == WHIRL_OK; i++)
        status = add_node(m, shaft, m->breaks[i], to - from);
    for (size_t i = first; i + 1 < out->node_count && status.code == WHIRL_OK; i++)
        if (!add_pieces(m, i))
            status = whirl_fail(WHIRL_BAD_INPUT, "shaft '%s' has no segment from %g m to %g m",
                                m->design->shafts[shaft].name, out->nodes[i].z, out->nodes[i + 1].z);
    return status;
}

static whirl_status mesh_prepare(meshing *m, const whirl_design *design, mesh *out) {
    size_t segments = 1;
    for (size_t i = 0; i < design->element_count; i++) segments += design->elements[i].type == &segment_element;
    out->shaft_count = design->shaft_count;
    out->shafts = calloc(design->shaft_count + 1, sizeof *out->shafts);
    out->nodes = calloc(WHIRL_MAX_STATIONS, sizeof *out->nodes);
    out->pieces = calloc(segments * WHIRL_MAX_STATIONS, sizeof *out->pieces);
    m->spans = calloc(segments, sizeof *m->spans);
    m->position = calloc(design->station_count + 1, sizeof *m->position);
    m->shaft = calloc(design->station_count + 1, sizeof *m->shaft);
    out->lumped = calloc(design->station_count + 1, sizeof *out->lumped);
    if (out->lumped && out->shafts && out->nodes && out->pieces && m->spans && m->position && m->shaft)
        return whirl_ok();
    return whirl_fail(WHIRL_NO_MEMORY, "no memory for the mesh of a shaft");
}

whirl_status mesh_make(const whirl_design *design, mesh *out, size_t *culprit) {
    meshing m = {.design = design, .out = out, .culprit = culprit};
    *out = (mesh){0};
    *culprit = WHIRL_NO_ELEMENT;
    whirl_status status = mesh_prepare(&m, design, out);
    if (status.code == WHIRL_OK) status = read_shafts(&m);
    if (status.code == WHIRL_OK) status = add_positions(&m);
    if (status.code == WHIRL_OK) status = add_spans(&m);
    for (size_t s = 0; s < design->shaft_count && status.code == WHIRL_OK; s++) status = mesh_shaft(&m, s);
    free(m.spans);
    free(m.position);
    free(m.shaft);
    free(m.breaks);
    return status;
}

void mesh_clear(mesh *of) {
    free(of->shafts);
    free(of->lumped);
    free(of->nodes);
    free(of->pieces);
}
