#include "building.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "between.h"
#include "bow.h"
#include "mesh.h"
#include "reduction.h"
#include "registry.h"

/// Returns the status with the name of the element that it refers to.
static whirl_status named(const building *b, size_t index, whirl_status status) {
    if (index == WHIRL_NO_ELEMENT) return status;
    return whirl_fail(status.code, "%s %.300s", b->design->elements[index].type->group.name, status.message);
}

/// Reports a problem with element `index` (WHIRL_NO_ELEMENT: with no single one) if problems are reported one by one;
/// building then continues. Otherwise returns it.
static whirl_status with_element(building *b, size_t index, whirl_status status) {
    if (status.code == WHIRL_OK) return status;
    status = named(b, index, status);
    if (!b->tell || status.code == WHIRL_NO_MEMORY) return status;
    b->tell(b->context, index, &status);
    b->problems++;
    return whirl_ok();
}

/// Returns the maximum number of numbers of an element of a type, whether `build` keeps the type or sets its variant.
static size_t most_numbers(const element_type *type) {
    const size_t other = type->variant ? type->variant->number_count : 0;
    return type->number_count > other ? type->number_count : other;
}

static whirl_status building_begin(building *b, const whirl_design *design) {
    size_t numbers = 1;
    for (size_t i = 0; i < design->element_count; i++) numbers += most_numbers(design->elements[i].type);
    b->design = design;
    size_t culprit;
    whirl_status status = mesh_make(design, &b->mesh, &culprit);
    if (status.code != WHIRL_OK) {
        // Without the mesh, further problems would only be consequences of this one.
        if (status.code == WHIRL_NO_MEMORY || culprit == WHIRL_NO_ELEMENT || !b->tell) return named(b, culprit, status);
        with_element(b, culprit, status);
        return whirl_ok();
    }
    status = assembly_begin(&b->assembly, design->speed, design->length, design->station_count + b->mesh.hidden);
    b->assembly.spools_vary = design->spools_vary;
    b->assembly.spool_count = b->mesh.spool_count;
    memcpy(b->assembly.spools, b->mesh.spools, sizeof b->mesh.spools);
    for (size_t s = 0; s < design->shaft_count; s++) b->assembly.spool_of_shaft[s] = b->mesh.shafts[s].spool;
    if (status.code == WHIRL_OK) mesh_turn(&b->mesh, &b->assembly);
    // Stations and discs on shafts of other speeds may have an unbalance each.
    const size_t more = design->station_count + design->element_count;
    numbers += more * unbalance_element.number_count;
    b->elements = calloc(design->element_count + more + 1, sizeof *b->elements);
    b->numbers = calloc(numbers, sizeof *b->numbers);
    if (!b->elements || !b->numbers)
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu elements", design->element_count);
    return status;
}

void building_end(building *b) {
    mesh_clear(&b->mesh);
    assembly_clear(&b->assembly);
    free(b->elements);
    free(b->numbers);
    free(b->between);
}

const key_value *building_value(const design_element *own, const char *key) {
    for (size_t k = 0; k < own->type->group.key_count; k++)
        if (strcmp(own->type->group.keys[k].name, key) == 0) return &own->values[k];
    return NULL;
}

/// Role of an element in the rotor. Bearing elements have a key for it (bearing.c). Without stiffness they are not
/// bearings.
typedef enum role { ROLE_BEARING, ROLE_DRAG, ROLE_OTHER } role;

static role role_of(const design_element *own) {
    enum { BEARING, SEAL, IMPELLER };
    const key_value *said = building_value(own, "role"), *kxx = building_value(own, "kxx"),
                    *kyy = building_value(own, "kyy");
    if (!own->type->carries || (said && (said->choice == SEAL || said->choice == IMPELLER)))
        return own->type->carries || own->type->drags ? ROLE_DRAG : ROLE_OTHER;
    return said && (said->choice != BEARING || !(kxx->given || kyy->given)) ? ROLE_OTHER : ROLE_BEARING;
}

bool building_carries(const design_element *own) {
    return role_of(own) == ROLE_BEARING;
}

bool building_drags(const design_element *own) {
    return role_of(own) == ROLE_DRAG;
}

static bool on_springs(const whirl_design *design) {
    return design->bearings == WHIRL_BEARINGS_SPRINGS || design->bearings == WHIRL_BEARINGS_HELD;
}

/// Returns true if an element is replaced or left out.
static bool is_replaced(const building *b, const design_element *own) {
    const whirl_bearings what = b->design->bearings;
    const bool drags = role_of(own) == ROLE_DRAG;
    if (drags && b->design->drag == WHIRL_DRAG_STAGES && strcmp(own->type->group.name, "stage") != 0) return true;
    if (drags && b->design->drag == WHIRL_DRAG_AT &&
        (building_value(own, "at")->station[0] != b->design->drag_at || strcmp(own->type->group.name, "stage") == 0))
        return true;
    // On soft springs the rotor would sag into stators, which critical speed maps do not describe.
    if (on_springs(b->design) && strcmp(own->type->group.name, "gravity") == 0) return true;
    return on_springs(b->design) ? role_of(own) != ROLE_OTHER
                                 : what == WHIRL_BEARINGS_ALONE && role_of(own) != ROLE_BEARING;
}

