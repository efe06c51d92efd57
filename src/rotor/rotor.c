// The rotor: what stations and elements build together, in one block, and the system that it makes.
#include "whirl/rotor.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "design.h"
#include "instances.h"
#include "machine.h"
#include "reduction.h"
#include "registry.h"
#include "repeats.h"

// ---------------------------------------------------------------- many rotors side by side

static void lane_numbers(const void *model, double *out) {
    const whirl_rotor *rotor = model;
    memcpy(out, rotor->numbers, rotor->lanes.number_count * sizeof *out);
}

static bool elements_alike(const element *x, const element *y) {
    return x->type == y->type && x->law == y->law && x->station == y->station &&
           memcmp(x->port, y->port, sizeof x->port) == 0;
}

static bool terms_alike(const linear_term *x, const linear_term *y) {
    return x->row == y->row && x->source == y->source && x->column == y->column;
}

static bool bodies_alike(const body_panels *x, const body_panels *y) {
    if (x->count != y->count || x->column_count != y->column_count || x->number_count != y->number_count) return false;
    for (size_t i = 0; i < x->count; i++)
        if (x->panels[i].rows != y->panels[i].rows || x->panels[i].columns != y->panels[i].columns ||
            memcmp(x->panels[i].row, y->panels[i].row, sizeof x->panels[i].row) != 0 ||
            body_compare_kinds(x->panels[i].kind, y->panels[i].kind) != 0)
            return false;
    return memcmp(x->columns, y->columns, x->column_count * sizeof *x->columns) == 0 &&
           memcmp(x->numbers, y->numbers, x->number_count * sizeof *x->numbers) == 0;
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
    if (!bodies_alike(&a->body, &b->body)) return false;
    return couplings_alike(&a->coupled, &b->coupled);
}

/// Gives a part its own place for `count` numbers that begin at `own` where they differ from those that it shares; says
/// how many it has then.
static size_t part_from(const double *number, size_t own, size_t count, size_t *place) {
    if (memcmp(number + own, number + *place, count * sizeof *number) != 0) *place = own;
    return *place == own ? count : 0;
}

static size_t lane_part(const void *model, size_t *places) {
    const whirl_rotor *rotor = model;
    const element *own = rotor->elements, *last = own + rotor->element_count;
    size_t count = rotor->term_count + (rotor->body.count > 0 ? RATES : 0);
    for (size_t s = 0; s < rotor->plane_count; s++)
        count += part_from(rotor->numbers, s * STATION_NUMBERS, STATION_NUMBERS, &places[s]);
    for (; own < last; own++)
        count += part_from(rotor->numbers, own->first_number, own->type->number_count, &places[own->part]);
    return count;
}

/// The force on an element's ports and the slopes of its states may depend on all that it sees.
static void depend_on_element(const whirl_rotor *rotor, const element *own, bool *table) {
    const size_t degrees = rotor->lanes.degrees, width = rotor->system.dimension;
    for (size_t i = 0; i < MAX_PORTS + own->type->state_count; i++) {
        const size_t row = i < MAX_PORTS ? own->port[i] : own->state + i - MAX_PORTS;
        for (size_t j = 0; row != NO_COORDINATE && j < MAX_PORTS + own->type->state_count; j++) {
            const size_t by = j < MAX_PORTS ? own->port[j] : own->state + j - MAX_PORTS;
            if (j < MAX_PORTS && by != NO_COORDINATE) table[row * width + by] = true;
            if (by != NO_COORDINATE) table[row * width + degrees + by] = true;
        }
    }
}

static void depend_on_body(const body_panels *in, size_t degrees, size_t width, bool *table) {
    for (const body_panel *panel = in->panels; panel < in->panels + in->count; panel++) {
        const size_t first = panel->kind.source == BODY_PLACE ? 0 : degrees;
        for (size_t c = 0; c < panel->columns && panel->kind.source != BODY_ONE; c++)
            for (size_t r = 0; r < panel->rows; r++)
                if (in->numbers[panel->first_number + c * panel->rows + r] != 0.0)
                    table[panel->row[r] * width + first + in->columns[panel->first_column + c]] = true;
    }
}

