// Coexisting attractors of studies with several starts a place, numbered along the study: attractors of neighbouring
// places share a number if each is the other's nearest and the motion has changed by less than half its extent.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "attractors.h"
#include "bounds.h"

/// Largest distance, over their extent, of motions that share a number.
static const double farthest = 0.5;

/// State of the search for coexisting attractors.
typedef struct search {
    const whirl_table *table;
    size_t places;
    size_t *points;         ///< [table->count] points, sorted by place, then by start
    size_t *first;          ///< [places + 1] index in `points` of each place's first point
    size_t *of;             ///< [table->count] index of the point's attractor in its place
    size_t *begins;         ///< [places + 1] index of each place's first attractor
    size_t count, capacity; ///< attractors of all places, and capacity
    whirl_coexisting *items;
    motion **motions; ///< [count]
    size_t *parent;   ///< [count] union-find forest of attractors with one number
    size_t *next;     ///< [count] next attractor with the same number (a ring)
    size_t *sizes;    ///< [count] sizes of the rings, at their roots
} search;

// ---------------------------------------------------------------- places

/// Counts and lists the points of every place.
static bool list_points(search *s) {
    const whirl_table *table = s->table;
    s->points = calloc(table->count + 1, sizeof *s->points);
    s->first = calloc(s->places + 2, sizeof *s->first);
    s->begins = calloc(s->places + 1, sizeof *s->begins);
    s->of = calloc(table->count + 1, sizeof *s->of);
    if (!s->points || !s->first || !s->begins || !s->of) return false;
    for (size_t i = 0; i < table->count; i++) s->first[whirl_table_place(table, i) + 2]++;
    for (size_t k = 2; k <= s->places + 1; k++) s->first[k] += s->first[k - 1];
    for (size_t i = 0; i < table->count; i++) s->points[s->first[whirl_table_place(table, i) + 1]++] = i;
    return true;
}

/// Grows the arrays by as many attractors as a place may have.
static bool coexistence_make_room(search *s) {
    if (s->count + MAX_ATTRACTORS <= s->capacity) return true;
    const size_t capacity = 2 * s->capacity + MAX_ATTRACTORS;
    whirl_coexisting *items = realloc(s->items, capacity * sizeof *items);
    if (items) s->items = items;
    motion **motions = realloc(s->motions, capacity * sizeof(motion *));
    if (motions) s->motions = motions;
    if (items && motions) s->capacity = capacity;
    return items && motions;
}

static whirl_status group_place(search *s, size_t place) {
    attractor_groups groups;
    if (!coexistence_make_room(s))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the attractors of %zu places", s->places);
    const size_t *points = s->points + s->first[place], count = s->first[place + 1] - s->first[place];
    const whirl_status status = attractors_group(s->table, points, count, s->of, &groups);
    s->begins[place] = s->count;
    for (size_t k = 0; k < groups.count; k++) {
        const whirl_attractor *one = &groups.found[k];
        s->items[s->count] = (whirl_coexisting){.place = place,
                                                .first = one->first,
                                                .starts = one->points,
                                                .of = groups.done,
                                                .coexisting = groups.count,
                                                .share = one->share,
                                                .error = one->error};
        s->motions[s->count++] = groups.motions[k];
    }
    return status;
}

// ---------------------------------------------------------------- neighbours

/// Two attractors at neighbouring places, each the other's nearest.
typedef struct pair {
    size_t a, b;
    double distance;
} pair;

typedef struct pairs {
    pair *items;
    size_t count, capacity;
} pairs;

/// Returns a place's attractor nearest to `of`, or s->count if none is near enough.
static size_t coexistence_nearest(const search *s, size_t of, size_t place, double *distance) {
    size_t found = s->count;
    *distance = farthest;
    for (size_t k = s->begins[place]; k < s->begins[place + 1]; k++) {
        const double away = motion_distance(s->motions[of], s->motions[k]);
        if (!(away < *distance)) continue;
        *distance = away;
        found = k;
    }
    return found;
}

