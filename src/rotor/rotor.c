// The rotor: puts its parts into one block, and fills in its system.
#include "whirl/engine/rotor.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "building.h"
#include "machine.h"
#include "pair.h"

/// Returns true if the machine is a pair that turns with the shaft's phase, counter-clockwise.
static bool is_pair(const building *b, size_t order[PAIR_STATIONS], int laws[PAIR_LAWS]) {
    return !b->keyphasor && b->mesh.node_count == 0 && b->assembly.turn == 1.0 &&
           pair_find(&b->assembly, b->elements, b->element_count, order, laws);
}

static bool in_order(const building *b, const size_t *order) {
    for (size_t s = 0; s < b->assembly.station_count; s++)
        if (order[s] != s) return false;
    return true;
}

static size_t aligned(size_t size) {
    return (size + 15) / 16 * 16;
}

/// Cuts `size` bytes off the block. With a block of NULL it only counts.
static void *cut(char *block, size_t *used, size_t size) {
    void *part = block ? block + *used : NULL;
    *used += aligned(size);
    return part;
}

/// Returns the index of the first element's numbers, which follow those of stations and terms.
static size_t first_of_elements(const building *b) {
    return b->assembly.plane_count * STATION_NUMBERS + b->assembly.term_count;
}

static size_t total_numbers(const building *b) {
    return first_of_elements(b) + b->number_count + (b->assembly.body.count > 0 ? BODY_STEPS : 0) +
           (b->keyphasor ? 1 : 0);
}

static size_t count_contacts(const building *b) {
    size_t count = 0;
    for (size_t i = 0; i < b->element_count; i++) count += b->elements[i].type->contact_gap != NULL;
    return count;
}