static void lane_depends(const void *model, bool *table) {
    const whirl_rotor *rotor = model;
    const coupling *coupled = &rotor->coupled;
    const size_t degrees = rotor->lanes.degrees, width = rotor->system.dimension;
    for (size_t d = 0; d < 2 * rotor->plane_count; d++) table[d * width + degrees + d] = true;
    for (const linear_term *term = rotor->terms; term < rotor->terms + rotor->term_count; term++) {
        if (term->source == SOURCE_PLACE) table[term->row * width + term->column] = true;
        if (term->source == SOURCE_VELOCITY) table[term->row * width + degrees + term->column] = true;
    }
    depend_on_body(&rotor->body, degrees, width, table);
    for (size_t i = 0; i < rotor->element_count; i++) depend_on_element(rotor, &rotor->elements[i], table);
    // What turns with the shaft depends on its phase where that is a state.
    for (size_t i = 0; rotor->phase && i < degrees + rotor->lanes.states; i++)
        table[i * width + degrees + rotor->phase] = true;
    // Where masses couple, each of these accelerations depends on all that the others do.
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

// ---------------------------------------------------------------- building

/// A design on its way to a rotor.
typedef struct building {
    const whirl_design *design;
    mesh mesh;
    assembly assembly;
    element *elements; ///< [element_count] those that have kernels
    double *numbers;   ///< [number_count] theirs
    size_t element_count, number_count, state_count;
    whirl_rotor_tell *tell; ///< NULL: the first problem ends the building
    void *context;
    size_t problems;
    reduction reductions[WHIRL_MAX_SHAFTS];
    body_panels panels;              ///< how many there are
    const design_element *keyphasor; ///< by which sections are taken; NULL: by the shaft
} building;

/// The status with the kind of the element that it is of.
static whirl_status named(const building *b, size_t index, whirl_status status) {
    if (index == WHIRL_NO_ELEMENT) return status;
    return whirl_fail(status.code, "%s %.300s", b->design->elements[index].type->group.name, status.message);
}

/// What goes on with element `index` (WHIRL_NO_ELEMENT: with no single one) after `status`: where problems are told one
/// by one, as if it had been good.
static whirl_status with_element(building *b, size_t index, whirl_status status) {
    if (status.code == WHIRL_OK) return status;
    status = named(b, index, status);
    if (!b->tell || status.code == WHIRL_NO_MEMORY) return status;
    b->tell(b->context, index, &status);
    b->problems++;
    return whirl_ok();
}

static whirl_status begin(building *b, const whirl_design *design) {
    size_t numbers = 1;
    for (size_t i = 0; i < design->element_count; i++) numbers += design->elements[i].type->number_count;
    b->design = design;
    size_t culprit;
    whirl_status status = mesh_make(design, &b->mesh, &culprit);
    if (status.code != WHIRL_OK) {
        // Without its mesh the rest would be told of for nothing.
        if (status.code == WHIRL_NO_MEMORY || culprit == WHIRL_NO_ELEMENT || !b->tell) return named(b, culprit, status);
        with_element(b, culprit, status);
        return whirl_ok();
    }
    status = assembly_begin(&b->assembly, design->speed, design->length, design->station_count + b->mesh.hidden);
    b->elements = calloc(design->element_count + 1, sizeof *b->elements);
    b->numbers = calloc(numbers, sizeof *b->numbers);
    if (!b->elements || !b->numbers)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu elements", design->element_count);
    return status;
}

static void end(building *b) {
    mesh_clear(&b->mesh);
    assembly_clear(&b->assembly);
    free(b->elements);
    free(b->numbers);
}

/// All inertia; after it coordinates can be numbered. And the unit of time: the phase by which sections are taken.
static whirl_status add_inertia(building *b) {
    const whirl_design *design = b->design;
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < design->station_count && status.code == WHIRL_OK; s++) {
        b->assembly.stations[s].name = design->stations[s].name;
        status = with_element(b, WHIRL_NO_ELEMENT, station_inertia(design->stations[s].values, &b->assembly, s));
    }
    for (size_t i = 0; i < design->element_count && status.code == WHIRL_OK; i++) {
        const design_element *own = &design->elements[i];
        if (own->type->inertia) status = with_element(b, i, own->type->inertia(own->values, &b->assembly));
        const double rate = own->type->keyphasor ? own->type->keyphasor(own->values, design->speed) : 0.0;
        if (rate == 0.0 || status.code != WHIRL_OK) continue;
        if (b->assembly.phased)
            status = with_element(b, i, whirl_fail(WHIRL_BAD_INPUT, "is a second keyphasor, expected one"));
        b->keyphasor = own;
        b->assembly.phased = true;
        b->assembly.clock = rate;
        b->assembly.turn = design->speed / rate;
    }
    return status;
}

