// The shaft of ROSS's elements, and what sits on its nodes and beyond them.
#include <math.h>

#include "ross.h"
#include "whirl/rotor.h"

/// By their nodes; layers stay in the order of the file.
static void sort_pieces(ross_rotor *rotor) {
    for (size_t i = 1; i < rotor->piece_count; i++) {
        const ross_piece moved = rotor->pieces[i];
        size_t j = i;
        for (; j > 0 && rotor->pieces[j - 1].node > moved.node; j--) rotor->pieces[j] = rotor->pieces[j - 1];
        rotor->pieces[j] = moved;
    }
}

static void join_pieces(ross_rotor *rotor) {
    ross_piece *before = NULL;
    double end = 0.0;
    for (size_t i = 0; i < rotor->piece_count; i++) {
        ross_piece *const piece = &rotor->pieces[i];
        piece->start = end;
        if (before && piece->node == before->node) {
            piece->start = before->start;
            if (fabs(piece->length - before->length) > 1e-9 * before->length)
                field_refuse(&piece->section, "L", value_member(piece->section.table, "L"),
                             "is %.10g m, expected %.10g m, the length of '%.60s' on the same node %ld", piece->length,
                             before->length, before->tag, piece->node);
        } else if (before && piece->node != before->node + 1) {
            field_refuse(
                &piece->section, "n", value_member(piece->section.table, "n"),
                "is %ld after %ld, expected one shaft without a gap: rotors of several shafts are not taken over",
                piece->node, before->node);
        }
        before = piece;
        end = piece->start + piece->length;
    }
    rotor->first_node = rotor->pieces[0].node;
    rotor->last_node = rotor->pieces[rotor->piece_count - 1].node + 1;
}

static void find_positions(import_reader *reader, ross_rotor *rotor) {
    join_pieces(rotor);
    rotor->position =
        field_memory(reader, (size_t)(rotor->last_node - rotor->first_node + 1) * sizeof *rotor->position);
    for (size_t i = 0; i < rotor->piece_count && rotor->position; i++) {
        const ross_piece *const piece = &rotor->pieces[i];
        rotor->position[piece->node - rotor->first_node] = piece->start;
        rotor->position[piece->node - rotor->first_node + 1] = piece->start + piece->length;
    }
}

static bool on_shaft(const ross_rotor *rotor, long node) {
    return node >= rotor->first_node && node <= rotor->last_node;
}

/// A node beyond the shaft is a support where there is a mass.
static void check_node(ross_rotor *rotor, field_section *section, const char *key, long node) {
    bool held = on_shaft(rotor, node);
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
    if (on_shaft(rotor, point->node)) return;
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
    sort_pieces(rotor);
    find_positions(reader, rotor);
    if (rotor->last_node - rotor->first_node >= WHIRL_MAX_STATIONS && field_good(reader))
        reader->status = whirl_fail(WHIRL_BAD_INPUT, "%.200s: has a shaft of %ld nodes, expected at most %d",
                                    reader->file, rotor->last_node - rotor->first_node + 1, WHIRL_MAX_STATIONS);
    for (size_t i = 0; i < rotor->disc_count; i++)
        if (!on_shaft(rotor, rotor->discs[i].node))
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