/// Lays out the parts of a rotor in a block. Returns the size of the block.
static size_t rotor_lay_out(whirl_rotor *rotor, char *block, const building *b) {
    // Cut the parts one after the other. Without a block only their sizes count.
    const size_t stations = b->design->station_count, contacts = count_contacts(b);
    const size_t coupled = coupling_count(&b->assembly);
    const body_panels *shafts = &b->panels;
    size_t used = aligned(sizeof *rotor);
    void *const parts[] = {
        cut(block, &used, b->element_count * sizeof *rotor->elements),
        cut(block, &used, total_numbers(b) * sizeof *rotor->numbers),
        cut(block, &used, b->assembly.term_count * sizeof *rotor->terms),
        cut(block, &used, (stations + b->element_count) * sizeof *rotor->places),
        cut(block, &used, 3 * stations * sizeof *rotor->probes),
        cut(block, &used, (b->assembly.degrees + 1) * sizeof *rotor->groups),
        cut(block, &used, (2 * b->assembly.degrees + b->state_count) * sizeof *rotor->turns),
        cut(block, &used, contacts * sizeof *rotor->contacts),
        cut(block, &used, contacts * sizeof *rotor->contact_text),
        cut(block, &used, contacts * sizeof *rotor->contact_names),
        cut(block, &used, coupled * sizeof *rotor->coupled.row),
        cut(block, &used, (coupled ? b->assembly.degrees : 0) * sizeof *rotor->coupled.place),
        cut(block, &used,
            (coupled * coupled + (coupled + 1) * (coupled + COUPLING_MARGIN)) * sizeof *rotor->coupled.share),
        cut(block, &used, coupled * sizeof *rotor->coupled.end),
        cut(block, &used, shafts->count * sizeof *shafts->panels),
        cut(block, &used, shafts->part_count * sizeof *shafts->parts),
        cut(block, &used, shafts->column_count * sizeof *shafts->columns),
        cut(block, &used, (shafts->number_count + PANEL_ROWS) * sizeof *shafts->numbers),
        cut(block, &used, b->between_count * sizeof *rotor->between),
        cut(block, &used, b->assembly.frequency_count * sizeof *rotor->frequencies),
        cut(block, &used, b->assembly.runout_count * sizeof *rotor->runouts),
        cut(block, &used, b->assembly.degrees * sizeof *rotor->inertia),
        cut(block, &used, b->assembly.degrees * sizeof *rotor->unit),
        cut(block, &used, b->assembly.turning_count * sizeof *rotor->turnings),
        cut(block, &used, stations * sizeof *rotor->twists),
        cut(block, &used, b->assembly.torque_count * sizeof *rotor->torques),
        cut(block, &used, b->assembly.link_count * sizeof *rotor->links),
        cut(block, &used, b->assembly.degrees * sizeof *rotor->rigid),
        cut(block, &used, b->assembly.degrees * sizeof *rotor->momentum),
        cut(block, &used, 2 * b->assembly.degrees * sizeof *rotor->weight),
        cut(block, &used, b->assembly.hold_count * sizeof *rotor->holds),
        cut(block, &used, b->assembly.harmonic_count * sizeof *rotor->harmonics),
        cut(block, &used, stations * sizeof *rotor->pairs),
        cut(block, &used, stations * sizeof *rotor->polar),
        cut(block, &used, (b->assembly.harmonic_count + b->element_count) * sizeof *rotor->excitations),
        cut(block, &used, b->assembly.fatigue_count * sizeof *rotor->fatigues),
        cut(block, &used, stations * sizeof *rotor->axials),
        cut(block, &used, stations * sizeof *rotor->spool_of),
        cut(block, &used, stations * sizeof *rotor->housing_turns),
        cut(block, &used, 2 * stations * sizeof *rotor->extras),
        cut(block, &used, stations * sizeof *rotor->shaft_of),
        cut(block, &used, b->assembly.station_count * sizeof *rotor->parts),
        cut(block, &used, stations * sizeof *rotor->radians)};
    // Point to the parts, in the same order.
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
    rotor->coupled.columns = rotor->coupled.share + coupled * coupled;
    rotor->coupled.apart = coupled + COUPLING_MARGIN;
    rotor->coupled.end = parts[13];
    rotor->body.panels = parts[14];
    rotor->body.parts = parts[15];
    rotor->body.columns = parts[16];
    rotor->body.numbers = parts[17];
    rotor->between = parts[18];
    rotor->frequencies = parts[19];
    rotor->runouts = parts[20];
    rotor->inertia = parts[21];
    rotor->unit = parts[22];
    rotor->turnings = parts[23];
    rotor->twists = parts[24];
    rotor->torques = parts[25];
    rotor->links = parts[26];
    rotor->rigid = parts[27];
    rotor->momentum = parts[28];
    rotor->weight = parts[29];
    rotor->holds = parts[30];
    rotor->harmonics = parts[31];
    rotor->pairs = parts[32];
    rotor->polar = parts[33];
    rotor->excitations = parts[34];
    rotor->fatigues = parts[35];
    rotor->axials = parts[36];
    rotor->spool_of = parts[37];
    rotor->housing_turns = parts[38];
    rotor->extras = parts[39];
    rotor->shaft_of = parts[40];
    rotor->parts = parts[41];
    rotor->radians = parts[42];
    return used;
}

/// Fills in the probes. A station that moves along one axis, or only twists, has one coordinate, which is used for both
/// axes.
static void add_probes(whirl_rotor *rotor, const building *b) {
    const size_t degrees = b->assembly.degrees;
    // Set the coordinates of the stations.
    for (size_t s = 0; s < b->design->station_count; s++) {
        const size_t *coordinate = b->assembly.stations[s].coordinate;
        const bool along_x = coordinate[AXIS_X] != NO_COORDINATE, along_y = coordinate[AXIS_Y] != NO_COORDINATE;
        const size_t x = coordinate[along_x ? AXIS_X : along_y ? AXIS_Y : AXIS_TWIST];
        const size_t y = coordinate[along_y ? AXIS_Y : along_x ? AXIS_X : AXIS_TWIST];
        rotor->probes[s] = (whirl_probe){.x = x,
                                         .y = y,
                                         .vx = degrees + x,
                                         .vy = degrees + y,
                                         .along_y = along_y && !along_x,
                                         .twists = !along_x && !along_y,
                                         .clockwise = b->assembly.turn < 0.0};
        strcpy(rotor->probes[s].name, b->assembly.stations[s].name);
        // The twist of a station behind a rigid gear is a multiple of its coordinate.
        const double share = rotor->probes[s].twists ? assembly_share(&b->assembly, s, AXIS_TWIST) : 1.0;
        for (size_t nth = 0; nth < 4 && share != 1.0; nth++) rotor->radians[s][nth] = share;
        if (share != 1.0) rotor->probes[s].units = rotor->radians[s];
    }
    // Set the positions on shafts of finite elements.
    for (size_t i = 0; i < b->mesh.node_count; i++) {
        const mesh_node *node = &b->mesh.nodes[i];
        if (node->station >= b->design->station_count) continue;
        rotor->probes[node->station].shaft = node->shaft + 1;
        rotor->probes[node->station].position = node->z;
    }
}