/// Builds the elements of one type, in the order of the design.
static whirl_status add_elements(building *b, const element_type *type) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < b->design->element_count && status.code == WHIRL_OK; i++) {
        element *own = &b->elements[b->element_count];
        if (b->design->elements[i].type != type) continue;
        *own = (element){.type = type, .number = b->numbers + b->number_count};
        own->state = b->assembly.degrees + b->state_count;
        for (size_t port = 0; port < MAX_PORTS; port++) own->port[port] = NO_COORDINATE;
        status = with_element(b, i, type->build(b->design->elements[i].values, &b->assembly, own));
        if (!type->kernels || own->lumped) continue;
        b->number_count += type->number_count;
        b->state_count += own->type->state_count;
        b->element_count++;
    }
    return status;
}

/// What turns with the rotor cannot sit on a shaft of another speed.
static whirl_status check_ratios(building *b) {
    for (size_t s = 0; s < b->design->station_count; s++) {
        const assembly_station *at = &b->assembly.stations[s];
        if (at->ratio != 1.0 && station_turns(b->design->stations[s].values))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "station '%s' is on a shaft of another speed, where its eccentricity and skew would turn "
                              "with the rotor, expected the element unbalance with a ratio in their place",
                              at->name);
    }
    return whirl_ok();
}

/// Stations, then elements; their coordinates in the order [station_count] of all stations, NULL: as listed.
static whirl_status assemble(building *b, const whirl_design *design, const size_t *order) {
    whirl_status status = begin(b, design);
    if (status.code == WHIRL_OK && b->problems == 0) status = add_inertia(b);
    if (b->problems > 0) return status; // without its inertia the rest would be told of for nothing
    if (status.code == WHIRL_OK) mesh_inertia(&b->mesh, &b->assembly);
    if (status.code == WHIRL_OK) status = check_ratios(b);
    if (status.code == WHIRL_OK) status = assembly_number(&b->assembly, order);
    for (size_t s = 0; s < design->station_count && status.code == WHIRL_OK; s++)
        station_build(design->stations[s].values, &b->assembly, s);
    if (status.code == WHIRL_OK) mesh_build(&b->mesh, &b->assembly);
    for (size_t i = 0; i < design->type_count && status.code == WHIRL_OK; i++)
        status = add_elements(b, design->types[i]);
    if (status.code == WHIRL_OK)
        status = reduction_make(&b->mesh, &b->assembly, b->elements, b->element_count, b->reductions);
    if (b->keyphasor) b->state_count++; // the shaft's phase
    if (status.code == WHIRL_OK && !assembly_finish(&b->assembly))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu elements", design->element_count);
    return status;
}

/// Finds the structure among those that integrators have loops of their own for: the machine is it when its stations'
/// coordinates come in this order.
static bool find_instance(const building *b, size_t order[INSTANCE_STATIONS], lanes_instance *out) {
    if (b->keyphasor || b->mesh.node_count > 0) return false;
#define FIND(name, NAME)                                                                                               \
    if (name##_find(&b->assembly, b->elements, b->element_count, order, out->law)) {                                   \
        out->structure = INSTANCE_##NAME;                                                                              \
        return true;                                                                                                   \
    }
    INSTANCES(FIND)
#undef FIND
    return false;
}

