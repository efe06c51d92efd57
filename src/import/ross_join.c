// Joining ROSS elements: shafts, couplings between them, and parts on their nodes and beyond them.
#include <math.h>

#include "ross.h"
#include "whirl/engine/rotor.h"

/// Sorts the pieces by their nodes; layers stay in the order of the file.
static void sort_pieces(ross_rotor *rotor) {
    for (size_t i = 1; i < rotor->piece_count; i++) {
        const ross_piece moved = rotor->pieces[i];
        size_t j = i;
        for (; j > 0 && rotor->pieces[j - 1].node > moved.node; j--) rotor->pieces[j] = rotor->pieces[j - 1];
        rotor->pieces[j] = moved;
    }
}

static void sort_couplings(ross_rotor *rotor) {
    for (size_t i = 1; i < rotor->coupling_count; i++) {
        const ross_coupling moved = rotor->couplings[i];
        size_t j = i;
        for (; j > 0 && rotor->couplings[j - 1].node > moved.node; j--) rotor->couplings[j] = rotor->couplings[j - 1];
        rotor->couplings[j] = moved;
    }
}

/// Returns true if couplings lead from one node to a later one.
static bool couplings_lead(const ross_rotor *rotor, long from, long to) {
    for (long node = from; node < to; node++) {
        size_t i = 0;
        while (i < rotor->coupling_count && rotor->couplings[i].node != node) i++;
        if (i == rotor->coupling_count) return false;
    }
    return true;
}

/// Gives a piece its shaft and start: it is a layer of the piece before it, continues it, or begins the next shaft.
static void join_piece(ross_rotor *rotor, const ross_piece *before, ross_piece *piece) {
    piece->shaft = before->shaft;
    if (piece->node == before->node) {
        piece->start = before->start;
        if (fabs(piece->length - before->length) > 1e-9 * before->length)
            field_refuse(&piece->section, "L", value_member(piece->section.table, "L"),
                         "is %.10g m, expected %.10g m, the length of '%.60s' on the same node %ld", piece->length,
                         before->length, before->tag, piece->node);
    } else if (piece->node == before->node + 1) {
        piece->start = before->start + before->length;
    } else {
        piece->shaft = rotor->shaft_count++;
        if (!couplings_lead(rotor, before->node + 1, piece->node))
            field_refuse(&piece->section, "n", value_member(piece->section.table, "n"),
                         "is %ld after %ld, expected a shaft without a gap, or couplings from node %ld to %ld: other "
                         "rotors of several shafts are not taken over",
                         piece->node, before->node, before->node + 1, piece->node);
    }
}

static void join_pieces(ross_rotor *rotor) {
    rotor->shaft_count = 1;
    for (size_t i = 1; i < rotor->piece_count; i++) join_piece(rotor, &rotor->pieces[i - 1], &rotor->pieces[i]);
    rotor->first_node = rotor->pieces[0].node;
    rotor->last_node = rotor->pieces[rotor->piece_count - 1].node + 1;
}

static void refuse_apart(const ross_rotor *rotor, ross_coupling *coupling) {
    field_refuse(&coupling->section, "n", value_member(coupling->section.table, "n"),
                 "is %ld, expected a coupling between nodes of the shaft, %ld to %ld, or next to them", coupling->node,
                 rotor->first_node, rotor->last_node);
}

/// Extends the row of nodes to couplings beyond the pieces of shaft; their free ends become stations with a mass.
static void join_couplings(ross_rotor *rotor) {
    ross_coupling *const all = rotor->couplings;
    for (size_t i = rotor->coupling_count; i-- > 0;) {
        if (all[i].node + 1 < rotor->first_node) refuse_apart(rotor, &all[i]);
        if (all[i].node < rotor->first_node) rotor->first_node = all[i].node;
    }
    for (size_t i = 0; i < rotor->coupling_count; i++) {
        if (all[i].node > rotor->last_node) refuse_apart(rotor, &all[i]);
        if (all[i].node == rotor->last_node) rotor->last_node++;
    }
}