/// Adds the probe of a motion of station s besides x and y, after those of all stations.
static whirl_probe *add_extra_probe(whirl_rotor *rotor, size_t s, size_t coordinate, size_t degrees, bool twists) {
    whirl_probe *probe = &rotor->probes[rotor->station_count + rotor->extra_count];
    *probe = (whirl_probe){.x = coordinate, .y = coordinate, .vx = degrees + coordinate, .vy = degrees + coordinate};
    strcpy(probe->name, rotor->probes[s].name);
    rotor->extras[rotor->extra_count++] = (whirl_extra){s, twists};
    return probe;
}

/// Adds the probes of axial displacements, and of the twists of stations that also move otherwise.
static void add_extra_probes(whirl_rotor *rotor, const building *b) {
    const size_t degrees = b->assembly.degrees;
    for (size_t s = 0; s < rotor->station_count; s++) {
        const size_t own = b->assembly.stations[s].coordinate[AXIS_AXIAL];
        if (own != NO_COORDINATE) add_extra_probe(rotor, s, own, degrees, false);
    }
    for (size_t s = 0; s < rotor->station_count; s++) {
        const size_t own = b->assembly.stations[s].coordinate[AXIS_TWIST];
        if (own == NO_COORDINATE || rotor->probes[s].twists) continue;
        for (size_t nth = 0; nth < 4; nth++)
            rotor->radians[s][nth] = assembly_share(&b->assembly, s, AXIS_TWIST) * rotor->unit[own];
        add_extra_probe(rotor, s, own, degrees, true)->units = rotor->radians[s];
    }
}

/// Fills in the coordinates of twists and axial displacements.
static void add_twists_and_axials(whirl_rotor *rotor, const assembly *from) {
    rotor->twist_count = from->twist_count;
    rotor->first_twist = from->first_twist;
    rotor->axial_count = from->axial_count;
    rotor->first_axial = from->first_axial;
    for (size_t s = 0; s < rotor->station_count; s++) {
        const size_t *coordinate = from->stations[s].coordinate;
        rotor->twists[s] = (station_twist){coordinate[AXIS_TWIST], assembly_share(from, s, AXIS_TWIST)};
        rotor->axials[s] = coordinate[AXIS_AXIAL];
    }
}

/// Adds the runouts in length scales. Those of a station are adjacent.
static void add_runouts(whirl_rotor *rotor, const assembly *from) {
    whirl_runout *next = rotor->runouts;
    for (size_t s = 0; s < rotor->station_count; s++) {
        rotor->probes[s].runout = next;
        for (size_t i = 0; i < from->runout_count; i++) {
            if (from->runouts[i].station != s) continue;
            *next = from->runouts[i].seen;
            for (size_t part = 0; part < 2; part++) {
                next->first[part] /= from->length;
                next->second[part] /= from->length;
            }
            next++;
        }
        rotor->probes[s].runout_count = (size_t)(next - rotor->probes[s].runout);
    }
}

/// Groups coordinates whose sizes are measured together: the two displacements of a station, its two tilts, each twist,
/// and each axial displacement.
static void add_groups(whirl_rotor *rotor, const assembly *from) {
    size_t lone = from->twist_count + from->axial_count;
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
        body_rates(assembly_spin(&b->assembly), b->assembly.clock, number);
        number += BODY_STEPS;
    }
    if (b->keyphasor) *number = b->assembly.turn;
}

/// Scales the body's terms as coordinates are scaled.
static void scale_body(assembly *of) {
    for (size_t i = 0; i < of->body.count; i++) {
        body_term *term = &of->body.terms[i];
        term->number /= of->inertia[term->row] * of->unit[term->row];
        if (term->kind.source != BODY_ONE) term->number *= of->unit[term->column];
    }
}