static bool in_order(const building *b, const size_t *order) {
    for (size_t s = 0; s < b->assembly.station_count; s++)
        if (order[s] != s) return false;
    return true;
}

// ---------------------------------------------------------------- the finished rotor

static size_t aligned(size_t size) {
    return (size + 15) / 16 * 16;
}

/// Cuts `size` bytes off the block; with a block of NULL only counts.
static void *cut(char *block, size_t *used, size_t size) {
    void *part = block ? block + *used : NULL;
    *used += aligned(size);
    return part;
}

/// Where the numbers of elements begin: after those of stations and terms.
static size_t first_of_elements(const building *b) {
    return b->assembly.plane_count * STATION_NUMBERS + b->assembly.term_count;
}

static size_t total_numbers(const building *b) {
    return first_of_elements(b) + b->number_count + (b->assembly.body.count > 0 ? RATES : 0) + (b->keyphasor ? 1 : 0);
}

static size_t count_contacts(const building *b) {
    size_t count = 0;
    for (size_t i = 0; i < b->element_count; i++) count += b->elements[i].type->contact_gap != NULL;
    return count;
}

/// Lays the parts of a rotor out in a block and gives the block's size.
static size_t lay_out(whirl_rotor *rotor, char *block, const building *b) {
    const size_t stations = b->design->station_count, contacts = count_contacts(b);
    const size_t coupled = coupling_count(&b->assembly);
    const body_panels *shafts = &b->panels;
    size_t used = aligned(sizeof *rotor);
    void *const parts[] = {cut(block, &used, b->element_count * sizeof *rotor->elements),
                           cut(block, &used, total_numbers(b) * sizeof *rotor->numbers),
                           cut(block, &used, b->assembly.term_count * sizeof *rotor->terms),
                           cut(block, &used, (stations + b->element_count) * sizeof *rotor->places),
                           cut(block, &used, stations * sizeof *rotor->probes),
                           cut(block, &used, (b->assembly.degrees + 1) * sizeof *rotor->groups),
                           cut(block, &used, (2 * b->assembly.degrees + b->state_count) * sizeof *rotor->turns),
                           cut(block, &used, contacts * sizeof *rotor->contacts),
                           cut(block, &used, contacts * sizeof *rotor->contact_text),
                           cut(block, &used, contacts * sizeof *rotor->contact_names),
                           cut(block, &used, coupled * sizeof *rotor->coupled.row),
                           cut(block, &used, (coupled ? b->assembly.degrees : 0) * sizeof *rotor->coupled.place),
                           cut(block, &used, coupled * coupled * sizeof *rotor->coupled.share),
                           cut(block, &used, shafts->count * sizeof *shafts->panels),
                           cut(block, &used, shafts->column_count * sizeof *shafts->columns),
                           cut(block, &used, shafts->number_count * sizeof *shafts->numbers)};
    if (!rotor) return used;
    rotor->elements = parts[0];
    rotor->numbers = parts[1];
    rotor->terms = parts[2];
    rotor->places = parts[3];
    rotor->probes = parts[4];
    rotor->groups = parts[5];
    rotor->turns = parts[6];
    rotor->contacts = parts[7];
    rotor->contact_text = parts[8];
    rotor->contact_names = parts[9];
    rotor->coupled.row = parts[10];
    rotor->coupled.place = parts[11];
    rotor->coupled.share = parts[12];
    rotor->body.panels = parts[13];
    rotor->body.columns = parts[14];
    rotor->body.numbers = parts[15];
    return used;
}

/// A station that moves along one axis has one coordinate, which stands for both.
static void add_probes(whirl_rotor *rotor, const building *b) {
    const size_t degrees = b->assembly.degrees;
    for (size_t s = 0; s < b->design->station_count; s++) {
        const size_t *coordinate = b->assembly.stations[s].coordinate;
        const size_t x = coordinate[coordinate[AXIS_X] == NO_COORDINATE ? AXIS_Y : AXIS_X];
        const size_t y = coordinate[coordinate[AXIS_Y] == NO_COORDINATE ? AXIS_X : AXIS_Y];
        rotor->probes[s] = (whirl_probe){.x = x, .y = y, .vx = degrees + x, .vy = degrees + y};
        strcpy(rotor->probes[s].name, b->assembly.stations[s].name);
    }
}