static void find_nodes(import_reader *reader, ross_rotor *rotor) {
    const size_t count = (size_t)(rotor->last_node - rotor->first_node + 1);
    rotor->nodes = field_memory(reader, count * sizeof *rotor->nodes);
    for (size_t i = 0; i < count && rotor->nodes; i++) rotor->nodes[i].shaft = ROSS_NO_SHAFT;
    for (size_t i = 0; i < rotor->piece_count && rotor->nodes; i++) {
        const ross_piece *const piece = &rotor->pieces[i];
        ross_node *const left = &rotor->nodes[piece->node - rotor->first_node];
        left[0] = (ross_node){piece->shaft, piece->start};
        left[1] = (ross_node){piece->shaft, piece->start + piece->length};
    }
}

/// Returns true for nodes of the shafts and couplings, which are in one row.
static bool in_row(const ross_rotor *rotor, long node) {
    return node >= rotor->first_node && node <= rotor->last_node;
}

/// Checks a node: beyond the shafts it is a support, and needs a mass.
static void check_node(ross_rotor *rotor, field_section *section, const char *key, long node) {
    bool held = in_row(rotor, node);
    for (size_t i = 0; i < rotor->point_count; i++) {
        if (rotor->points[i].node != node) continue;
        rotor->points[i].used = true;
        held = true;
    }
    if (!held)
        field_refuse(section, key, value_member(section->table, key),
                     "is %ld, expected a node of the shaft, %ld to %ld, or of a point mass", node, rotor->first_node,
                     rotor->last_node);
}

static void check_point(ross_rotor *rotor, ross_point *point) {
    if (in_row(rotor, point->node)) return;
    if (!point->used)
        field_refuse(&point->section, "n", value_member(point->section.table, "n"),
                     "is %ld, expected a node of the shaft, %ld to %ld, or of a bearing", point->node,
                     rotor->first_node, rotor->last_node);
    for (int axis = 0; axis < 2; axis++)
        if (!(point->mass[axis] > 0.0))
            field_refuse(&point->section, axis ? "my" : "mx", NULL,
                         "is 0 kg, expected a support with a mass above 0 kg");
}

void ross_join(import_reader *reader, ross_rotor *rotor) {
    if (!field_good(reader)) return;
    // Order the pieces and couplings, and give them and the nodes their places.
    sort_pieces(rotor);
    sort_couplings(rotor);
    join_pieces(rotor);
    join_couplings(rotor);
    find_nodes(reader, rotor);
    if (rotor->last_node - rotor->first_node >= WHIRL_MAX_STATIONS && field_good(reader))
        reader->status = whirl_fail(WHIRL_BAD_INPUT, "%.200s: has a shaft of %ld nodes, expected at most %d",
                                    reader->file, rotor->last_node - rotor->first_node + 1, WHIRL_MAX_STATIONS);
    // Check the nodes of all other elements.
    for (size_t i = 0; i < rotor->disc_count; i++)
        if (!in_row(rotor, rotor->discs[i].node))
            field_refuse(&rotor->discs[i].section, "n", value_member(rotor->discs[i].section.table, "n"),
                         "is %ld, expected a node of the shaft, %ld to %ld", rotor->discs[i].node, rotor->first_node,
                         rotor->last_node);
    for (size_t i = 0; i < rotor->bearing_count; i++) {
        ross_bearing *const bearing = &rotor->bearings[i];
        check_node(rotor, &bearing->section, "n", bearing->node);
        if (bearing->link >= 0) check_node(rotor, &bearing->section, "n_link", bearing->link);
        if (bearing->link == bearing->node)
            field_refuse(&bearing->section, "n_link", value_member(bearing->section.table, "n_link"),
                         "is %ld as n is, expected another node", bearing->link);
    }
    for (size_t i = 0; i < rotor->point_count; i++) check_point(rotor, &rotor->points[i]);
}
