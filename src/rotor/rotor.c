// The rotor: numbers of all stations and elements in one block, and the system that they make.
#include "whirl/rotor.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "design.h"
#include "machine.h"

static void rotor_forcing(const void *model, double t, double *forcing) {
    machine_forcing[0](model, 1, 1, &t, forcing);
}

static void rotor_rhs(const void *model, double t, const double *forcing, const double *x, double *dxdt) {
    const whirl_rotor *rotor = model;
    const size_t degrees = rotor->lanes.degrees;
    (void)t;
    memcpy(dxdt, x + degrees, degrees * sizeof *dxdt);
    machine_accelerate[0](rotor, 1, 1, rotor->numbers, forcing, x, x + degrees, dxdt + degrees);
}

static void rotor_switches(const void *model, double t, const double *x, double *values) {
    const whirl_rotor *rotor = model;
    (void)t;
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        if (!own->type->switches) continue;
        own->type->switches(own, x, x + rotor->lanes.degrees, values);
        values += own->type->switch_count(own);
    }
}

static void rotor_contacts(const void *model, const double *x, double *normal_force) {
    const whirl_rotor *rotor = model;
    for (size_t i = 0; i < rotor->contact_count; i++) {
        const element *own = &rotor->elements[rotor->contacts[i]];
        normal_force[i] = own->type->contact_force(own, x, x + rotor->lanes.degrees);
    }
}

// ---------------------------------------------------------------- many rotors side by side

static void lane_numbers(const void *model, double *out) {
    const whirl_rotor *rotor = model;
    memcpy(out, rotor->numbers, rotor->lanes.number_count * sizeof *out);
}

static bool lane_alike(const void *one, const void *other) {
    const whirl_rotor *a = one, *b = other;
    if (a->station_count != b->station_count || a->element_count != b->element_count) return false;
    for (size_t i = 0; i < a->element_count; i++) {
        const element *x = &a->elements[i], *y = &b->elements[i];
        if (x->type != y->type || x->law != y->law || x->station[0] != y->station[0] || x->station[1] != y->station[1])
            return false;
    }
    return true;
}

static void lane_contact(const void *model, size_t index, size_t *station, double *gap) {
    const whirl_rotor *rotor = model;
    const element *own = &rotor->elements[rotor->contacts[index]];
    *station = own->station[0];
    *gap = own->type->contact_gap(own);
}

// ---------------------------------------------------------------- building

static size_t aligned(size_t size) {
    return (size + 15) / 16 * 16;
}

/// Cuts `size` bytes off the block; with a block of NULL only counts.
static void *cut(char *block, size_t *used, size_t size) {
    void *part = block ? block + *used : NULL;
    *used += aligned(size);
    return part;
}

/// Lays the parts of a rotor out in a block and gives the block's size.
static size_t lay_out(whirl_rotor *rotor, char *block, size_t stations, size_t elements, size_t contacts,
                      size_t numbers) {
    size_t used = aligned(sizeof *rotor);
    void *const parts[] = {cut(block, &used, elements * sizeof *rotor->elements),
                           cut(block, &used, numbers * sizeof *rotor->numbers),
                           cut(block, &used, stations * sizeof *rotor->probes),
                           cut(block, &used, stations * sizeof *rotor->mass),
                           cut(block, &used, contacts * sizeof *rotor->contacts),
                           cut(block, &used, contacts * sizeof *rotor->contact_text),
                           cut(block, &used, contacts * sizeof *rotor->contact_names)};
    if (!rotor) return used;
    rotor->elements = parts[0];
    rotor->numbers = parts[1];
    rotor->probes = parts[2];
    rotor->mass = parts[3];
    rotor->contacts = parts[4];
    rotor->contact_text = parts[5];
    rotor->contact_names = parts[6];
    return used;
}