/// Coordinates whose sizes are measured together: both displacements of a station, both of its tilts.
static void add_groups(whirl_rotor *rotor, const assembly *from) {
    size_t lone = 0;
    for (size_t s = 0; s < from->station_count; s++) lone += from->stations[s].moves_x != from->stations[s].moves_y;
    const size_t first = 2 * from->plane_count;
    for (size_t d = 0; d < from->degrees; d += d >= first && d < first + lone ? 1 : 2)
        rotor->groups[rotor->lanes.group_count++] = d;
    rotor->groups[rotor->lanes.group_count] = from->degrees;
}

static void add_numbers(whirl_rotor *rotor, const building *b) {
    double *number = rotor->numbers;
    memcpy(number, b->assembly.numbers, b->assembly.plane_count * sizeof *b->assembly.numbers);
    number += b->assembly.plane_count * STATION_NUMBERS;
    for (size_t i = 0; i < b->assembly.term_count; i++)
        *number++ = rotor->terms[i].number = b->assembly.terms[i].number;
    memcpy(number, b->numbers, b->number_count * sizeof *number);
    number += b->number_count;
    if (b->assembly.body.count > 0) {
        rotor->first_rate = (size_t)(number - rotor->numbers);
        body_rates(b->assembly.speed, b->assembly.clock, number);
        number += RATES;
    }
    if (b->keyphasor) *number = b->assembly.turn;
}

/// The body's terms, scaled as coordinates are.
static bool add_body(whirl_rotor *rotor, const assembly *from) {
    if (!body_gather(&from->body, &rotor->body)) return false;
    for (const body_panel *panel = rotor->body.panels; panel < rotor->body.panels + rotor->body.count; panel++) {
        double *number = rotor->body.numbers + panel->first_number;
        for (size_t c = 0; c < panel->columns; c++)
            for (size_t r = 0; r < panel->rows; r++, number++) {
                const size_t row = panel->row[r], column = rotor->body.columns[panel->first_column + c];
                *number /= from->inertia[row] * from->unit[row];
                if (panel->kind.source != BODY_ONE) *number *= from->unit[column];
            }
        if (panel->kind.value != BODY_STEADY) rotor->lanes.modulated = true;
    }
    return true;
}

static void note_contact(whirl_rotor *rotor, size_t index) {
    const element *own = &rotor->elements[index];
    const size_t k = rotor->contact_count++;
    const double gap = own->type->contact_gap(own);
    whirl_probe *probe = &rotor->probes[own->station];
    if (own->type->contact_damped(own)) rotor->lanes.damped = rotor->lanes.jumps = true;
    if (probe->gap == 0.0 || gap < probe->gap) probe->gap = gap;
    rotor->contacts[k] = index;
    snprintf(rotor->contact_text[k], sizeof *rotor->contact_text, "%s at %s", own->type->group.name, probe->name);
    rotor->contact_names[k] = rotor->contact_text[k];
}

/// Revolutions after which the phases have come back, one of so many rounds in a revolution (NaN: never) of them, too.
static void note_phase(whirl_rotor *rotor, double rounds) {
    const size_t repeats = repeats_of(rounds);
    rotor->repeats = rotor->turning ? repeats_of_both(rotor->repeats, repeats) : repeats;
    rotor->turning = true;
}

