// The rotor: coefficients of all elements in one block, and the equations of motion they give.
#include "whirl/rotor.h"

#include <math.h>
#include <stdalign.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "design.h"

typedef struct rotor_element {
    const element_type *type;
    void *coefficients;
} rotor_element;

struct whirl_rotor {
    double speed, length, force;
    whirl_system system;
    size_t station_count;
    size_t force_count;      ///< elements that have a force function
    rotor_element *elements; ///< [force_count], in the registry's order
    station_terms *stations;
    whirl_probe *probes;
    double *mass;
    size_t contact_count;
    char (*contact_text)[WHIRL_NAME_SIZE + 16];
    const char **contact_names;
};

static void rotor_forcing(const void *model, double t, double *forcing) {
    (void)model;
    const double c = cos(t), s = sin(t);
    forcing[COS_TAU] = c;
    forcing[SIN_TAU] = s;
    forcing[COS_2TAU] = (c - s) * (c + s);
    forcing[SIN_2TAU] = 2.0 * c * s;
}

static void rotor_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const whirl_rotor *rotor = model;
    const size_t n = 2 * rotor->station_count;
    const double *v = x + n;
    double *a = dxdt + n;
    (void)t;
    const double c = forcing[COS_TAU], s = forcing[SIN_TAU];
    for (size_t i = 0; i < rotor->station_count; i++) {
        const station_terms *term = &rotor->stations[i];
        dxdt[2 * i] = v[2 * i];
        dxdt[2 * i + 1] = v[2 * i + 1];
        a[2 * i] = term->unbalance_cos * c - term->unbalance_sin * s + term->pull_x - term->damping * v[2 * i];
        a[2 * i + 1] = term->unbalance_cos * s + term->unbalance_sin * c + term->pull_y - term->damping * v[2 * i + 1];
    }
    for (size_t i = 0; i < rotor->force_count; i++)
        rotor->elements[i].type->force(rotor->elements[i].coefficients, forcing, x, v, a);
}

static void rotor_switches(const void *model, double t, const double *x, double *values) {
    const whirl_rotor *rotor = model;
    (void)t;
    for (size_t i = 0; i < rotor->force_count; i++) {
        const rotor_element *element = &rotor->elements[i];
        if (!element->type->switches) continue;
        element->type->switches(element->coefficients, x, x + 2 * rotor->station_count, values);
        values += element->type->switch_count(element->coefficients);
    }
}

static void rotor_contacts(const void *model, const double *x, double *normal_force) {
    const whirl_rotor *rotor = model;
    for (size_t i = 0; i < rotor->force_count; i++) {
        const rotor_element *element = &rotor->elements[i];
        if (element->type->contact_force)
            *normal_force++ = element->type->contact_force(element->coefficients, x) / rotor->force;
    }
}

/// Sizes of the parts of a rotor's block.
typedef struct block_size {
    size_t elements, contacts, coefficients;
} block_size;

static size_t round_up(size_t size) {
    return (size + alignof(max_align_t) - 1) / alignof(max_align_t) * alignof(max_align_t);
}

static block_size measure(const whirl_design *design) {
    block_size size = {0};
    for (size_t i = 0; i < design->element_count; i++) {
        const element_type *type = design->elements[i].type;
        size.elements += type->force != NULL;
        size.contacts += type->contact_force != NULL;
        size.coefficients += round_up(type->size);
    }
    return size;
}

/// Cuts `size` bytes off the block.
static void *take(char **block, size_t size) {
    void *part = *block;
    *block += round_up(size);
    return part;
}

static whirl_rotor *allocate(size_t stations, const block_size *size, char **coefficients) {
    whirl_rotor *rotor;
    const size_t bytes = round_up(sizeof *rotor) + round_up(size->elements * sizeof *rotor->elements) +
                         round_up(stations * sizeof *rotor->stations) + round_up(stations * sizeof *rotor->probes) +
                         round_up(stations * sizeof *rotor->mass) +
                         round_up(size->contacts * sizeof *rotor->contact_text) +
                         round_up(size->contacts * sizeof *rotor->contact_names) + size->coefficients;
    char *block = calloc(1, bytes);
    if (!block) return NULL;
    rotor = take(&block, sizeof *rotor);
    rotor->elements = take(&block, size->elements * sizeof *rotor->elements);
    rotor->stations = take(&block, stations * sizeof *rotor->stations);
    rotor->probes = take(&block, stations * sizeof *rotor->probes);
    rotor->mass = take(&block, stations * sizeof *rotor->mass);
    rotor->contact_text = take(&block, size->contacts * sizeof *rotor->contact_text);
    rotor->contact_names = take(&block, size->contacts * sizeof *rotor->contact_names);
    *coefficients = block;
    return rotor;
}