static bool add_body(whirl_rotor *rotor, const assembly *from) {
    if (!body_gather(&from->body, &rotor->body)) return false;
    for (size_t i = 0; i < rotor->body.count; i++)
        if (rotor->body.panels[i].value != BODY_STEADY) rotor->lanes.modulated = true;
    rotor->begun = body_begin(&rotor->body, 2 * from->plane_count, from->degrees);
    return true;
}

/// Names a contact "rub at disc"; further contacts of that name are "rub at disc (2)", ...
static void name_contact(whirl_rotor *rotor, size_t k) {
    const element *own = &rotor->elements[rotor->contacts[k]];
    char again[16] = "";
    unsigned number = 1;
    for (size_t i = 0; i < k; i++) {
        const element *other = &rotor->elements[rotor->contacts[i]];
        number += other->type == own->type && other->station == own->station;
    }
    if (number > 1) snprintf(again, sizeof again, " (%u)", number);
    snprintf(rotor->contact_text[k], sizeof *rotor->contact_text, "%s at %s%s", own->type->group.name,
             rotor->probes[own->station].name, again);
    rotor->contact_names[k] = rotor->contact_text[k];
}

static void note_contact(whirl_rotor *rotor, size_t index) {
    const element *own = &rotor->elements[index];
    const size_t k = rotor->contact_count++;
    const double gap = own->type->contact_gap(own);
    whirl_probe *probe = &rotor->probes[own->station];
    if (own->type->contact_damped(own)) rotor->lanes.damped = true;
    if (own->type->rubs(own) > 0) rotor->lanes.rubs = true;
    if (own->type->rubs(own) < 0) rotor->mute = true;
    if (own->type->contact_damped(own) && !own->type->jumps) rotor->lanes.jumps = true;
    if (gap > 0.0 && (probe->gap == 0.0 || gap < probe->gap)) probe->gap = gap;
    rotor->contacts[k] = index;
    name_contact(rotor, k);
}

/// Updates the number of revolutions after which all phases repeat for one more phase, whose effects have `rounds`
/// periods per revolution (NaN: they never repeat).
static void note_phase(whirl_rotor *rotor, double rounds) {
    const size_t repeats = repeats_of(rounds);
    rotor->repeats = rotor->turning ? repeats_of_both(rotor->repeats, repeats) : repeats;
    rotor->turning = true;
}