static void note_element(whirl_rotor *rotor, size_t index, size_t degrees) {
    element *own = &rotor->elements[index];
    for (size_t s = 0; s < own->type->turning; s++) rotor->turns[degrees + own->state + s] = 6.283185307179586476925;
    if (own->type->turning > 0) note_phase(rotor, own->type->rounds ? own->type->rounds(own) : (double)NAN);
    if (own->type->kinked) rotor->kinked = true;
    own->first_switch = rotor->lanes.switch_count;
    if (own->type->switch_count) rotor->lanes.switch_count += own->type->switch_count(own);
    if (own->type->modulated) rotor->lanes.modulated = true;
    if (own->type->slides && own->type->slides(own)) rotor->lanes.slides = true;
    if (own->type->jumps && own->type->jumps(own)) rotor->lanes.jumps = true;
    if (own->type->contact_gap) note_contact(rotor, index);
    if (!own->type->bearing_clearance) return;
    whirl_probe *probe = &rotor->probes[own->station];
    const double clearance = own->type->bearing_clearance(own);
    if (clearance > 0.0 && (probe->clearance == 0.0 || clearance < probe->clearance)) probe->clearance = clearance;
}

static void add_elements_to(whirl_rotor *rotor, const building *b) {
    double *own = rotor->numbers + first_of_elements(b);
    memcpy(rotor->elements, b->elements, b->element_count * sizeof *b->elements);
    for (size_t i = 0; i < b->element_count; i++) {
        rotor->elements[i].number = own + (b->elements[i].number - b->numbers);
        rotor->elements[i].first_number = (size_t)(rotor->elements[i].number - rotor->numbers);
        rotor->elements[i].part = rotor->plane_count + i;
        rotor->places[rotor->elements[i].part] = rotor->elements[i].first_number;
        if (i > 0 && rotor->elements[i].type == rotor->elements[i - 1].type)
            rotor->places[rotor->elements[i].part] = rotor->places[rotor->elements[i - 1].part];
        note_element(rotor, i, b->assembly.degrees);
    }
    for (size_t i = b->element_count; i-- > 0;) {
        const bool last = i + 1 == b->element_count || rotor->elements[i + 1].type != rotor->elements[i].type;
        rotor->elements[i].run = last ? 1 : rotor->elements[i + 1].run + 1;
    }
}

static void fill_lanes(whirl_rotor *rotor, const building *b) {
    static lanes_flow *const flow[VECTOR_ISAS] = EVERY_ISA(, machine_flow);
    static lanes_switches *const switches[VECTOR_ISAS] = EVERY_ISA(, machine_switches);
    static lanes_forcing *const forcing[VECTOR_ISAS] = EVERY_ISA(, machine_forcing);
    static lanes_contacts *const contacts[VECTOR_ISAS] = EVERY_ISA(, machine_contacts);
    whirl_lanes *lanes = &rotor->lanes;
    lanes->degrees = b->assembly.degrees;
    lanes->states = b->state_count;
    lanes->number_count = total_numbers(b);
    lanes->numbers = lane_numbers;
    lanes->alike = lane_alike;
    lanes->depends = lane_depends;
    lanes->part_count = rotor->plane_count + rotor->element_count;
    lanes->places = rotor->places;
    lanes->part = lane_part;
    lanes->groups = rotor->groups;
    lanes->contact = lane_contact;
    lanes->flow = flow;
    lanes->switches = switches;
    lanes->forcing = forcing;
    lanes->contacts = contacts;
}

/// The shaft's phase as a state, the last one. Where nothing feels it, it keeps no motion from returning.
static void add_phase(whirl_rotor *rotor, const building *b) {
    enum { MOST = 2 * AXES * WHIRL_MAX_STATIONS + MAX_OWN_STATES };
    const size_t dimension = rotor->system.dimension, last = dimension - 1;
    double x[MOST], change[MOST] = {0}, slope[MOST] = {0};
    bool felt = false;
    rotor->phase = last - rotor->lanes.degrees;
    rotor->turns[last] = 6.283185307179586476925;
    snprintf(rotor->keyphasor, sizeof rotor->keyphasor, "%s at %s", b->keyphasor->type->group.name,
             b->design->stations[b->keyphasor->values[0].station[0]].name);
    for (size_t i = 0; i < dimension; i++) x[i] = 1e-9 / (double)(i + 1); // within any clearance
    change[last] = 1.0;
    rotor->system.tangent(rotor, 0.0, NULL, x, NULL, 1, change, slope);
    for (size_t i = 0; i < dimension; i++) felt = felt || slope[i] != 0.0;
    if (felt || !rotor->turning) note_phase(rotor, felt ? b->assembly.turn : 1.0);
    rotor_system_fill(rotor);
}