/// Adds all inertia, after which coordinates can be numbered. Sets the unit of time from the phase that defines
/// sections.
static whirl_status add_inertia(building *b) {
    const whirl_design *design = b->design;
    whirl_status status = whirl_ok();
    for (size_t s = 0; s < design->station_count && status.code == WHIRL_OK; s++) {
        b->assembly.stations[s].name = design->stations[s].name;
        status = with_element(b, WHIRL_NO_ELEMENT, station_inertia(design->stations[s].values, &b->assembly, s));
    }
    for (size_t i = 0; i < design->element_count && status.code == WHIRL_OK; i++) {
        const design_element *own = &design->elements[i];
        if (is_replaced(b, own)) continue;
        if (own->type->inertia) status = with_element(b, i, own->type->inertia(own->values, &b->assembly));
        const double rate = own->type->keyphasor ? own->type->keyphasor(own->values, b->assembly.speed) : 0.0;
        if (rate == 0.0 || status.code != WHIRL_OK) continue;
        if (b->assembly.phased)
            status = with_element(b, i, whirl_fail(WHIRL_BAD_INPUT, "is a second keyphasor, expected one"));
        b->keyphasor = own;
        b->assembly.phased = true;
        b->assembly.clock = rate;
        b->assembly.turn = copysign(b->assembly.pace, design->speed) / rate;
    }
    return status;
}

/// Rejects forces that turn with the rotor on a shaft of another speed.
static whirl_status check_aside(const building *b) {
    if (!b->assembly.aside) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT,
                      "station '%s' is on a shaft of another speed, and a skew, or an unbalance of a study, turns with "
                      "the rotor, expected none there",
                      b->assembly.aside);
}

/// Rejects terms proportional to the rotor's speed on a shaft of another speed.
static whirl_status check_spin(const building *b, const design_element *own, const element *built) {
    const whirl_group *group = &own->type->group;
    for (size_t k = 0; own->type->spun && !built->round && k < group->key_count; k++) {
        const whirl_key_kind kind = group->keys[k].kind;
        const size_t ends = kind == WHIRL_KEY_STATION ? 1 : kind == WHIRL_KEY_STATIONS ? 2 : 0;
        for (size_t i = 0; i < ends && own->values[k].given; i++) {
            const size_t station = own->values[k].station[i];
            if (station == GROUND || !assembly_is_aside(&b->assembly, station)) continue;
            if (own->type->slides_by_shaft && b->assembly.stations[station].spool) continue;
            if (own->type->follows && k == 0) continue;
            return whirl_fail(WHIRL_BAD_INPUT,
                              "acts at station '%s' on a shaft of another speed, and its force depends on the "
                              "rotor's speed",
                              b->assembly.stations[station].name);
        }
    }
    return whirl_ok();
}

/// Adds the springs that replace a bearing: between journal and housing; in the variant `held`, between each of them
/// and the ground, except for a bearing between two shafts.
static whirl_status add_springs(building *b, const key_value *at, const key_value *from, double stiffness) {
    element place = {.type = NULL};
    const whirl_status status = element_in_housing(at, from, &b->assembly, &place);
    const assembly_station *const other = from->given ? &b->assembly.stations[from->station[0]] : NULL;
    const bool between = other && (other->shaft != NO_SHAFT || other->lumped);
    const bool held = b->design->bearings == WHIRL_BEARINGS_HELD && !between;
    for (size_t i = 0; i < 2 && status.code == WHIRL_OK; i++) {
        assembly_spring(&b->assembly, place.port[i], held ? NO_COORDINATE : place.port[2 + i], stiffness);
        if (held) assembly_spring(&b->assembly, place.port[2 + i], NO_COORDINATE, stiffness);
    }
    return status;
}

/// Adds a spring in place of a bearing, two in series for a floating ring. Other replaced elements are left out.
static whirl_status add_replaced(building *b, const design_element *own) {
    const key_value nowhere = {.given = false}, *at = building_value(own, "at"), *from = building_value(own, "from");
    const key_value *const ring = building_value(own, "ring"), *const house = from ? from : &nowhere;
    const double stiffness = b->design->stiffness;
    if (!on_springs(b->design) || role_of(own) != ROLE_BEARING || !at) return whirl_ok();
    if (!ring) return add_springs(b, at, house, stiffness);
    const whirl_status status = add_springs(b, at, ring, 2.0 * stiffness);
    return status.code == WHIRL_OK ? add_springs(b, ring, house, 2.0 * stiffness) : status;
}

