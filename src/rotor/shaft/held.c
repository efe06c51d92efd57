#include "held.h"
#include "mesh.h"

#include <stdlib.h>

#include "matrix.h"

held_shaft held_find(const mesh *from, size_t shaft) {
    held_shaft of = {.from = from, .shaft = shaft};
    while (from->nodes[of.first].shaft != shaft) of.first++;
    while (of.first + of.nodes < from->node_count && from->nodes[of.first + of.nodes].shaft == shaft) of.nodes++;
    return of;
}

size_t held_unknowns(const held_shaft *of) {
    return 2 * of->nodes + of->supports;
}

void held_piece(const mesh_piece *own, matrix4 *stiffness, matrix4 *axial) {
    piece_matrices all;
    piece_fill(&own->piece, &all);
    for (size_t i = 0; i < 4; i++)
        for (size_t j = 0; j < 4; j++)
            stiffness->at[i][j] = 0.5 * (all.stiffness[0].at[i][j] + all.stiffness[1].at[i][j]);
    *axial = all.axial;
}

void held_fill(const held_shaft *of, bool axial, double *matrix) {
    const size_t unknowns = held_unknowns(of);
    for (size_t p = 0; p < of->from->piece_count; p++) {
        const mesh_piece *own = &of->from->pieces[p];
        matrix4 stiffness, pulled;
        if (own->shaft != of->shaft) continue;
        held_piece(own, &stiffness, &pulled);
        for (size_t i = 0; i < 4; i++)
            for (size_t j = 0; j < 4; j++)
                matrix[(2 * (own->node[i / 2] - of->first) + i % 2) * unknowns + 2 * (own->node[j / 2] - of->first) +
                       j % 2] += stiffness.at[i][j] + (axial ? pulled.at[i][j] : 0.0);
    }
    for (size_t s = 0; s < of->supports; s++) {
        const size_t row = 2 * of->nodes + s, place = 2 * of->support[s];
        matrix[place * unknowns + row] = -1.0;
        matrix[row * unknowns + place] = 1.0;
    }
}

whirl_status held_influence(const held_shaft *of, double *influence) {
    const size_t unknowns = held_unknowns(of), count = of->supports;
    double *matrix = calloc(unknowns * (unknowns + count) + 1, sizeof *matrix);
    if (!matrix) return whirl_fail(WHIRL_NO_MEMORY, "no memory for a shaft that is held");
    double *raised = matrix + unknowns * unknowns; // [count][unknowns]
    held_fill(of, false, matrix);
    for (size_t k = 0; k < count; k++) raised[k * unknowns + 2 * of->nodes + k] = 1.0;
    const bool good = matrix_solve(unknowns, matrix, count, raised);
    for (size_t i = 0; i < count && good; i++)
        for (size_t k = 0; k < count; k++) influence[i * count + k] = raised[k * unknowns + 2 * of->nodes + i];
    free(matrix);
    return good ? whirl_ok() : whirl_fail(WHIRL_BAD_INPUT, "a shaft cannot be held at its stations");
}