static void note_element(whirl_rotor *rotor, size_t index, size_t degrees) {
    element *own = &rotor->elements[index];
    for (size_t s = 0; s < own->type->turning; s++) {
        rotor->turns[degrees + own->state + s] = 6.283185307179586476925;
        note_phase(rotor, own->type->rounds ? own->type->rounds(own, s) : (double)NAN);
    }
    if (own->type->kinked) rotor->kinked = true;
    own->first_switch = rotor->lanes.switch_count;
    if (own->type->switch_count) rotor->lanes.switch_count += own->type->switch_count(own);
    if (own->type->switch_count && own->states > 0) rotor->lanes.lags = true;
    if (own->type->modulated) rotor->lanes.modulated = true;
    if (own->type->slides && own->type->slides(own)) rotor->lanes.slides = true;
    if (own->type->jumps && own->type->jumps(own)) rotor->lanes.jumps = true;
    if (own->type->contact_gap) note_contact(rotor, index);
    if (!own->type->bearing_clearance || own->type->yields || !element_housing_stands(own)) return;
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

/// Adds the shaft's phase as the last state. If nothing depends on it, motions may return at any phase.
static void add_phase(whirl_rotor *rotor, const building *b) {
    enum { MAX_STATES = 2 * AXES * WHIRL_MAX_STATIONS + MAX_OWN_STATES };
    const size_t dimension = rotor->system.dimension, last = dimension - 1;
    double x[MAX_STATES], change[MAX_STATES] = {0}, slope[MAX_STATES] = {0};
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

static whirl_rotor *rotor_finish(building *b) {
    // Allocate one block for the rotor and its arrays.
    scale_body(&b->assembly);
    whirl_rotor *rotor = body_gather(&b->assembly.body, &b->panels) ? calloc(1, rotor_lay_out(NULL, NULL, b)) : NULL;
    if (!rotor) return NULL;
    rotor_lay_out(rotor, (char *)rotor, b);
    // Copy the data of the assembly.
    rotor->speed = b->assembly.speed;
    rotor->way = assembly_stands(&b->assembly) ? 0.0 : !b->keyphasor && b->assembly.turn < 0.0 ? -1.0 : 1.0;
    rotor->clock = b->assembly.clock;
    rotor->length = b->design->length;
    rotor->cross_coupling = b->assembly.cross_coupling;
    rotor->station_count = b->design->station_count;
    rotor->plane_count = b->assembly.plane_count;
    rotor->term_count = b->assembly.term_count;
    rotor->element_count = b->element_count;
    memcpy(rotor->terms, b->assembly.terms ? b->assembly.terms : rotor->terms,
           rotor->term_count * sizeof *rotor->terms);
    rotor->between_count = b->between_count;
    if (b->between) memcpy(rotor->between, b->between, b->between_count * sizeof *b->between);
    rotor->frequency_count = b->assembly.frequency_count;
    if (b->assembly.frequencies)
        memcpy(rotor->frequencies, b->assembly.frequencies, rotor->frequency_count * sizeof *rotor->frequencies);
    rotor->turning_count = b->assembly.turning_count;
    memcpy(rotor->guided, b->assembly.guided, sizeof rotor->guided);
    if (b->assembly.turnings)
        memcpy(rotor->turnings, b->assembly.turnings, rotor->turning_count * sizeof *rotor->turnings);
    memcpy(rotor->inertia, b->assembly.inertia, b->assembly.degrees * sizeof *rotor->inertia);
    memcpy(rotor->unit, b->assembly.unit, b->assembly.degrees * sizeof *rotor->unit);
    memcpy(rotor->pull, b->assembly.pull, sizeof rotor->pull);
    rotor->drive = b->assembly.drive;
    rotor->spool_count = b->assembly.spool_count;
    for (size_t k = 0; k < rotor->spool_count; k++) {
        const shaft_drive *drive = &b->assembly.spool_drives[k];
        rotor->spools[k] = b->assembly.spools[k];
        rotor->spools[k].driven = drive->given;
        rotor->spools[k].drive_speed = drive->given ? drive_highest(drive) : 0.0;
        rotor->spool_drives[k] = *drive;
    }
    for (size_t s = 0; s < rotor->station_count; s++) {
        rotor->spool_of[s] = b->assembly.stations[s].spool;
        rotor->housing_turns[s] = assembly_housing_ratio(&b->assembly, s);
    }
    rotor->torque_count = b->assembly.torque_count;
    if (b->assembly.torques) memcpy(rotor->torques, b->assembly.torques, rotor->torque_count * sizeof *rotor->torques);
    rotor->link_count = b->assembly.link_count;
    if (b->assembly.links) memcpy(rotor->links, b->assembly.links, rotor->link_count * sizeof *rotor->links);
    rotor->hold_count = b->assembly.hold_count;
    if (b->assembly.holds) memcpy(rotor->holds, b->assembly.holds, rotor->hold_count * sizeof *rotor->holds);
    rotor->fatigue_count = b->assembly.fatigue_count;
    if (b->assembly.fatigues)
        memcpy(rotor->fatigues, b->assembly.fatigues, rotor->fatigue_count * sizeof *rotor->fatigues);
    rotor->harmonic_count = b->assembly.harmonic_count;
    if (b->assembly.harmonics)
        memcpy(rotor->harmonics, b->assembly.harmonics, rotor->harmonic_count * sizeof *rotor->harmonics);
    // Copy stations, numbers and elements.
    for (size_t i = 0; i < b->assembly.weight_count; i++) {
        const turning_inertia *own = &b->assembly.weights[i];
        rotor->weight[own->row] += own->cos;
        rotor->weight[b->assembly.degrees + own->row] += own->sin;
    }
    add_probes(rotor, b);
    add_extra_probes(rotor, b);
    add_twists_and_axials(rotor, &b->assembly);
    add_runouts(rotor, &b->assembly);
    add_groups(rotor, &b->assembly);
    add_numbers(rotor, b);
    if (!add_body(rotor, &b->assembly)) {
        free(rotor);
        return NULL;
    }
    add_elements_to(rotor, b);
    rotor_find_turn(rotor, &b->assembly);
    rotor_find_shafts(rotor, &b->assembly);
    // Fill in the functions of lanes and of the system.
    rotor->lanes.degrees = b->assembly.degrees;
    rotor_find_torsion(rotor, &b->assembly);
    rotor->lanes.states = b->state_count;
    rotor->lanes.number_count = total_numbers(b);
    rotor_lanes_fill(rotor);
    size_t order[PAIR_STATIONS];
    if (is_pair(b, order, rotor->pair_laws)) rotor->lanes.pair_laws = rotor->pair_laws;
    rotor_system_fill(rotor);
    if (b->keyphasor) add_phase(rotor, b);
    return rotor;
}

/// Checks the limits of a rotor's arrays.
static whirl_status check_states(const building *b) {
    if (b->state_count <= MAX_OWN_STATES) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "the rotor's elements have %zu states of their own, expected at most %d",
                      b->state_count, MAX_OWN_STATES);
}

static whirl_status rotor_check_model(const whirl_rotor *rotor) {
    // There are at most as many contacts as elements.
    _Static_assert((int)WHIRL_MAX_ELEMENTS <= (int)WHIRL_MAX_CONTACTS, "a contact for every element");
    if (rotor->lanes.switch_count > WHIRL_MAX_SWITCHES)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has %zu switches, expected at most %d", rotor->lanes.switch_count,
                          WHIRL_MAX_SWITCHES);
    for (size_t i = 0; i < rotor->lanes.number_count; i++)
        if (!isfinite(rotor->numbers[i]))
            return whirl_fail(WHIRL_BAD_INPUT,
                              "the rotor's scaled coefficients are beyond all numbers: look at masses, "
                              "stiffnesses, speed and length scale");
    return rotor_check_fatigue(rotor);
}