static bool add_pair(pairs *all, pair one) {
    if (all->count == all->capacity) {
        const size_t capacity = 2 * all->capacity + 64;
        pair *items = realloc(all->items, capacity * sizeof *items);
        if (!items) return false;
        all->items = items;
        all->capacity = capacity;
    }
    all->items[all->count++] = one;
    return true;
}

static bool pair_places(const search *s, size_t place, size_t other, pairs *all) {
    for (size_t a = s->begins[place]; a < s->begins[place + 1]; a++) {
        double distance, back;
        const size_t b = coexistence_nearest(s, a, other, &distance);
        if (b < s->count && coexistence_nearest(s, b, place, &back) == a && !add_pair(all, (pair){a, b, distance}))
            return false;
    }
    return true;
}

/// Returns the next place along an axis that has an attractor, or `places`.
static size_t next_place(const search *s, size_t place, const map_axis *axis) {
    for (size_t at = place / axis->step % axis->count + 1; at < axis->count; at++) {
        place += axis->step;
        if (s->begins[place] < s->begins[place + 1]) return place;
    }
    return s->places;
}

/// Pairs the attractors of places that are neighbours along the sweep, or along all axes of a map. Places without any
/// verdict are skipped.
static bool pair_neighbours(const search *s, pairs *all) {
    map_axis axes[MAP_AXES];
    const size_t count = map_axes_of(s->table, axes);
    for (size_t place = 0; place < s->places; place++)
        for (size_t i = 0; i < count && s->begins[place] < s->begins[place + 1]; i++) {
            const size_t next = next_place(s, place, &axes[i]);
            if (next < s->places && !pair_places(s, place, next, all)) return false;
        }
    return true;
}

static int by_distance(const void *left, const void *right) {
    const pair *a = left, *b = right;
    if (a->distance != b->distance) return a->distance < b->distance ? -1 : 1;
    if (a->a != b->a) return a->a < b->a ? -1 : 1;
    return (a->b > b->b) - (a->b < b->b);
}

// ---------------------------------------------------------------- one number

static size_t root_of(search *s, size_t k) {
    while (s->parent[k] != k) k = s->parent[k] = s->parent[s->parent[k]];
    return k;
}

/// Returns true if both groups have an attractor at one place. Around a cusp the sheet of attractors over two
/// parameters folds, so joining them would give two attractors of one place the same number.
static bool share_a_place(search *s, size_t small, size_t large) {
    size_t k = small;
    do {
        const size_t place = s->items[k].place;
        for (size_t i = s->begins[place]; i < s->begins[place + 1]; i++)
            if (root_of(s, i) == large) return true;
        k = s->next[k];
    } while (k != small);
    return false;
}

static void coexistence_join(search *s, const pair *one) {
    size_t a = root_of(s, one->a), b = root_of(s, one->b);
    if (a == b) return;
    if (s->sizes[a] < s->sizes[b] || (a > b && s->sizes[a] == s->sizes[b])) {
        const size_t larger = b;
        b = a;
        a = larger;
    }
    if (share_a_place(s, b, a)) return;
    s->parent[b] = a;
    s->sizes[a] += s->sizes[b];
    const size_t after = s->next[a];
    s->next[a] = s->next[b];
    s->next[b] = after;
}

/// Joins pairs, closest first.
static whirl_status join_neighbours(search *s) {
    pairs all = {.items = NULL};
    s->parent = calloc(3 * (s->count + 1), sizeof *s->parent);
    const bool memory = s->parent && pair_neighbours(s, &all);
    if (memory) {
        s->next = s->parent + s->count;
        s->sizes = s->next + s->count;
        for (size_t k = 0; k < s->count; k++) s->parent[k] = s->next[k] = k, s->sizes[k] = 1;
        if (all.count > 0) qsort(all.items, all.count, sizeof *all.items, by_distance);
        for (size_t i = 0; i < all.count; i++) coexistence_join(s, &all.items[i]);
    }
    free(all.items);
    return memory ? whirl_ok()
                  : whirl_fail(WHIRL_NO_MEMORY, "no memory to compare the attractors of %zu places", s->places);
}

/// Sort key of a number: how many starts lead there.
typedef struct weight {
    size_t root, starts;
    bool there; ///< reached by a start other than those from neighbours
} weight;