/// Begins the next element. Its numbers and states follow those of earlier ones.
static element *element_begin(building *b, const element_type *type) {
    element *own = &b->elements[b->element_count];
    *own = (element){.type = type, .number = b->numbers + b->number_count};
    own->state = b->assembly.degrees + b->state_count;
    own->states = STATES_OF_TYPE;
    for (size_t port = 0; port < MAX_PORTS; port++) own->port[port] = NO_COORDINATE, own->share[port] = 1.0;
    return own;
}

/// Keeps an element that is built.
static void element_add(building *b, element *own) {
    if (own->states == STATES_OF_TYPE) own->states = own->type->state_count;
    b->number_count += own->type->number_count;
    b->state_count += own->states;
    b->element_count++;
}

/// Builds the elements of one type, in the order of the design.
static whirl_status add_elements(building *b, const element_type *type) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < b->design->element_count && status.code == WHIRL_OK; i++) {
        element *own = &b->elements[b->element_count];
        if (b->design->elements[i].type != type) continue;
        // In some variants of a machine springs replace bearings, and nothing replaces other elements.
        if (is_replaced(b, &b->design->elements[i])) {
            status = with_element(b, i, add_replaced(b, &b->design->elements[i]));
            continue;
        }
        // Let the type build its instance.
        element_begin(b, type);
        status = type->build(b->design->elements[i].values, &b->assembly, own);
        if (status.code == WHIRL_OK) status = check_spin(b, &b->design->elements[i], own);
        status = with_element(b, i, status);
        // Lumped elements have added all their effects to the matrices.
        if (type->kernels && !own->lumped) element_add(b, own);
    }
    return status;
}

/// Adds the eccentricities of stations and discs on shafts of other speeds as unbalances that turn with these.
static whirl_status add_asides(building *b) {
    whirl_status status = whirl_ok();
    for (size_t i = 0; i < b->assembly.aside_count && status.code == WHIRL_OK; i++) {
        element *own = element_begin(b, &unbalance_element);
        status = unbalance_follow(&b->assembly.asides[i], &b->assembly, own);
        if (status.code == WHIRL_OK) element_add(b, own);
    }
    return status;
}

whirl_status building_assemble(building *b, const whirl_design *design, const size_t *order) {
    whirl_status status = building_begin(b, design);
    if (status.code == WHIRL_OK && b->problems == 0) status = add_inertia(b);
    if (b->problems > 0) return status; // without the inertia, further problems would only be consequences
    size_t culprit = WHIRL_NO_ELEMENT;
    if (status.code == WHIRL_OK) status = thrust_build(b, &culprit);
    if (status.code != WHIRL_OK) status = with_element(b, culprit, status);
    if (b->problems > 0) return status;
    if (status.code == WHIRL_OK) mesh_inertia(&b->mesh, &b->assembly);
    if (status.code == WHIRL_OK) status = assembly_number(&b->assembly, order);
    b->assembly.balanced = design->placed_count > 0;
    b->assembly.stages = design->stages;
    b->assembly.in_time = design->in_time;
    b->assembly.frequency = design->asynchronous ? design->frequency : fabs(design->speed);
    for (size_t s = 0; s < design->station_count && status.code == WHIRL_OK; s++)
        station_build(design->stations[s].values, &b->assembly, s);
    if (status.code == WHIRL_OK) mesh_build(&b->mesh, &b->assembly);
    if (status.code == WHIRL_OK) status = bow_build(&b->mesh, design, &b->assembly);
    for (size_t i = 0; i < design->type_count && status.code == WHIRL_OK; i++)
        status = add_elements(b, design->types[i]);
    if (status.code == WHIRL_OK && b->problems == 0) status = add_asides(b);
    if (status.code == WHIRL_OK) assembly_weigh(&b->assembly);
    b->assembly.balanced = false;
    for (size_t i = 0; i < design->placed_count && status.code == WHIRL_OK; i++)
        assembly_unbalance(&b->assembly, design->placed[i].station, design->placed[i].moment, design->placed[i].angle);
    // With bearings alone, drop the coupling of accelerations by mass: the forces of bearings act on the stations' own
    // masses.
    if (design->bearings == WHIRL_BEARINGS_ALONE) b->assembly.mass_count = 0;
    return status.code == WHIRL_OK ? check_aside(b) : status;
}

whirl_status building_finish(building *b) {
    whirl_status status = reduction_make(&b->mesh, &b->assembly, b->elements, b->element_count, b->reductions, NULL);
    if (b->keyphasor) b->state_count++; // the shaft's phase is a state
    if (status.code == WHIRL_OK && !assembly_finish(&b->assembly))
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu elements", b->design->element_count);
    if (status.code != WHIRL_OK) return status;
    return between_stations(&b->mesh, &b->assembly, b->reductions, &b->between, &b->between_count);
}