static whirl_rotor *allocate(const whirl_design *design) {
    size_t elements = 0, contacts = 0, numbers = design->station_count * STATION_NUMBERS;
    for (size_t i = 0; i < design->element_count; i++) {
        const element_type *type = design->elements[i].type;
        elements += type->kernel != KERNEL_NONE;
        contacts += type->contact_force != NULL;
        numbers += type->number_count;
    }
    whirl_rotor *rotor = calloc(1, lay_out(NULL, NULL, design->station_count, elements, contacts, numbers));
    if (!rotor) return NULL;
    lay_out(rotor, (char *)rotor, design->station_count, elements, contacts, numbers);
    rotor->lanes.number_count = numbers;
    return rotor;
}

static double (*station_numbers(whirl_rotor *rotor))[STATION_NUMBERS] {
    return (double(*)[STATION_NUMBERS])rotor->numbers;
}

static void add_stations(const whirl_design *design, whirl_rotor *rotor, const scales *scale) {
    const size_t n = 2 * design->station_count;
    for (size_t i = 0; i < design->station_count; i++) rotor->mass[i] = station_mass(design->stations[i].values);
    for (size_t i = 0; i < design->station_count; i++) {
        whirl_probe *probe = &rotor->probes[i];
        *probe = (whirl_probe){.x = 2 * i, .y = 2 * i + 1, .vx = n + 2 * i, .vy = n + 2 * i + 1};
        strcpy(probe->name, design->stations[i].name);
        station_lump(design->stations[i].values, scale, i, station_numbers(rotor)[i]);
    }
}

static void note_contact(whirl_rotor *rotor, const element *own) {
    const size_t k = rotor->contact_count++;
    if (own->type->contact_damped(own)) rotor->lanes.damped = true;
    const double gap = own->type->contact_gap(own);
    whirl_probe *probe = &rotor->probes[own->station[0]];
    if (probe->gap == 0.0 || gap < probe->gap) probe->gap = gap;
    rotor->contacts[k] = rotor->element_count - 1;
    snprintf(rotor->contact_text[k], sizeof *rotor->contact_text, "%s at %s", own->type->group.name, probe->name);
    rotor->contact_names[k] = rotor->contact_text[k];
}

/// Adds an element that has a kernel; its numbers follow those before it.
static void add_element(whirl_rotor *rotor, const element *own, size_t *number) {
    const element_type *type = own->type;
    rotor->elements[rotor->element_count++] = *own;
    memcpy(rotor->numbers + *number, own->number, type->number_count * sizeof *own->number);
    *number += type->number_count;
    if (type->switch_count) rotor->system.switch_count += type->switch_count(own);
    if (type->slides && type->slides(own)) rotor->lanes.slides = true;
    if (type->contact_force) note_contact(rotor, own);
    if (type->bearing_clearance) {
        whirl_probe *probe = &rotor->probes[own->station[0]];
        const double clearance = type->bearing_clearance(own);
        if (probe->clearance == 0.0 || clearance < probe->clearance) probe->clearance = clearance;
    }
}

/// Builds the elements of one type, in the order of the design.
static whirl_status add_elements(const whirl_design *design, const element_type *type, const scales *scale,
                                 whirl_rotor *rotor, size_t *number) {
    for (size_t i = 0; i < design->element_count; i++) {
        if (design->elements[i].type != type) continue;
        element own = {.type = type};
        const whirl_status status = type->build(design->elements[i].values, scale, &own);
        if (status.code != WHIRL_OK) return whirl_fail(status.code, "%s %.300s", type->group.name, status.message);
        if (type->kernel == KERNEL_NONE)
            type->lump(&own, rotor->station_count, station_numbers(rotor));
        else
            add_element(rotor, &own, number);
    }
    return whirl_ok();
}

