// Lays out the drawing of a machine: shafts along one axis or below one another, stations on and off shafts.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure_kinds.h"
#include "machine_layout.h"

/// Density for discs drawn from masses and inertias, kg/m3: steel.
static const double steel = 7850.0;

static const double pi = 3.14159265358979323846;

bool layout_has_station(const machine_layout *l, size_t station) {
    return station < l->model.station_count && station < WHIRL_MAX_PROBES;
}

/// Returns the outer radius of a shaft at a position along it, the larger one at a step; 0 beyond its ends.
static double layout_shaft_radius(const machine_layout *l, size_t shaft, double at) {
    double radius = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++) {
        const whirl_model_section *s = &l->model.sections[i];
        const double slack = 1e-9 * (s->to - s->from);
        if (s->shaft != shaft || at < s->from - slack || at > s->to + slack) continue;
        const double share = (at - s->from) / (s->to - s->from);
        radius = fmax(radius, 0.5 * (s->outer[0] + share * (s->outer[1] - s->outer[0])));
    }
    return radius;
}

span layout_shaft_ends(const machine_layout *l, size_t shaft) {
    span ends = span_empty();
    for (size_t i = 0; i < l->model.section_count; i++) {
        if (l->model.sections[i].shaft != shaft) continue;
        span_widen(&ends, l->offset[shaft] + l->model.sections[i].from);
        span_widen(&ends, l->offset[shaft] + l->model.sections[i].to);
    }
    return ends;
}

double layout_largest_radius(const machine_layout *l, size_t shaft) {
    double radius = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++)
        if (l->model.sections[i].shaft == shaft)
            radius = fmax(radius, 0.5 * fmax(l->model.sections[i].outer[0], l->model.sections[i].outer[1]));
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++)
        if (l->model.stations[s].shaft == shaft) radius = fmax(radius, layout_rim_radius(l, s));
    return radius;
}

/// Puts a shaft on the axis of a placed shaft, if an element joins stations of both: these two stations get the same
/// place. Returns false if there is no such element.
static bool layout_align_shaft(machine_layout *l, size_t shaft) {
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        for (int end = 0; end < 2; end++) {
            if (!layout_has_station(l, e->station[0]) || !layout_has_station(l, e->station[1])) continue;
            const whirl_model_mass *own = &l->model.stations[e->station[end]];
            const whirl_model_mass *other = &l->model.stations[e->station[1 - end]];
            if (own->shaft != shaft || other->shaft >= l->model.shaft_count || !l->placed_shaft[other->shaft]) continue;
            l->offset[shaft] = l->offset[other->shaft] + other->position - own->position;
            l->axis[shaft] = l->axis[other->shaft];
            return l->placed_shaft[shaft] = true;
        }
    }
    return false;
}

size_t layout_longest_name(const whirl_result *result) {
    size_t longest = 0;
    for (size_t s = 0; s < result->station_count; s++)
        longest = strlen(result->stations[s].name) > longest ? strlen(result->stations[s].name) : longest;
    return longest;
}

/// Returns the width in m for the names of stations next to a vertical shaft, if the longest shaft is 14 cm long in the
/// figure.
static double layout_names(const machine_layout *l) {
    double length = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++) length = fmax(length, l->model.sections[i].to);
    return (0.12 * (double)layout_longest_name(l->result) + 0.25) * length / 14.0;
}

/// Places the shafts: those that an element joins on one axis, others below one another.
static void layout_place_shafts(machine_layout *l) {
    double axis = 0.0;
    size_t left = l->model.shaft_count;
    while (left > 0) {
        bool any = false;
        for (size_t s = 0; s < l->model.shaft_count; s++)
            if (!l->placed_shaft[s] && layout_align_shaft(l, s)) left--, any = true;
        if (any || left == 0) continue;
        size_t next = 0;
        while (l->placed_shaft[next]) next++;
        if (next > 0)
            axis -=
                layout_largest_radius(l, next - 1) + layout_largest_radius(l, next) + 6.5 * l->symbol + layout_names(l);
        l->axis[next] = axis;
        l->placed_shaft[next] = true;
        left--;
    }
}

/// Returns the radius of a steel disc with a polar inertia; its width is half its radius.
static double layout_torsional_radius(double polar) {
    return pow(4.0 * polar / (steel * pi), 0.2);
}

double layout_mass(const whirl_model_mass *of) {
    const double r = of->mass > 0.0 ? 0.0 : layout_torsional_radius(of->polar);
    return of->mass > 0.0 ? of->mass : 0.5 * steel * pi * r * r * r;
}

/// Returns the radius of a steel disc with a station's mass and polar inertia; without inertia half the side of a cube.
double layout_disc_radius(const whirl_model_mass *of) {
    if (!(of->mass > 0.0)) return layout_torsional_radius(of->polar);
    return of->polar > 0.0 ? sqrt(2.0 * of->polar / of->mass) : 0.5 * cbrt(of->mass / steel);
}

double layout_disc_width(const whirl_model_mass *of) {
    const double r = layout_disc_radius(of);
    return of->polar > 0.0 ? layout_mass(of) / (steel * pi * r * r) : 2.0 * r;
}

layout_disc layout_disc_of(const machine_layout *l, size_t station) {
    const whirl_model_mass *own = &l->model.stations[station];
    return (layout_disc){.half = fmax(0.5 * layout_disc_width(own), 0.12 * l->symbol),
                         .radius = fmax(layout_disc_radius(own), l->radius[station] + 0.3 * l->symbol)};
}