whirl_status whirl_rotor_check(const whirl_design *design, whirl_rotor_tell *tell, void *context, size_t *problems) {
    building b = {.tell = tell, .context = context};
    whirl_status status = building_assemble(&b, design, NULL);
    if (status.code == WHIRL_OK && b.problems == 0) status = building_finish(&b);
    building_end(&b);
    if (status.code == WHIRL_BAD_INPUT) tell(context, WHIRL_NO_ELEMENT, &status);
    *problems = b.problems + (status.code == WHIRL_BAD_INPUT);
    return status.code == WHIRL_NO_MEMORY ? status : whirl_ok();
}

whirl_status whirl_rotor_outline(const whirl_design *design, whirl_rotor **out) {
    size_t order[PAIR_STATIONS];
    int laws[PAIR_LAWS];
    building b = {0};
    *out = NULL;
    if (design->station_count == 0)
        return whirl_fail(WHIRL_BAD_INPUT, "the rotor has no station, expected at least one");
    // Assemble the rotor, and once more if a pair requires another order of stations.
    whirl_status status = building_assemble(&b, design, NULL);
    if (status.code == WHIRL_OK && is_pair(&b, order, laws) && !in_order(&b, order)) {
        building_end(&b);
        b = (building){0};
        status = building_assemble(&b, design, order);
    }
    if (status.code == WHIRL_OK) status = building_finish(&b);
    if (status.code == WHIRL_OK) status = check_states(&b);
    whirl_rotor *rotor = status.code == WHIRL_OK ? rotor_finish(&b) : NULL;
    if (status.code == WHIRL_OK && !rotor)
        status = whirl_fail(WHIRL_NO_MEMORY, "no memory for a rotor of %zu stations", design->station_count);
    if (status.code == WHIRL_OK) status = coupling_fill(&rotor->coupled, &b.assembly);
    building_end(&b);
    if (status.code == WHIRL_OK) status = rotor_check_model(rotor);
    if (status.code == WHIRL_OK)
        *out = rotor;
    else
        whirl_rotor_free(rotor);
    return status;
}