static bool is_pair(const whirl_rotor *rotor) {
    const element *e = rotor->elements;
    return rotor->station_count == 2 && rotor->element_count == PAIR_ELEMENTS &&
           e[PAIR_SHAFT].type->kernel == KERNEL_SHAFT && e[PAIR_SHAFT].station[0] == 0 &&
           e[PAIR_SHAFT].station[1] == 1 && e[PAIR_FILM].type->kernel == KERNEL_FILM && e[PAIR_FILM].station[0] == 1 &&
           e[PAIR_RUB].type->kernel == KERNEL_RUB && e[PAIR_RUB].station[0] == 0;
}

static void fill_system(whirl_rotor *rotor) {
    const bool pair = is_pair(rotor);
    if (pair) rotor->pair = (struct lanes_pair){rotor->elements[PAIR_SHAFT], rotor->elements[PAIR_RUB]};
    rotor->lanes = (whirl_lanes){.degrees = 2 * rotor->station_count,
                                 .number_count = rotor->lanes.number_count,
                                 .numbers = lane_numbers,
                                 .alike = lane_alike,
                                 .switch_count = rotor->system.switch_count,
                                 .contact_count = rotor->contact_count,
                                 .contact = lane_contact,
                                 .damped = rotor->lanes.damped,
                                 .slides = rotor->lanes.slides,
                                 .accelerate = machine_accelerate,
                                 .flow = machine_flow,
                                 .switches = machine_switches,
                                 .forcing = machine_forcing,
                                 .contacts = machine_contacts,
                                 .pair = pair ? &rotor->pair : NULL};
    rotor->system = (whirl_system){.dimension = 4 * rotor->station_count,
                                   .period = 6.283185307179586476925,
                                   .forcing_count = FORCING_COUNT,
                                   .forcing = rotor_forcing,
                                   .rhs = rotor_rhs,
                                   .switch_count = rotor->system.switch_count,
                                   .switches = rotor_switches,
                                   .rhs_on_sides = rotor_rhs_on_sides,
                                   .tangent = rotor_tangent,
                                   .divergence = rotor_divergence,
                                   .switch_gradient = rotor_switch_gradient,
                                   .switch_curvature = rotor_switch_curvature,
                                   .contact_count = rotor->contact_count,
                                   .contacts = rotor_contacts,
                                   .probe_count = rotor->station_count,
                                   .probes = rotor->probes,
                                   .model = rotor,
                                   .lanes = &rotor->lanes};
}

static whirl_status check(const whirl_rotor *rotor) {
    if (rotor->contact_count > WHIRL_MAX_CONTACTS || rotor->system.switch_count > WHIRL_MAX_SWITCHES)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has %zu contacts, expected at most %d", rotor->contact_count,
                          WHIRL_MAX_CONTACTS / 2);
    for (size_t i = 0; i < rotor->lanes.number_count; i++)
        if (!isfinite(rotor->numbers[i]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the rotor's scaled coefficients are beyond all numbers: look at masses, "
                              "stiffnesses, speed and length scale");
    return whirl_ok();
}

whirl_status whirl_rotor_new(const whirl_design *design, whirl_rotor **out) {
    *out = NULL;
    if (design->station_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has no station, expected at least one");
    whirl_rotor *rotor = allocate(design);
    if (!rotor) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu stations", design->station_count);
    rotor->speed = design->speed;
    rotor->length = design->length;
    rotor->station_count = design->station_count;
    const scales scale = {design->speed, design->length, rotor->mass};
    add_stations(design, rotor, &scale);
    size_t number = design->station_count * STATION_NUMBERS;
    whirl_status status = whirl_ok();
    for (const element_type *const *type = element_types; *type && status.code == WHIRL_OK; type++)
        status = add_elements(design, *type, &scale, rotor, &number);
    fill_system(rotor);
    if (status.code == WHIRL_OK) status = check(rotor);
    if (status.code == WHIRL_OK)
        *out = rotor;
    else
        whirl_rotor_free(rotor);
    return status;
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
const char *const *whirl_rotor_contact_names(const whirl_rotor *rotor) {
    return rotor->contact_names;
}