static void add_stations(const whirl_design *design, whirl_rotor *rotor, const scales *scale) {
    for (size_t i = 0; i < design->station_count; i++) rotor->mass[i] = station_mass(design->stations[i].values);
    for (size_t i = 0; i < design->station_count; i++) {
        const size_t n = 2 * design->station_count;
        whirl_probe *probe = &rotor->probes[i];
        *probe = (whirl_probe){.x = 2 * i, .y = 2 * i + 1, .vx = n + 2 * i, .vy = n + 2 * i + 1};
        strcpy(probe->name, design->stations[i].name);
        station_lump(design->stations[i].values, scale, i, &rotor->stations[i]);
    }
}

static void note_element(whirl_rotor *rotor, const element_type *type, void *coefficients) {
    rotor->elements[rotor->force_count++] = (rotor_element){type, coefficients};
    if (type->switch_count) rotor->system.switch_count += type->switch_count(coefficients);
    if (type->contact_station) {
        const size_t k = rotor->contact_count++;
        snprintf(rotor->contact_text[k], sizeof *rotor->contact_text, "%s at %s", type->group.name,
                 rotor->probes[type->contact_station(coefficients)].name);
        rotor->contact_names[k] = rotor->contact_text[k];
    }
    if (type->bearing_station) {
        double clearance;
        whirl_probe *probe = &rotor->probes[type->bearing_station(coefficients, &clearance)];
        if (probe->clearance == 0.0 || clearance < probe->clearance) probe->clearance = clearance;
    }
}

static bool all_finite(const station_terms *terms, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (!isfinite(terms[i].damping + terms[i].unbalance_cos + terms[i].unbalance_sin + terms[i].pull_x +
                      terms[i].pull_y))
            return false;
    return true;
}

/// Builds the elements of one type, in the order of the design.
static whirl_status add_elements(const whirl_design *design, const element_type *type, const scales *scale,
                                 whirl_rotor *rotor, char **coefficients) {
    for (size_t i = 0; i < design->element_count; i++) {
        if (design->elements[i].type != type) continue;
        void *own = take(coefficients, type->size);
        const whirl_status status = type->build(design->elements[i].values, scale, own);
        if (status.code != WHIRL_OK) return whirl_fail(status.code, "%s %.300s", type->group.name, status.message);
        if (type->lump)
            type->lump(own, rotor->station_count, rotor->stations);
        else
            note_element(rotor, type, own);
    }
    return whirl_ok();
}

static void fill_system(whirl_rotor *rotor) {
    whirl_system *system = &rotor->system;
    system->dimension = 4 * rotor->station_count;
    system->period = 6.283185307179586476925;
    system->forcing_count = FORCING_COUNT;
    system->forcing = rotor_forcing;
    system->rhs = rotor_rhs;
    system->switches = rotor_switches;
    system->contact_count = rotor->contact_count;
    system->contacts = rotor_contacts;
    system->probe_count = rotor->station_count;
    system->probes = rotor->probes;
    system->model = rotor;
}

static whirl_status check_size(const whirl_rotor *rotor) {
    if (rotor->contact_count > WHIRL_MAX_CONTACTS || rotor->system.switch_count > WHIRL_MAX_SWITCHES)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has %zu contacts, expected at most %d", rotor->contact_count,
                          WHIRL_MAX_CONTACTS / 2);
    if (!all_finite(rotor->stations, rotor->station_count))
        return whirl_fail(WHIRL_BAD_INPUT,
                          "the rotor's scaled coefficients are beyond all numbers: look at masses, speed "
                          "and length scale");
    return whirl_ok();
}

whirl_status whirl_rotor_new(const whirl_design *design, whirl_rotor **out) {
    *out = NULL;
    if (design->station_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has no station, expected at least one");
    const block_size size = measure(design);
    char *coefficients;
    whirl_rotor *rotor = allocate(design->station_count, &size, &coefficients);
    if (!rotor) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu stations", design->station_count);
    rotor->speed = design->speed;
    rotor->length = design->length;
    rotor->station_count = design->station_count;
    const scales scale = {design->speed, design->length, rotor->mass, design->station_count};
    add_stations(design, rotor, &scale);
    rotor->force = stiffness_scale(&scale, 0) * scale.length;
    whirl_status status = whirl_ok();
    for (const element_type *const *type = element_types; *type && status.code == WHIRL_OK; type++)
        status = add_elements(design, *type, &scale, rotor, &coefficients);
    fill_system(rotor);
    if (status.code == WHIRL_OK) status = check_size(rotor);
    if (status.code != WHIRL_OK) {
        whirl_rotor_free(rotor);
        return status;
    }
    *out = rotor;
    return whirl_ok();
}

void whirl_rotor_free(whirl_rotor *rotor) {
    free(rotor);
}

const whirl_system *whirl_rotor_system(const whirl_rotor *rotor) {
    return &rotor->system;
}
double whirl_rotor_speed(const whirl_rotor *rotor) {
    return rotor->speed;
}
double whirl_rotor_length_scale(const whirl_rotor *rotor) {
    return rotor->length;
}
double whirl_rotor_force_scale(const whirl_rotor *rotor) {
    return rotor->force;
}
const char *const *whirl_rotor_contact_names(const whirl_rotor *rotor) {
    return rotor->contact_names;
}
