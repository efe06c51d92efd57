// Closed curves: a quasi-periodic motion with two frequencies draws one or several closed curves into its section and
// visits them in turn. The points are joined by a minimum spanning tree; on well-filled curves the tree follows each of
// them and jumps from one to the next over edges longer than any other. Cutting those leaves the curves.
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "curves.h"
#include "section.h"

enum { MAX_POINTS = 2000, MAX_CURVES = WHIRL_MAX_PERIOD, MIN_POINTS_A_CURVE = 12 };

/// An edge to the nearest point that was in the tree before.
typedef struct edge {
    size_t point, parent;
    double length;
} edge;

/// The tree of a section; one block.
typedef struct tree {
    size_t count;
    edge *edges;      ///< [count - 1], in the order in which they joined
    edge *longest;    ///< [count - 1] the same edges, longest first
    size_t *label;    ///< [count] curve of each point
    double *distance; ///< [count] scratch: to the nearest point of the tree, -1 for points in it
    size_t *nearest;  ///< [count] scratch: that point
} tree;

static tree *tree_new(size_t count) {
    tree *t = malloc(sizeof *t + 2 * count * sizeof(edge) + count * (2 * sizeof(size_t) + sizeof(double)));
    if (!t) return NULL;
    t->count = count;
    t->edges = (edge *)(t + 1);
    t->longest = t->edges + count;
    t->label = (size_t *)(t->longest + count);
    t->nearest = t->label + count;
    t->distance = (double *)(t->nearest + count);
    return t;
}

static int longer_first(const void *a, const void *b) {
    const double first = ((const edge *)a)->length, second = ((const edge *)b)->length;
    return (first < second) - (first > second);
}

/// Grows the tree from point 0 by Prim's algorithm.
static void curves_grow(tree *t, const section *points) {
    // The tree begins as point 0.
    for (size_t i = 1; i < t->count; i++) {
        t->distance[i] = section_distance(points, 0, i);
        t->nearest[i] = 0;
    }
    t->distance[0] = -1.0; // in the tree
    // Add the nearest point, and update the distances of all others.
    for (size_t e = 0; e + 1 < t->count; e++) {
        size_t next = 0;
        for (size_t i = 1; i < t->count; i++) {
            if (t->distance[i] >= 0.0 && (next == 0 || t->distance[i] < t->distance[next])) next = i;
        }
        t->edges[e] = (edge){next, t->nearest[next], t->distance[next]};
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
    // Order the edges by length.
    memcpy(t->longest, t->edges, (t->count - 1) * sizeof(edge));
    qsort(t->longest, t->count - 1, sizeof(edge), longer_first);
}

/// Labels the parts that remain when the `cuts` longest edges are cut. Edges are in the order in which their points
/// joined the tree, so a parent always has its label before its children.
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

/// Returns true if the points visit the `parts` parts in a fixed cyclic order: points n and n + parts are on the same
/// part.
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

/// The longest path through a part, in points, and its ends.
typedef struct part_path {
    size_t size, length, ends[2];
} part_path;

/// Number of points on the longest way down from a point, and the point where it ends.
typedef struct descent {
    size_t length, end;
} descent;

/// Finds the longest paths of all parts. Children join after their parents, so that one pass from the last to the first
/// suffices.
static void longest_paths(const tree *t, size_t parts, descent *down, part_path *paths) {
    for (size_t p = 0; p < parts; p++) paths[p] = (part_path){0};
    for (size_t i = 0; i < t->count; i++) {
        down[i] = (descent){1, i};
        part_path *own = &paths[t->label[i]];
        own->size++;
        if (own->length == 0) *own = (part_path){own->size, 1, {i, i}};
    }
    for (size_t e = t->count - 1; e-- > 0;) {
        const size_t child = t->edges[e].point, parent = t->edges[e].parent;
        if (t->label[child] != t->label[parent]) continue;
        part_path *own = &paths[t->label[child]];
        const size_t through = down[parent].length + down[child].length;
        if (through > own->length) *own = (part_path){own->size, through, {down[parent].end, down[child].end}};
        if (down[child].length + 1 > down[parent].length)
            down[parent] = (descent){down[child].length + 1, down[child].end};
    }
}

/// Returns the largest distance of a part's points from one of them.
static double curves_reach(const tree *t, const section *points, size_t from) {
    double farthest = 0.0;
    for (size_t i = 0; i < t->count; i++) {
        if (t->label[i] == t->label[from]) farthest = fmax(farthest, section_distance(points, from, i));
    }
    return farthest;
}

/// Returns true if a part is one closed, well-filled curve: nearly all of its points on one path whose ends are
/// neighbours, with no large gap.
static bool is_closed(const tree *t, const section *points, const part_path *path, double longest_edge) {
    const double least_on_path = 0.9;  // of the points; the rest are twigs near close passes of the curve
    const double widest_closing = 3.0; // longest edges on the curves: gaps of a rotation differ by a small factor
    const double widest_gap = 0.35;    // of the curve's diameter
    if ((double)path->length < least_on_path * (double)path->size) return false;
    if (section_distance(points, path->ends[0], path->ends[1]) > widest_closing * longest_edge) return false;
    return longest_edge <= widest_gap * curves_reach(t, points, path->ends[0]);
}

static bool all_closed(const tree *t, const section *points, size_t parts) {
    descent *down = malloc(t->count * sizeof *down);
    part_path paths[MAX_CURVES];
    if (!down) return false;
    longest_paths(t, parts, down, paths);
    free(down);
    bool closed = true;
    for (size_t p = 0; p < parts && closed; p++) closed = is_closed(t, points, &paths[p], t->longest[parts - 1].length);
    return closed;
}

static int curves_ascending(const void *a, const void *b) {
    const size_t first = *(const size_t *)a, second = *(const size_t *)b;
    return (first > second) - (first < second);
}

/// Returns the median of the revolutions between the two points of an edge that was not cut. Overwrites the tree's
/// workspace.
static int median_lag(tree *t) {
    size_t count = 0, *lags = t->nearest;
    for (size_t e = 0; e + 1 < t->count; e++) {
        const size_t a = t->edges[e].point, b = t->edges[e].parent;
        if (t->label[a] == t->label[b]) lags[count++] = a > b ? a - b : b - a;
    }
    qsort(lags, count, sizeof *lags, curves_ascending);
    return (int)lags[count / 2];
}

closed_curves curves_find(const section *all) {
    const double clear_gap = 1.5; // between curves, over the longest edge on one
    const section points = section_tail(all, MAX_POINTS);
    closed_curves found = {0, 0};
    if (points.count < MIN_POINTS_A_CURVE) return found;
    tree *t = tree_new(points.count);
    if (!t) return found;
    curves_grow(t, &points);
    for (size_t parts = points.count / MIN_POINTS_A_CURVE; parts >= 1 && found.count == 0; parts--) {
        if (parts > MAX_CURVES) continue;
        if (parts > 1 && t->longest[parts - 2].length < clear_gap * t->longest[parts - 1].length) continue;
        label_parts(t, parts - 1);
        if (visited_in_turn(t, parts) && all_closed(t, &points, parts)) found.count = (int)parts;
    }
    if (found.count > 0) found.neighbours = median_lag(t);
    free(t);
    return found;
}