static int by_starts(const void *left, const void *right) {
    const weight *a = left, *b = right;
    if (a->starts != b->starts) return a->starts < b->starts ? 1 : -1;
    if (a->there != b->there) return a->there ? -1 : 1;
    return (a->root > b->root) - (a->root < b->root);
}

/// Numbers the groups from 1, the one with most starts first. *most is how many there are.
static whirl_status give_numbers(search *s, size_t *most) {
    weight *weights = calloc(s->count + 1, sizeof *weights);
    size_t *numbers = calloc(s->count + 1, sizeof *numbers);
    *most = 0;
    if (weights && numbers) {
        // The first attractor of a group represents it, whichever one is its root.
        for (size_t k = s->count; k-- > 0;) weights[root_of(s, k)].root = k;
        for (size_t k = 0; k < s->count; k++) {
            weights[root_of(s, k)].starts += s->items[k].starts;
            weights[root_of(s, k)].there = true;
        }
        qsort(weights, s->count, sizeof *weights, by_starts);
        while (*most < s->count && weights[*most].there) {
            numbers[root_of(s, weights[*most].root)] = *most + 1;
            ++*most;
        }
        for (size_t k = 0; k < s->count; k++) s->items[k].number = numbers[root_of(s, k)];
    }
    const bool memory = weights && numbers;
    free(weights);
    free(numbers);
    return memory ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "no memory for the numbers of %zu attractors", s->count);
}

// ---------------------------------------------------------------- the whole

static int coexistence_by_number(const void *left, const void *right) {
    const whirl_coexisting *a = left, *b = right;
    if (a->place != b->place) return a->place < b->place ? -1 : 1;
    return (a->number > b->number) - (a->number < b->number);
}

static void take_labels(const search *s, size_t *labels) {
    for (size_t i = 0; i < s->table->count; i++) {
        const size_t place = whirl_table_place(s->table, i), which = s->of[i];
        labels[i] = which < MAX_ATTRACTORS ? s->items[s->begins[place] + which].number : 0;
    }
}

static whirl_status coexistence_find(search *s, whirl_coexistence *found) {
    whirl_status status = whirl_ok();
    found->labels = calloc(s->table->count + 1, sizeof *found->labels);
    if (!found->labels || !list_points(s))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory for the attractors of %zu points", s->table->count);
    for (size_t place = 0; place < s->places && status.code == WHIRL_OK; place++) status = group_place(s, place);
    s->begins[s->places] = s->count;
    if (status.code == WHIRL_OK) status = join_neighbours(s);
    if (status.code == WHIRL_OK) status = give_numbers(s, &found->attractors);
    if (status.code != WHIRL_OK) return status;
    take_labels(s, found->labels);
    qsort(s->items, s->count, sizeof *s->items, coexistence_by_number);
    found->items = s->items;
    found->count = s->count;
    s->items = NULL;
    return status;
}

whirl_status whirl_table_coexistence(const whirl_table *table, whirl_coexistence *found) {
    search s = {.table = table, .places = whirl_table_places(table)};
    *found = (whirl_coexistence){.places = s.places};
    const whirl_status status = coexistence_find(&s, found);
    for (size_t k = 0; k < s.count; k++) free(s.motions[k]);
    free(s.points);
    free(s.first);
    free(s.of);
    free(s.begins);
    free(s.items);
    free(s.motions);
    free(s.parent);
    if (status.code != WHIRL_OK) whirl_coexistence_free(found);
    return status;
}

const whirl_coexisting *whirl_coexistence_at(const whirl_coexistence *found, const whirl_table *table, size_t point) {
    if (point >= table->count || found->labels[point] == 0) return NULL;
    const whirl_coexisting wanted = {.place = whirl_table_place(table, point), .number = found->labels[point]};
    return bsearch(&wanted, found->items, found->count, sizeof *found->items, coexistence_by_number);
}

void whirl_coexistence_free(whirl_coexistence *found) {
    free(found->items);
    free(found->labels);
    *found = (whirl_coexistence){.places = 0};
}