whirl_status whirl_rotor_hold(whirl_rotor *rotor, const whirl_stop *stop) {
    whirl_status status = whirl_ok();
    rotor->system.stop = stop;
    while (rotor->held < rotor->element_count && status.code == WHIRL_OK) {
        const element *own = &rotor->elements[rotor->held];
        if (own->type->hold) status = own->type->hold(own, stop);
        rotor->held += status.code == WHIRL_OK;
    }
    return status;
}

whirl_status whirl_rotor_new(const whirl_design *design, whirl_rotor **out) {
    whirl_status status = whirl_rotor_outline(design, out);
    if (status.code == WHIRL_OK) status = whirl_rotor_hold(*out, NULL);
    if (status.code == WHIRL_OK) return status;
    whirl_rotor_free(*out);
    *out = NULL;
    return status;
}

void whirl_rotor_free(whirl_rotor *rotor) {
    for (size_t i = 0; rotor && i < rotor->held; i++)
        if (rotor->elements[i].type->hold) rotor->elements[i].type->release(&rotor->elements[i]);
    free(rotor);
}

/// Sets the states of elements if none of them was given.
static void begin_elements(const whirl_rotor *rotor, double *x) {
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        double *states = x + rotor->lanes.degrees + own->state;
        bool said = !own->type->begin;
        for (size_t k = 0; k < own->states && !said; k++) said = states[k] != 0.0;
        if (!said) own->type->begin(own, states);
    }
}

void whirl_rotor_complete(const whirl_rotor *rotor, double *x) {
    const size_t planes[] = {0, 1, rotor->lanes.degrees, rotor->lanes.degrees + 1};
    for (size_t k = 0; k < sizeof planes / sizeof *planes; k++) {
        double *of = x + planes[k];
        for (size_t i = 0; i < rotor->between_count; i++) of[rotor->between[i].row] = 0.0;
        for (size_t i = 0; i < rotor->between_count; i++)
            of[rotor->between[i].row] += rotor->between[i].share * of[rotor->between[i].column];
    }
    begin_elements(rotor, x);
}

const whirl_system *whirl_rotor_system(const whirl_rotor *rotor) {
    return &rotor->system;
}
double whirl_rotor_speed(const whirl_rotor *rotor) {
    return rotor->speed;
}
double whirl_rotor_cross_coupling(const whirl_rotor *rotor) {
    return rotor->cross_coupling;
}
double whirl_rotor_length_scale(const whirl_rotor *rotor) {
    return rotor->length;
}
bool whirl_rotor_drive(const whirl_rotor *rotor, double *highest) {
    bool driven = rotor->drive.given;
    for (size_t i = 0; i < rotor->torque_count; i++) {
        const size_t station = rotor->torques[i].station;
        driven = driven || station == NO_STATION || rotor->spool_of[station] == 0;
    }
    const double turns = rotor->drive.given ? rotor_turns(rotor, rotor->drive.at) : 0.0;
    *highest = turns > 0.0 ? drive_highest(&rotor->drive) / turns : 0.0;
    for (size_t i = 0; i < rotor->torque_count; i++) {
        const shaft_torque *own = &rotor->torques[i];
        const double faster = rotor_turns(rotor, own->station);
        if (own->station != NO_STATION && rotor->spool_of[own->station] > 0) continue;
        if (own->law->highest && faster > 0.0) *highest = fmax(*highest, own->law->highest(own) / faster);
    }
    return driven;
}
double whirl_rotor_clock(const whirl_rotor *rotor) {
    return rotor->clock;
}
const char *whirl_rotor_keyphasor(const whirl_rotor *rotor) {
    return rotor->keyphasor;
}
bool whirl_rotor_note(const whirl_rotor *rotor, size_t index, char text[WHIRL_MESSAGE_SIZE]) {
    for (size_t i = 0; i < rotor->element_count; i++) {
        const element *own = &rotor->elements[i];
        char said[WHIRL_MESSAGE_SIZE] = "";
        if (own->type->note) own->type->note(own, rotor->length, rotor->clock, said, sizeof said);
        if (!*said || index-- > 0) continue;
        snprintf(text, WHIRL_MESSAGE_SIZE, "%s at %s: %.300s", own->type->group.name, rotor->probes[own->station].name,
                 said);
        return true;
    }
    return false;
}

const char *const *whirl_rotor_contact_names(const whirl_rotor *rotor) {
    return rotor->contact_names;
}
