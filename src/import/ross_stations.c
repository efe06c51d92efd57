// Makes stations of the nodes that carry something, with names made of the tags.
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "page.h"
#include "ross.h"
#include "whirl/engine/rotor.h"

/// Makes a station's name of a tag: "Seal 1 (R0)" becomes "seal_1_r0".
void ross_name(const char *tag, const char *fallback, char name[WHIRL_NAME_SIZE]) {
    const size_t room = WHIRL_NAME_SIZE - 8; // for "_1024"
    size_t length = 0;
    bool gap = false;
    for (const char *c = tag; *c && length + 2 < room; c++) {
        const unsigned char letter = (unsigned char)*c;
        if (letter < 128 && (isalnum(letter) || letter == '-')) {
            if (gap && length > 0) name[length++] = '_';
            name[length++] = (char)tolower(letter);
            gap = false;
        } else {
            gap = true;
        }
    }
    name[length] = '\0';
    if (length == 0 || !isalpha((unsigned char)name[0])) snprintf(name, WHIRL_NAME_SIZE, "%s", fallback);
}

static bool is_taken(const ross_rotor *rotor, size_t count, const char *name) {
    if (strcmp(name, "ground") == 0) return true;
    for (size_t i = 0; i < count; i++)
        if (strcmp(rotor->stations[i].name, name) == 0) return true;
    return false;
}

static void give_name(import_reader *reader, ross_rotor *rotor, size_t index) {
    char fallback[WHIRL_NAME_SIZE], base[WHIRL_NAME_SIZE], name[WHIRL_NAME_SIZE + 16];
    ross_station *const station = &rotor->stations[index];
    snprintf(fallback, sizeof fallback, "node_%ld", station->node);
    ross_name(station->first, fallback, base);
    snprintf(name, sizeof name, "%s", base);
    for (int i = 2; is_taken(rotor, index, name); i++) snprintf(name, sizeof name, "%s_%d", base, i);
    char *const copy = field_memory(reader, strlen(name) + 1);
    if (copy) station->name = strcpy(copy, name);
}

/// Returns the station of a node, new if necessary; its name comes from the first tag.
static ross_station *station_of(ross_rotor *rotor, long node, const char *tag) {
    for (size_t i = 0; i < rotor->station_count; i++)
        if (rotor->stations[i].node == node) return &rotor->stations[i];
    ross_station *const added = &rotor->stations[rotor->station_count++];
    const bool in_row = node >= rotor->first_node && node <= rotor->last_node;
    *added = (ross_station){.node = node, .first = tag};
    if (in_row) added->place = &rotor->nodes[node - rotor->first_node];
    return added;
}

static void add_weight(ross_station *at, double mass, double diametral, double polar) {
    at->mass[0] += mass;
    at->mass[1] += mass;
    at->diametral += diametral;
    at->polar += polar;
}

static void collect_ends(ross_rotor *rotor, const ross_coupling *coupling) {
    for (int end = 0; end < 2; end++) {
        ross_station *const at = station_of(rotor, coupling->node + end, coupling->end_tag[end]);
        add_weight(at, coupling->mass[end], coupling->diametral[end], coupling->polar[end]);
    }
}

static void ross_collect(ross_rotor *rotor) {
    for (size_t i = 0; i < rotor->disc_count; i++) {
        const ross_disc *const disc = &rotor->discs[i];
        ross_station *const at = station_of(rotor, disc->node, disc->tag);
        add_weight(at, disc->mass, disc->diametral, disc->polar);
    }
    for (size_t i = 0; i < rotor->point_count; i++) {
        const ross_point *const point = &rotor->points[i];
        ross_station *const at = station_of(rotor, point->node, point->tag);
        for (int axis = 0; axis < 2; axis++) at->mass[axis] += point->mass[axis];
    }
    for (size_t i = 0; i < rotor->bearing_count; i++) {
        station_of(rotor, rotor->bearings[i].node, rotor->bearings[i].tag);
        if (rotor->bearings[i].link >= 0) station_of(rotor, rotor->bearings[i].link, "");
    }
    for (size_t i = 0; i < rotor->coupling_count; i++) collect_ends(rotor, &rotor->couplings[i]);
    if (rotor->station_count > 0) return;
    station_of(rotor, rotor->first_node, "left end");
    station_of(rotor, rotor->last_node, "right end");
}

/// Refuses an end of a coupling that no shaft reaches if the parts there have no mass or no diametral inertia.
static void check_free_ends(ross_rotor *rotor) {
    static const char *const masses[] = {"m_l", "m_r"}, *const inertias[] = {"Ip_l", "Ip_r"};
    for (size_t i = 0; i < 2 * rotor->coupling_count; i++) {
        ross_coupling *const coupling = &rotor->couplings[i / 2];
        const ross_station *const at = ross_station_at(rotor, coupling->node + (long)(i % 2));
        if (at->place->shaft != ROSS_NO_SHAFT) continue;
        const bool weighs = at->mass[0] > 0.0 && at->mass[1] > 0.0;
        const char *const key = (weighs ? inertias : masses)[i % 2];
        if (!weighs || !(at->diametral > 0.0))
            field_refuse(&coupling->section, key, value_member(coupling->section.table, key),
                         "is 0 %s at node %ld, where there is no shaft, expected a number above 0 %s",
                         weighs ? "kg m2" : "kg", at->node, weighs ? "kg m2" : "kg");
    }
}

static void sort_stations(ross_rotor *rotor) {
    for (size_t i = 1; i < rotor->station_count; i++) {
        const ross_station moved = rotor->stations[i];
        size_t j = i;
        for (; j > 0 && rotor->stations[j - 1].node > moved.node; j--) rotor->stations[j] = rotor->stations[j - 1];
        rotor->stations[j] = moved;
    }
}

void ross_find_stations(import_reader *reader, ross_rotor *rotor) {
    const size_t most =
        rotor->disc_count + rotor->point_count + 2 * rotor->bearing_count + 2 * rotor->coupling_count + 2;
    rotor->stations = field_memory(reader, most * sizeof *rotor->stations);
    if (!rotor->stations) return;
    ross_collect(rotor);
    if (rotor->station_count > WHIRL_MAX_STATIONS) {
        reader->status = whirl_fail(WHIRL_BAD_INPUT, "%.200s: has %zu nodes that carry something, expected at most %d",
                                    reader->file, rotor->station_count, WHIRL_MAX_STATIONS);
        return;
    }
    sort_stations(rotor);
    check_free_ends(rotor);
    for (size_t i = 0; i < rotor->station_count && field_good(reader); i++) give_name(reader, rotor, i);
}

const ross_station *ross_station_at(const ross_rotor *rotor, long node) {
    size_t i = 0;
    while (rotor->stations[i].node != node) i++;
    return &rotor->stations[i];
}

void ross_put_place(page_line *line, const ross_rotor *rotor, const ross_bearing *bearing) {
    page_item(line, "at: %s", ross_station_at(rotor, bearing->node)->name);
    if (bearing->link >= 0) page_item(line, "from: %s", ross_station_at(rotor, bearing->link)->name);
}
