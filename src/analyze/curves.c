// Closed curves: a quasi-periodic motion with two frequencies draws one or several closed curves into its section and
// visits them in turn. The points are joined by a minimum spanning tree; on well-filled curves the tree follows each of
// them and jumps from one to the next over edges longer than any other. Cutting those leaves the curves.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "section.h"

enum { MOST_POINTS = 2000, MOST_CURVES = WHIRL_MAX_PERIOD, FEWEST_POINTS_A_CURVE = 12 };

/// An edge to the nearest point that was in the tree before.
typedef struct edge {
    size_t point, parent;
    double length;
} edge;

/// The tree of a section; one block.
typedef struct tree {
    size_t count;
    edge *edges;      ///< [count - 1], in the order in which they joined
    edge *longest;    ///< the same, longest first
    size_t *label;    ///< [count] curve of each point
    size_t *parent;   ///< [count] nearest point on the way to the root; the root its own
    double *distance; ///< [count] work: distance to the tree; later: points on the longest path
    size_t *nearest;  ///< [count] work
} tree;

static tree *tree_new(size_t count) {
    tree *t = malloc(sizeof *t + 2 * count * sizeof(edge) + count * (3 * sizeof(size_t) + sizeof(double)));
    if (!t) return NULL;
    t->count = count;
    t->edges = (edge *)(t + 1);
    t->longest = t->edges + count;
    t->label = (size_t *)(t->longest + count);
    t->parent = t->label + count;
    t->nearest = t->parent + count;
    t->distance = (double *)(t->nearest + count);
    return t;
}

static int longer_first(const void *a, const void *b) {
    const double first = ((const edge *)a)->length, second = ((const edge *)b)->length;
    return (first < second) - (first > second);
}

/// Prim's algorithm, from point 0.
static void grow(tree *t, const section *points) {
    t->parent[0] = 0;
    for (size_t i = 1; i < t->count; i++) {
        t->distance[i] = section_distance(points, 0, i);
        t->nearest[i] = 0;
    }
    t->distance[0] = -1.0; // in the tree
    for (size_t e = 0; e + 1 < t->count; e++) {
        size_t next = 0;
        for (size_t i = 1; i < t->count; i++) {
            if (t->distance[i] >= 0.0 && (next == 0 || t->distance[i] < t->distance[next])) next = i;
        }
        t->edges[e] = (edge){next, t->nearest[next], t->distance[next]};
        t->parent[next] = t->nearest[next];
        t->distance[next] = -1.0;
        for (size_t i = 1; i < t->count; i++) {
            if (t->distance[i] < 0.0) continue;
            const double d = section_distance(points, next, i);
            if (d < t->distance[i]) {
                t->distance[i] = d;
                t->nearest[i] = next;
            }
        }
    }
    memcpy(t->longest, t->edges, (t->count - 1) * sizeof(edge));
    qsort(t->longest, t->count - 1, sizeof(edge), longer_first);
}

/// Labels the parts that are left when the `cuts` longest edges are cut. Edges joined in the order of their list, so
/// the parent's label is always there.
static void label_parts(tree *t, size_t cuts) {
    size_t parts = 1;
    t->label[0] = 0;
    for (size_t e = 0; e + 1 < t->count; e++) {
        const edge *joined = &t->edges[e];
        bool cut = false;
        for (size_t c = 0; c < cuts; c++) cut = cut || t->longest[c].point == joined->point;
        t->label[joined->point] = cut ? parts++ : t->label[joined->parent];
    }
}

/// Whether the points visit the `parts` parts in a fixed cyclic order, so that n and n + parts are on the same.
static bool visited_in_turn(const tree *t, size_t parts) {
    for (size_t n = 0; n + parts < t->count; n++) {
        if (t->label[n] != t->label[n + parts]) return false;
    }
    for (size_t a = 0; a < parts; a++) {
        for (size_t b = 0; b < a; b++) {
            if (t->label[a] == t->label[b]) return false;
        }
    }
    return true;
}