/// Returns the radius of a station's disc, or of its shaft if that is larger.
double layout_rim_radius(const machine_layout *l, size_t station) {
    const whirl_model_mass *own = &l->model.stations[station];
    return own->shaft < l->model.shaft_count ? fmax(layout_disc_radius(own), l->radius[station]) : l->radius[station];
}

/// Places a station without a shaft below the station to which an element joins it.
static bool layout_hang_station(machine_layout *l, size_t station) {
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        for (int end = 0; end < 2; end++) {
            const size_t other = e->station[1 - end];
            if (e->station[end] != station || !layout_has_station(l, other) || !l->placed[other]) continue;
            l->x[station] = l->x[other];
            l->y[station] = l->y[other] - l->radius[other] - 3.2 * l->symbol;
            return l->placed[station] = true;
        }
    }
    return false;
}

/// Returns true if a station is a housing or support: the second end of a bearing, stator or support.
static bool layout_is_housing(const machine_layout *l, size_t station) {
    for (size_t i = 0; i < l->model.element_count; i++) {
        const whirl_model_element *e = &l->model.elements[i];
        if (e->station[1] == station && e->station[0] != WHIRL_MODEL_NONE && e->role != WHIRL_ROLE_LINK) return true;
    }
    return false;
}

static void layout_place_stations(machine_layout *l) {
    const size_t count = l->model.station_count < WHIRL_MAX_PROBES ? l->model.station_count : WHIRL_MAX_PROBES;
    double next = l->to_scale ? l->along.high + 4.0 * l->symbol : 0.0;
    // Place the stations on shafts.
    for (size_t s = 0; s < count; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        if (own->shaft >= l->model.shaft_count) continue;
        l->x[s] = l->offset[own->shaft] + own->position;
        l->y[s] = l->axis[own->shaft];
        l->placed[s] = true;
    }
    // Without shafts to scale, place all stations but housings side by side.
    for (size_t s = 0; s < count && !l->to_scale; s++) {
        if (layout_is_housing(l, s)) continue;
        l->x[s] = next;
        next += 1.0;
        l->placed[s] = true;
    }
    // Place stations without a shaft below the placed ones to which elements join them, until no more can be placed.
    for (bool any = true; any;) {
        any = false;
        for (size_t s = 0; s < count; s++)
            if (!l->placed[s] && layout_hang_station(l, s)) any = true;
    }
    // Place all other stations next to the shafts.
    for (size_t s = 0; s < count; s++) {
        if (l->placed[s]) continue;
        l->x[s] = next;
        next += l->to_scale ? 4.0 * l->symbol : 1.0;
        l->placed[s] = true;
    }
}

/// Sets the sizes of symbols and stations. Without shafts to scale, the size of a station is proportional to the cube
/// root of its mass.
static void layout_size_stations(machine_layout *l) {
    double length = 0.0, thick = 0.0, heaviest = 0.0;
    for (size_t i = 0; i < l->model.section_count; i++) {
        length = fmax(length, l->model.sections[i].to);
        thick = fmax(thick, fmax(l->model.sections[i].outer[0], l->model.sections[i].outer[1]));
    }
    for (size_t s = 0; s < l->model.station_count; s++) heaviest = fmax(heaviest, layout_mass(&l->model.stations[s]));
    l->symbol = l->to_scale ? fmax(0.018 * length, 0.12 * thick) : 0.1;
    for (size_t s = 0; s < l->model.station_count && s < WHIRL_MAX_PROBES; s++) {
        const whirl_model_mass *own = &l->model.stations[s];
        const double shaft =
            own->shaft < l->model.shaft_count ? layout_shaft_radius(l, own->shaft, own->position) : 0.0;
        l->radius[s] = !l->to_scale  ? 0.06 + (heaviest > 0.0 ? 0.16 * cbrt(layout_mass(own) / heaviest) : 0.0)
                       : shaft > 0.0 ? shaft
                                     : l->symbol;
    }
}

static void layout_measure(machine_layout *l) {
    l->along = span_empty();
    for (size_t s = 0; s < l->model.shaft_count; s++) {
        const span ends = layout_shaft_ends(l, s);
        span_widen(&l->along, ends.low);
        span_widen(&l->along, ends.high);
    }
}

double layout_unit(const whirl_shown_units *units) {
    const bool inches = strcmp(units->length_name, "mil") == 0 || strcmp(units->length_name, "in") == 0;
    return inches ? 0.0254 : 1e-3;
}

const char *layout_label(const whirl_shown_units *units) {
    return layout_unit(units) == 0.0254 ? "$z$ (in)" : "$z$ (mm)";
}

machine_layout *layout_new(const drawing *of) {
    machine_layout *l = of->machine ? calloc(1, sizeof *l) : NULL;
    if (!l) return NULL;
    l->result = of->result;
    if (whirl_case_model(of->machine, &l->model).code != WHIRL_OK) {
        free(l);
        return NULL;
    }
    l->to_scale = l->model.section_count > 0;
    layout_size_stations(l);
    layout_place_shafts(l);
    layout_measure(l);
    layout_place_stations(l);
    return l;
}

void layout_free(machine_layout *layout) {
    if (layout) whirl_model_free(&layout->model);
    free(layout);
}