static whirl_rotor *finish(building *b) {
    whirl_rotor *rotor = body_gather(&b->assembly.body, &b->panels) ? calloc(1, lay_out(NULL, NULL, b)) : NULL;
    if (!rotor) return NULL;
    lay_out(rotor, (char *)rotor, b);
    rotor->speed = b->design->speed;
    rotor->clock = b->assembly.clock;
    rotor->length = b->design->length;
    rotor->station_count = b->design->station_count;
    rotor->plane_count = b->assembly.plane_count;
    rotor->term_count = b->assembly.term_count;
    rotor->element_count = b->element_count;
    memcpy(rotor->terms, b->assembly.terms ? b->assembly.terms : rotor->terms,
           rotor->term_count * sizeof *rotor->terms);
    add_probes(rotor, b);
    add_groups(rotor, &b->assembly);
    add_numbers(rotor, b);
    if (!add_body(rotor, &b->assembly)) {
        free(rotor);
        return NULL;
    }
    add_elements_to(rotor, b);
    fill_lanes(rotor, b);
    rotor->lanes.contact_count = rotor->contact_count;
    size_t order[INSTANCE_STATIONS];
    if (find_instance(b, order, &rotor->instance)) rotor->lanes.instance = &rotor->instance;
    rotor_system_fill(rotor);
    if (b->keyphasor) add_phase(rotor, b);
    return rotor;
}

static whirl_status check(const whirl_rotor *rotor) {
    // Contacts are at most as many as elements.
    _Static_assert((int)WHIRL_MAX_ELEMENTS <= (int)WHIRL_MAX_CONTACTS, "a contact for every element");
    if (rotor->lanes.switch_count > WHIRL_MAX_SWITCHES)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has %zu switches, expected at most %d", rotor->lanes.switch_count,
                          WHIRL_MAX_SWITCHES);
    if (rotor->lanes.states > MAX_OWN_STATES)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor's elements have %zu states of their own, expected at most %d",
                          rotor->lanes.states, MAX_OWN_STATES);
    for (size_t i = 0; i < rotor->lanes.number_count; i++)
        if (!isfinite(rotor->numbers[i]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the rotor's scaled coefficients are beyond all numbers: look at masses, "
                              "stiffnesses, speed and length scale");
    return whirl_ok();
}

whirl_status whirl_rotor_check(const whirl_design *design, whirl_rotor_tell *tell, void *context, size_t *problems) {
    building b = {.tell = tell, .context = context};
    const whirl_status status = assemble(&b, design, NULL);
    end(&b);
    if (status.code == WHIRL_BAD_INPUT) tell(context, WHIRL_NO_ELEMENT, &status);
    *problems = b.problems + (status.code == WHIRL_BAD_INPUT);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

whirl_status whirl_rotor_new(const whirl_design *design, whirl_rotor **out) {
    size_t order[INSTANCE_STATIONS];
    lanes_instance found;
    building b = {0};
    *out = NULL;
    if (design->station_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has no station, expected at least one");
    whirl_status status = assemble(&b, design, NULL);
    if (status.code == WHIRL_OK && find_instance(&b, order, &found) && !in_order(&b, order)) {
        end(&b);
        b = (building){0};
        status = assemble(&b, design, order);
    }
    whirl_rotor *rotor = status.code == WHIRL_OK ? finish(&b) : NULL;
    if (status.code == WHIRL_OK && !rotor)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu stations", design->station_count);
    if (status.code == WHIRL_OK) status = coupling_fill(&rotor->coupled, &b.assembly);
    end(&b);
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
double whirl_rotor_clock(const whirl_rotor *rotor) {
    return rotor->clock;
}
const char *whirl_rotor_keyphasor(const whirl_rotor *rotor) {
    return rotor->keyphasor;
}
const char *const *whirl_rotor_contact_names(const whirl_rotor *rotor) {
    return rotor->contact_names;
}
