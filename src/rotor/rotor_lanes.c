// The rotor's functions for whirl_lanes (base/lanes.h): its structure and its numbers.
#include <string.h>

#include "machine.h"

static void lane_numbers(const void *model, double *out) {
    const whirl_rotor *rotor = model;
    memcpy(out, rotor->numbers, rotor->lanes.number_count * sizeof *out);
}

static bool elements_alike(const element *x, const element *y) {
    return x->type == y->type && x->law == y->law && x->states == y->states && x->station == y->station &&
           memcmp(x->port, y->port, sizeof x->port) == 0;
}

static bool terms_alike(const linear_term *x, const linear_term *y) {
    return x->row == y->row && x->source == y->source && x->column == y->column;
}

static bool couplings_alike(const coupling *x, const coupling *y) {
    const size_t n = x->count;
    return y->count == n && memcmp(x->row, y->row, n * sizeof *x->row) == 0 &&
           memcmp(x->share, y->share, n * n * sizeof *x->share) == 0;
}

static bool lane_alike(const void *one, const void *other) {
    const whirl_rotor *a = one, *b = other;
    if (a->station_count != b->station_count || a->lanes.degrees != b->lanes.degrees ||
        a->plane_count != b->plane_count || a->element_count != b->element_count || a->term_count != b->term_count ||
        a->phase != b->phase)
        return false;
    for (size_t i = 0; i < a->station_count; i++)
        if (a->probes[i].x != b->probes[i].x || a->probes[i].y != b->probes[i].y) return false;
    for (size_t i = 0; i < a->element_count; i++)
        if (!elements_alike(&a->elements[i], &b->elements[i])) return false;
    for (size_t i = 0; i < a->term_count; i++)
        if (!terms_alike(&a->terms[i], &b->terms[i])) return false;
    if (!body_alike(&a->body, &b->body)) return false;
    return couplings_alike(&a->coupled, &b->coupled);
}

/// Finds where the numbers of a part are. If the `count` numbers from `own` on differ from the shared ones at *place,
/// the part gets its own, and *place becomes `own`. Returns how many numbers the part has itself, 0 if it shares them.
static size_t part_from(const double *number, size_t own, size_t count, size_t *place) {
    if (memcmp(number + own, number + *place, count * sizeof *number) != 0) *place = own;
    return *place == own ? count : 0;
}

static size_t lane_part(const void *model, size_t *places) {
    const whirl_rotor *rotor = model;
    const element *own = rotor->elements, *last = own + rotor->element_count;
    size_t count = rotor->term_count + (rotor->body.count > 0 ? BODY_STEPS : 0);
    for (size_t s = 0; s < rotor->plane_count; s++)
        count += part_from(rotor->numbers, s * STATION_NUMBERS, STATION_NUMBERS, &places[s]);
    for (; own < last; own++)
        count += part_from(rotor->numbers, own->first_number, own->type->number_count, &places[own->part]);
    return count;
}

/// Marks the coordinates on which an element's forces and slopes depend: all of its inputs.
static void depend_on_element(const whirl_rotor *rotor, const element *own, bool *table) {
    const size_t degrees = rotor->lanes.degrees, width = rotor->system.dimension;
    for (size_t i = 0; i < MAX_PORTS + own->states; i++) {
        const size_t row = i < MAX_PORTS ? own->port[i] : own->state + i - MAX_PORTS;
        for (size_t j = 0; row != NO_COORDINATE && j < MAX_PORTS + own->states; j++) {
            const size_t by = j < MAX_PORTS ? own->port[j] : own->state + j - MAX_PORTS;
            if (j < MAX_PORTS && by != NO_COORDINATE) table[row * width + by] = true;
            if (by != NO_COORDINATE) table[row * width + degrees + by] = true;
        }
    }
}

static void depend_on_part(const body_panels *in, const body_panel *panel, const body_part *part, size_t degrees,
                           size_t width, bool *table) {
    const size_t first = part->kind.source == BODY_PLACE ? 0 : degrees;
    for (size_t c = 0; c < part->common + part->lone && part->kind.source != BODY_ONE; c++)
        for (size_t r = 0; r < panel->rows; r++)
            if (in->numbers[part->first_number + c * panel->rows + r] != 0.0)
                table[panel->row[r] * width + first + body_column(in, part, panel->rows, c, r)] = true;
}

static void depend_on_body(const body_panels *in, size_t degrees, size_t width, bool *table) {
    for (size_t p = 0; p < in->count; p++) {
        const body_panel *panel = &in->panels[p];
        for (size_t i = 0; i < panel->part_count; i++)
            depend_on_part(in, panel, &in->parts[panel->first_part + i], degrees, width, table);
    }
}

static void lane_depends(const void *model, bool *table) {
    const whirl_rotor *rotor = model;
    const coupling *coupled = &rotor->coupled;
    const size_t degrees = rotor->lanes.degrees, width = rotor->system.dimension;
    for (size_t d = 0; d < 2 * rotor->plane_count; d++) table[d * width + degrees + d] = true;
    for (size_t i = 0; i < rotor->term_count; i++) {
        const linear_term *term = &rotor->terms[i];
        if (term->source == SOURCE_PLACE) table[term->row * width + term->column] = true;
        if (term->source == SOURCE_VELOCITY) table[term->row * width + degrees + term->column] = true;
    }
    depend_on_body(&rotor->body, degrees, width, table);
    for (size_t i = 0; i < rotor->element_count; i++) depend_on_element(rotor, &rotor->elements[i], table);
    // Rotating forces depend on the shaft's phase if that is a state.
    for (size_t i = 0; rotor->phase && i < degrees + rotor->lanes.states; i++)
        table[i * width + degrees + rotor->phase] = true;
    // Accelerations that are coupled by mass each depend on everything on which any of them depends.
    for (size_t c = 0; c < width; c++) {
        bool any = false;
        for (size_t i = 0; i < coupled->count; i++) any |= table[coupled->row[i] * width + c];
        for (size_t i = 0; i < coupled->count; i++) table[coupled->row[i] * width + c] = any;
    }
}

static void lane_contact(const void *model, size_t index, size_t *probe, double *gap) {
    const whirl_rotor *rotor = model;
    const element *own = &rotor->elements[rotor->contacts[index]];
    *probe = own->station;
    *gap = own->type->contact_gap(own);
}

void rotor_lanes_fill(whirl_rotor *rotor) {
    static lanes_flow *const flow[VECTOR_ISAS] = EVERY_ISA(, machine_flow);
    static lanes_switches *const switches[VECTOR_ISAS] = EVERY_ISA(, machine_switches);
    static lanes_forcing *const forcing[VECTOR_ISAS] = EVERY_ISA(, machine_forcing);
    static lanes_contacts *const contacts[VECTOR_ISAS] = EVERY_ISA(, machine_contacts);
    whirl_lanes *lanes = &rotor->lanes;
    lanes->numbers = lane_numbers;
    lanes->alike = lane_alike;
    lanes->depends = lane_depends;
    lanes->part_count = rotor->plane_count + rotor->element_count;
    lanes->places = rotor->places;
    lanes->part = lane_part;
    lanes->groups = rotor->groups;
    lanes->contact_count = rotor->contact_count;
    lanes->contact = lane_contact;
    lanes->flow = flow;
    lanes->switches = switches;
    lanes->forcing = forcing;
    lanes->contacts = contacts;
}
