// Findings on spectral lines along a parameter, below and above the synchronous one: the range of each line, its share
// of the clearance, how it begins and ends on the way up and on the way down, where its amplitude or its order jumps,
// and where its order is locked at a ratio.
#include <math.h>
#include <stdlib.h>

#include "quantities.h"
#include "shown_kinds.h"

/// Least size of a line that counts, relative to the largest line of its station.
static const double least_share = 0.05;

/// With more points than this, a line must be present at several neighbouring points: single lines among chaotic
/// motions do not count.
enum { FEW_POINTS = 8 };

/// multiple: tolerance within which an order counts as a multiple of the speed. drift: largest relative change of an
/// order from point to point.
static const double multiple = 0.02, drift = 0.1;

/// The strongest line of a point on one side of the synchronous one.
typedef struct line_seen {
    size_t station;
    double order, size; ///< size in m, zero to peak, along the axis where it is larger; 0: no line
    double share;       ///< share of the station's gap or clearance; NaN without one
    double direction;   ///< 1: forward, -1: backward
    double over;        ///< size over the largest line of its station
} line_seen;

/// Describes a line of the field spectrum/lines, with its share of the clearance or gap at its station.
static line_seen line_of(const finder *of, size_t point, size_t station, const double *line) {
    const whirl_probe *around = &of->result->stations[station];
    const double largest = fmax(line[1], line[2]), clearance = around->gap > 0.0 ? around->gap : around->clearance;
    return (line_seen){.station = station,
                       .order = line[0],
                       .size = largest * whirl_result_length_scale(of->result, of->table, point),
                       .share = clearance > 0.0 ? largest / clearance : (double)NAN,
                       .direction = (line[3] - line[4]) / fmax(line[3] + line[4], 1e-300)};
}

/// Returns the strongest line of a point below the synchronous one (`below`), or above it and not at a multiple of the
/// speed; size 0 if there is none.
static line_seen strongest_line(const finder *of, size_t point, bool below) {
    line_seen best = {.size = 0.0};
    for (size_t station = 0; station < of->result->station_count; station++) {
        const numbers lines = point_lines(of->table, point, station);
        const double largest = lines.rows > 0 ? fmax(lines.at[1], lines.at[2]) : 0.0;
        for (size_t i = 0; i < lines.rows; i++) {
            const double *line = lines.at + i * lines.columns;
            const bool side = below ? line[0] < 1.0 - multiple && line[0] > multiple
                                    : line[0] > 1.0 + multiple && fabs(line[0] - round(line[0])) > multiple;
            if (!side || fmax(line[1], line[2]) < least_share * largest) continue;
            line_seen own = line_of(of, point, station, line);
            own.over = fmax(line[1], line[2]) / largest;
            if (own.size > best.size) best = own;
        }
    }
    return best;
}

/// A line at neighbouring points, with an order that hardly changes from one point to the next.
typedef struct line_track {
    size_t first, last, largest_at;
    line_seen from, to, largest;
} line_track;

static bool track_goes_on(const finder *of, const line_track *track, size_t point, const line_seen *line) {
    const whirl_table *table = of->table;
    return table->branch[point] == table->branch[track->last] &&
           whirl_table_slot(table, point) == whirl_table_slot(table, track->last) + 1 &&
           fabs(line->order - track->to.order) <= drift * track->to.order;
}

static void track_row(const finder *of, whirl_sheet *sheet, const line_track *track) {
    const double orders[] = {track->from.order, track->to.order};
    const double rates[] = {track->from.order * whirl_table_clock(of->result, of->table, track->first),
                            track->to.order * whirl_table_clock(of->result, of->table, track->last)};
    const bool known = isfinite(rates[0]) && isfinite(rates[1]);
    sheet_row(of, sheet);
    cell_number(of, sheet, of->table->values[track->first]);
    cell_number(of, sheet, of->table->values[track->last]);
    cell_text(of, sheet, of->table->branch[track->first] < 0 ? "on the way back" : "");
    cell_numbers(of, sheet, 2, orders);
    cell_numbers(of, sheet, known ? 2 : 0, rates);
    cell_number(of, sheet, track->largest.size);
    cell_station(of, sheet, track->largest.station);
    cell_number(of, sheet, of->table->values[track->largest_at]);
    cell_number(of, sheet, 100.0 * track->largest.share);
    cell_text(of, sheet,
              track->largest.direction > 0.05    ? "forward"
              : track->largest.direction < -0.05 ? "backward"
                                                 : "to and fro");
}

/// Lines on one side of the synchronous one: the strongest of every point, and their tracks.
typedef struct line_side {
    line_seen *seen;    ///< [points of the table]
    line_track *tracks; ///< [count]
    size_t count;
} line_side;

static void side_free(line_side *side) {
    free(side->seen);
    free(side->tracks);
}

/// Adds a track, unless it is a single point among many.
static void side_add(const finder *of, line_side *side, const line_track *track) {
    if (track->last > track->first || of->table->count <= FEW_POINTS) side->tracks[side->count++] = *track;
}

/// Follows the lines of a side into tracks. Returns false without memory.
static bool side_find(const finder *of, bool below, line_side *side) {
    // Make memory: the strongest line of each point, and at most as many tracks as points.
    const size_t count = of->table->count;
    line_track track = {.largest = {.size = 0.0}};
    bool open = false;
    *side = (line_side){calloc(count, sizeof *side->seen), calloc(count, sizeof *side->tracks), 0};
    if (!side->seen || !side->tracks) return false;
    // Extend the open track by the point's line, or close it and begin another one.
    for (size_t point = 0; point < count; point++) {
        if (whirl_table_done(of->table, point)) side->seen[point] = strongest_line(of, point, below);
        const line_seen line = side->seen[point];
        const bool there = line.size > 0.0;
        if (open && !(there && track_goes_on(of, &track, point, &line))) {
            side_add(of, side, &track);
            open = false;
        }
        if (!there) continue;
        if (!open) track = (line_track){.first = point, .from = line, .largest = {.size = 0.0}};
        open = true;
        track.last = point;
        track.to = line;
        if (line.size > track.largest.size) track.largest = line, track.largest_at = point;
    }
    if (open) side_add(of, side, &track);
    return true;
}

static line_track side_largest(const line_side *side) {
    line_track most = {.largest = {.size = 0.0}};
    for (size_t i = 0; i < side->count; i++)
        if (side->tracks[i].largest.size > most.largest.size) most = side->tracks[i];
    return most;
}

// ---------------------------------------------------------------- beginnings and ends

/// One end of a track.
typedef struct line_edge {
    bool there; ///< the line ends between two points; false: the sweep ends with the line, or there is no track
    size_t point, beyond; ///< rows: last one with the line, first one without it
    bool known, sudden;   ///< known: the edge could be judged; sudden: it is a jump
} line_edge;

static int found_by_size(const void *left, const void *right) {
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/// Judges whether a line begins suddenly: at its first point it is at least twice as large as the least visible size,
/// and about as large as at the next points. (A line that grows as the square root of the parameter has less than 0.64
/// of the median of the next two to four points.)
static void edge_judge(const line_side *side, const line_track *track, bool first, line_edge *edge) {
    enum { LOOKED_AT = 4, MIN_KNOWN = 2 };
    static const double least_ratio = 0.75, least_over = 2.0;
    double behind[LOOKED_AT];
    size_t count = 0;
    for (; count < LOOKED_AT && count < track->last - track->first; count++)
        behind[count] = side->seen[first ? track->first + 1 + count : track->last - 1 - count].size;
    edge->known = count >= MIN_KNOWN;
    if (!edge->known) return;
    qsort(behind, count, sizeof *behind, found_by_size);
    const double usual = 0.5 * (behind[(count - 1) / 2] + behind[count / 2]);
    const line_seen *own = &side->seen[edge->point];
    edge->sudden = own->over >= least_over * least_share && own->size >= least_ratio * usual;
}

/// Returns true if values rise from point to point of a branch; all branches have the same order.
static bool values_rise(const whirl_table *table) {
    for (size_t i = 0; i + 1 < table->count; i++)
        if (table->branch[i] == table->branch[i + 1]) return table->values[i + 1] > table->values[i];
    return true;
}

/// Returns true if the motion was followed along a track from lower to higher values. Branches from the last value on
/// go the other way.
static bool track_rises(const whirl_table *table, const line_track *track) {
    return values_rise(table) == (table->branch[track->first] >= 0);
}

/// Returns the end of a track at its lower values (`low`) or at its higher ones.
static line_edge edge_of(const finder *of, const line_side *side, const line_track *track, bool low) {
    const whirl_table *table = of->table;
    const bool first = low == values_rise(table);
    line_edge edge = {.point = first ? track->first : track->last};
    if (first ? edge.point == 0 : edge.point + 1 == table->count) return edge;
    edge.beyond = first ? edge.point - 1 : edge.point + 1;
    edge.there = whirl_table_done(table, edge.beyond) && table->branch[edge.beyond] == table->branch[edge.point] &&
                 !(side->seen[edge.beyond].size > 0.0);
    if (edge.there) edge_judge(side, track, first, &edge);
    return edge;
}

/// Returns true if two tracks are the same line on the way up and on the way down: at some values both exist, with
/// nearly the same order.
static bool tracks_match(const finder *of, const line_track *up, const line_track *down) {
    const double *values = of->table->values;
    const double a[] = {fmin(values[up->first], values[up->last]), fmax(values[up->first], values[up->last])};
    const double b[] = {fmin(values[down->first], values[down->last]), fmax(values[down->first], values[down->last])};
    const double order = up->largest.order;
    return a[0] <= b[1] && b[0] <= a[1] && fabs(down->largest.order - order) <= drift * order;
}

static void cells_edge(const finder *of, const line_side *side, whirl_sheet *sheet, const line_edge *edge) {
    const line_seen *line = &side->seen[edge->point];
    cell_number(of, sheet, edge->there ? of->table->values[edge->point] : (double)NAN);
    cell_text(of, sheet, !edge->there || !edge->known ? "" : edge->sudden ? "at once" : "gradually");
    cell_number(of, sheet, edge->there ? line->size : (double)NAN);
    cell_number(of, sheet, edge->there ? 100.0 * line->share : (double)NAN);
}

/// States an end of a line that is sudden or has a hysteresis of more than a step: "line of order 0.48: begins at once
/// at 5200 rpm on the way up, is there down to 4800 rpm on the way down: hysteresis of 400 rpm".
static void state_edge(const finder *of, double order, bool low, const line_edge *up, const line_edge *down) {
    const double *values = of->table->values;
    // Compare where the line begins on the way up with where it ends on the way down.
    const double apart = up->there && down->there ? fabs(values[up->point] - values[down->point]) : 0.0;
    const double step = up->there ? fabs(values[up->beyond] - values[up->point]) : 0.0;
    const bool hysteresis = apart > 1.01 * step;
    if (!hysteresis && !up->sudden && !down->sudden) return;
    bool ways = false;
    for (size_t i = 0; i < of->table->count; i++) ways = ways || of->table->branch[i] < 0;
    // State both values, if they are known.
    whirl_phrase *found = &find_statement(of, find_text(of->findings, "line of order %.4g", order))->found;
    if (up->there) {
        phrase_text(of, found, "%s%s at ", low ? "begins" : "ends", up->sudden ? " at once" : "");
        phrase_value(of, found, 6, values[up->point]);
        if (ways) phrase_text(of, found, " on the way up");
    }
    if (down->there) {
        phrase_text(of, found, "%s%s%s at ", up->there ? "; " : "", low ? "ends" : "begins",
                    down->sudden ? " at once" : "");
        phrase_value(of, found, 6, values[down->point]);
        if (ways) phrase_text(of, found, " on the way down");
    }
    // State the hysteresis.
    if (!hysteresis) return;
    phrase_text(of, found, ": hysteresis of ");
    phrase_value(of, found, 6, apart);
}

static void edge_row(const finder *of, const line_side *side, whirl_sheet *sheet, const line_track *up,
                     const line_track *down, bool low) {
    const line_edge none = {.there = false};
    const line_edge rising = up ? edge_of(of, side, up, low) : none,
                    falling = down ? edge_of(of, side, down, low) : none;
    if (!rising.there && !falling.there) return;
    const double order = side->seen[rising.there ? rising.point : falling.point].order;
    sheet_row(of, sheet);
    cell_number(of, sheet, order);
    cell_text(of, sheet, low ? "lower" : "upper");
    cells_edge(of, side, sheet, &rising);
    cells_edge(of, side, sheet, &falling);
    cell_number(of, sheet,
                rising.there && falling.there ? fabs(of->table->values[rising.point] - of->table->values[falling.point])
                                              : (double)NAN);
    state_edge(of, order, low, &rising, &falling);
}

/// Reports both ends of every line of a side, on the way up and on the way down.
static void find_edges(const finder *of, const line_side *side, whirl_sheet *sheet) {
    bool *taken = calloc(side->count + 1, sizeof *taken);
    if (!taken) of->findings->failed = true;
    for (size_t i = 0; i < side->count && taken; i++) {
        const line_track *up = &side->tracks[i], *down = NULL;
        if (!track_rises(of->table, up)) continue;
        for (size_t k = 0; k < side->count && !down; k++) {
            if (taken[k] || track_rises(of->table, &side->tracks[k]) || !tracks_match(of, up, &side->tracks[k]))
                continue;
            down = &side->tracks[k];
            taken[k] = true;
        }
        edge_row(of, side, sheet, up, down, true);
        edge_row(of, side, sheet, up, down, false);
    }
    for (size_t k = 0; k < side->count && taken; k++) {
        if (taken[k] || track_rises(of->table, &side->tracks[k])) continue;
        edge_row(of, side, sheet, NULL, &side->tracks[k], true);
        edge_row(of, side, sheet, NULL, &side->tracks[k], false);
    }
    free(taken);
}

// ---------------------------------------------------------------- jumps within a line, and to another one

/// A sudden change of a line's amplitude between neighbouring points, or of the strongest line to one of another order.
typedef struct line_jump {
    size_t before, after; ///< rows, in the direction in which the motion was followed
    bool rises;           ///< the motion was followed to higher values
    bool paired;          ///< reported together with the jump on the other way
    bool moves;           ///< the strongest line has another order after the jump
} line_jump;

/// A jump changes the amplitude by more than the share least_jump, and by more than least_jump_ratio times the median
/// of the steps around it. Near a fold the last step of a continuous branch is up to 4 times that median, as for jumps
/// of motions (jumps.c).
static const double least_jump = 0.1, least_jump_ratio = 8.0;

/// Returns the median change in up to four steps of a track on either side of the step from `at`; NaN if there are
/// fewer than four steps.
static double track_usual_step(const line_side *side, const line_track *track, size_t at) {
    enum { LOOKED_AT = 4 };
    double around[2 * LOOKED_AT];
    size_t count = 0;
    for (size_t i = track->first; i < track->last; i++)
        if (i != at && i + LOOKED_AT >= at && i <= at + LOOKED_AT)
            around[count++] = fabs(side->seen[i + 1].size - side->seen[i].size);
    if (count < LOOKED_AT) return (double)NAN;
    qsort(around, count, sizeof *around, found_by_size);
    return 0.5 * (around[(count - 1) / 2] + around[count / 2]);
}

/// Returns the size in m of the line nearest to an order at a station and a point; 0 without one.
static double size_near(const finder *of, size_t point, size_t station, double order) {
    const numbers lines = point_lines(of->table, point, station);
    double size = 0.0;
    for (size_t i = 0; i < lines.rows; i++) {
        const double *line = lines.at + i * lines.columns;
        if (fabs(line[0] - order) <= drift * order) size = fmax(size, line_of(of, point, station, line).size);
    }
    return size;
}

/// Returns true if the strongest line has another order at the next point because a line appears or vanishes, that is,
/// is less than half as large at the other point. Lines that only change their rank are about as large at both points.
static bool jump_moves(const finder *of, const line_side *side, size_t before, size_t after) {
    const line_seen *left = &side->seen[before], *right = &side->seen[after];
    return size_near(of, before, right->station, right->order) < 0.5 * right->size ||
           size_near(of, after, left->station, left->order) < 0.5 * left->size;
}

/// Finds the jumps within the tracks of a side and from each track to the next, jumps [at most the number of points];
/// returns their number.
static size_t jumps_find(const finder *of, const line_side *side, line_jump *jumps) {
    // Find jumps between neighbouring points of two tracks.
    size_t count = 0;
    for (const line_track *track = side->tracks; track + 1 < side->tracks + side->count; track++) {
        const size_t last = track->last, next = track[1].first;
        if (next != last + 1 || of->table->branch[next] != of->table->branch[last] ||
            whirl_table_slot(of->table, next) != whirl_table_slot(of->table, last) + 1)
            continue;
        const bool back = of->table->branch[last] < 0;
        if (!jump_moves(of, side, back ? next : last, back ? last : next)) continue;
        jumps[count++] = (line_jump){.before = back ? next : last,
                                     .after = back ? last : next,
                                     .rises = track_rises(of->table, track),
                                     .moves = true};
    }
    // Find jumps of the amplitude along a track.
    for (const line_track *track = side->tracks; track < side->tracks + side->count; track++)
        for (size_t i = track->first; i < track->last; i++) {
            const double a = side->seen[i].size, b = side->seen[i + 1].size, change = fabs(b - a);
            if (!(change > least_jump * fmax(a, b)) || !(change > least_jump_ratio * track_usual_step(side, track, i)))
                continue;
            const bool back = of->table->branch[i] < 0;
            jumps[count++] = (line_jump){
                .before = back ? i + 1 : i, .after = back ? i : i + 1, .rises = track_rises(of->table, track)};
        }
    return count;
}

static double jump_middle(const finder *of, const line_jump *jump) {
    return 0.5 * (of->table->values[jump->before] + of->table->values[jump->after]);
}

static bool jump_grows(const line_side *side, const line_jump *jump) {
    return side->seen[jump->after].size > side->seen[jump->before].size;
}

/// Returns true if two jumps to other orders are between the same orders, in opposite directions.
static bool jump_returns(const line_side *side, const line_jump *jump, const line_jump *other) {
    const double from = side->seen[jump->before].order, to = side->seen[jump->after].order;
    return jump->moves && other->moves && fabs(side->seen[other->after].order - from) <= drift * from &&
           fabs(side->seen[other->before].order - to) <= drift * to;
}

/// Returns the jump on the way down that corresponds to a jump on the way up: the nearest one. Either the order stays,
/// and one jump is from large to small, the other from small to large; or both jumps are between the same two orders,
/// in opposite directions. NULL without such a jump.
static line_jump *jump_partner(const finder *of, const line_side *side, const line_jump *up, line_jump *jumps,
                               size_t count) {
    const double order = side->seen[up->before].order;
    line_jump *best = NULL;
    for (line_jump *own = jumps; own < jumps + count; own++) {
        const bool alike = !own->moves && !up->moves && jump_grows(side, own) != jump_grows(side, up) &&
                           fabs(side->seen[own->before].order - order) <= drift * order;
        if (own->rises || own->paired || !(alike || jump_returns(side, up, own))) continue;
        const double apart = fabs(jump_middle(of, own) - jump_middle(of, up));
        if (!best || apart < fabs(jump_middle(of, best) - jump_middle(of, up))) best = own;
    }
    return best;
}

static void cells_jump(const finder *of, const line_side *side, whirl_sheet *sheet, const line_jump *jump) {
    cell_number(of, sheet, jump ? of->table->values[jump->before] : (double)NAN);
    cell_number(of, sheet, jump ? of->table->values[jump->after] : (double)NAN);
    cell_number(of, sheet, jump ? side->seen[jump->before].size : (double)NAN);
    cell_number(of, sheet, jump ? side->seen[jump->after].size : (double)NAN);
}

static void state_jump(const finder *of, const line_side *side, whirl_phrase *found, const line_jump *jump) {
    phrase_text(of, found, "jumps from ");
    phrase_number(of, found, WHIRL_QUANTITY_SIZE, 4, side->seen[jump->before].size);
    phrase_text(of, found, " to ");
    phrase_number(of, found, WHIRL_QUANTITY_SIZE, 4, side->seen[jump->after].size);
    if (jump->moves) phrase_text(of, found, " at order %.4g", side->seen[jump->after].order);
    phrase_text(of, found, " after ");
    phrase_value(of, found, 6, of->table->values[jump->before]);
    phrase_text(of, found, " on the way %s", jump->rises ? "up" : "down");
}

/// Adds a row and a statement for a jump. back: its partner on the way down, with which it has a hysteresis; NULL:
/// none.
static void jump_row(const finder *of, const line_side *side, whirl_sheet *sheet, const line_jump *jump,
                     const line_jump *back) {
    const double order = side->seen[jump->before].order;
    const double apart = back ? fabs(jump_middle(of, jump) - jump_middle(of, back)) : (double)NAN;
    sheet_row(of, sheet);
    cell_number(of, sheet, order);
    cells_jump(of, side, sheet, jump->rises ? jump : back);
    cells_jump(of, side, sheet, jump->rises ? back : jump);
    cell_number(of, sheet, apart);
    cell_number(of, sheet, side->seen[jump->after].order);
    whirl_phrase *found = &find_statement(of, find_text(of->findings, "line of order %.4g", order))->found;
    state_jump(of, side, found, jump);
    if (!back) return;
    phrase_text(of, found, "; ");
    state_jump(of, side, found, back);
    phrase_text(of, found, ": hysteresis of ");
    phrase_value(of, found, 6, apart);
}

static void find_jumps(const finder *of, const line_side *side, whirl_sheet *sheet) {
    line_jump *jumps = calloc(of->table->count + 1, sizeof *jumps);
    if (!jumps) of->findings->failed = true;
    const size_t count = jumps ? jumps_find(of, side, jumps) : 0;
    for (size_t i = 0; i < count; i++) {
        if (!jumps[i].rises) continue;
        line_jump *down = jump_partner(of, side, &jumps[i], jumps, count);
        if (down) down->paired = true;
        jump_row(of, side, sheet, &jumps[i], down);
    }
    for (size_t i = 0; i < count; i++)
        if (!jumps[i].rises && !jumps[i].paired) jump_row(of, side, sheet, &jumps[i], NULL);
    free(jumps);
}

/// Adds the columns of jumps on the way up or on the way down.
static void sheet_jump(const finder *of, whirl_sheet *sheet, const char *const keys[4]) {
    sheet_values(of, sheet, keys[0], 6);
    sheet_values(of, sheet, keys[1], 6);
    sheet_column(of, sheet, keys[2], "amplitude before", WHIRL_QUANTITY_SIZE, 4);
    sheet_column(of, sheet, keys[3], "after", WHIRL_QUANTITY_SIZE, 4);
}

// ---------------------------------------------------------------- locking

/// MAX_LOCKED: largest q of a ratio p/q. MIN_LOCKED: least number of consecutive points with it. locked: tolerance of
/// the order.
enum { MAX_LOCKED = 8, MIN_LOCKED = 3 };
static const double locked = 1e-3;

/// Returns the denominator q of the simplest ratio p/q equal to an order; 0 if there is none.
static int ratio_of(double order) {
    for (int q = 2; q <= MAX_LOCKED; q++)
        if (fabs(order - round(order * q) / q) <= locked && round(order * q) > 0.0) return q;
    return 0;
}

/// Returns the denominator of the ratio at a point, as ratio_of; 0 for quasi-periodic and chaotic motions, whose order
/// equals a ratio only by chance.
static int ratio_at(const finder *of, const line_side *side, size_t point) {
    const whirl_verdict verdict = whirl_table_verdict(of->table, point);
    const bool free = verdict.regime == WHIRL_QUASI_PERIODIC || verdict.regime == WHIRL_CHAOTIC;
    return free ? 0 : ratio_of(side->seen[point].order);
}

static void find_locking(const finder *of, const line_side *side, whirl_sheet *sheet) {
    for (const line_track *track = side->tracks; track < side->tracks + side->count; track++)
        for (size_t first = track->first, next = first; first <= track->last; first = next) {
            const int q = ratio_at(of, side, first);
            const double order = q ? round(side->seen[first].order * q) / q : 0.0;
            for (next = first + 1; next <= track->last && ratio_at(of, side, next) == q; next++)
                if (fabs(side->seen[next].order - order) > locked) break;
            if (q == 0 || next - first < MIN_LOCKED) continue;
            sheet_row(of, sheet);
            cell_text(of, sheet, find_text(of->findings, "%.0f/%d", round(order * q), q));
            cell_number(of, sheet, of->table->values[first]);
            cell_number(of, sheet, of->table->values[next - 1]);
            cell_text(of, sheet, of->table->branch[first] < 0 ? "on the way back" : "");
            cell_number(of, sheet, (double)(next - first));
        }
}

// ---------------------------------------------------------------- all

static void state_largest(const finder *of, const char *what, const line_track *most) {
    whirl_phrase *found = &find_statement(of, what)->found;
    if (!(most->largest.size > 0.0)) {
        phrase_text(of, found, "none of %g %% or more of the largest line", 100.0 * least_share);
        return;
    }
    phrase_text(of, found, "largest ");
    phrase_number(of, found, WHIRL_QUANTITY_SIZE, 4, most->largest.size);
    phrase_text(of, found, " at order %.4g of %s, %s = ", most->largest.order,
                of->result->stations[most->largest.station].name, of->table->parameter);
    phrase_value(of, found, 6, of->table->values[most->largest_at]);
    if (isfinite(most->largest.share))
        phrase_text(of, found, ", %.3g %% of its clearance", 100.0 * most->largest.share);
    phrase_text(of, found, "; from ");
    phrase_value(of, found, 6, of->table->values[most->first]);
    phrase_text(of, found, " to ");
    phrase_value(of, found, 6, of->table->values[most->last]);
}

static void find_tracks(const finder *of, const line_side *sides) {
    whirl_sheet *sheet = find_sheet(of, "lines", "Spectral lines other than the synchronous one and its multiples");
    sheet_values(of, sheet, "from", 6);
    sheet_values(of, sheet, "to", 6);
    sheet_texts(of, sheet, "way", "way");
    sheet_list(of, sheet, "order", "order", WHIRL_QUANTITY_NUMBER, 4, " to ");
    sheet_list(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 5, " to ");
    sheet_column(of, sheet, "amplitude", "largest amplitude", WHIRL_QUANTITY_SIZE, 4);
    sheet_texts(of, sheet, "station", "station");
    sheet_values(of, sheet, "at", 6);
    sheet_column(of, sheet, "share", "of the clearance", WHIRL_QUANTITY_PERCENT, 3);
    sheet_texts(of, sheet, "whirl", "whirl");
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0; i < sides[k].count; i++) track_row(of, sheet, &sides[k].tracks[i]);
    find_sheet_end(of);
}

/// Adds the columns of ends of lines on the way up or on the way down.
static void sheet_edge(const finder *of, whirl_sheet *sheet, const char *const keys[4], const char *const headings[3]) {
    sheet_values(of, sheet, keys[0], 6);
    sheet_texts(of, sheet, keys[1], headings[0]);
    sheet_column(of, sheet, keys[2], headings[1], WHIRL_QUANTITY_SIZE, 4);
    sheet_column(of, sheet, keys[3], headings[2], WHIRL_QUANTITY_PERCENT, 3);
}

static void find_line_sheets(const finder *of, const line_side *sides) {
    static const char *const up[] = {"up", "up_how", "up_amplitude", "up_share"};
    static const char *const down[] = {"down", "down_how", "down_amplitude", "down_share"};
    // Add the sheet of tracks, and state the largest line of each side.
    const line_track below = side_largest(&sides[0]), above = side_largest(&sides[1]);
    find_tracks(of, sides);
    state_largest(of, "sub-synchronous lines", &below);
    if (above.largest.size > 0.0) state_largest(of, "super-synchronous lines", &above);

    // Add the sheet of beginnings and ends.
    whirl_sheet *sheet = find_sheet(of, "line-edges", "Beginnings and ends of these lines");
    sheet->about = "The last value with the line, on the way up and on the way down; at once: the amplitude "
                   "jumps to that of the neighbouring points with the line.";
    sheet_column(of, sheet, "order", "order", WHIRL_QUANTITY_NUMBER, 4);
    sheet_texts(of, sheet, "end", "end");
    sheet_edge(of, sheet, up, (const char *const[]){"how", "amplitude", "of the clearance"});
    sheet_edge(of, sheet, down, (const char *const[]){"how", "amplitude", "of the clearance"});
    sheet_values(of, sheet, "hysteresis", 6);
    for (size_t k = 0; k < 2; k++) find_edges(of, &sides[k], sheet);
    find_sheet_end(of);

    // Add the sheet of jumps.
    static const char *const jump_up[] = {"up", "up_to", "up_before", "up_after"};
    static const char *const jump_down[] = {"down", "down_to", "down_before", "down_after"};
    sheet = find_sheet(of, "line-jumps", "Jumps of the amplitudes of these lines");
    sheet->about = "Values before and after a jump, on the way up and on the way down. A jump is over 10 % of the "
                   "amplitude and 8 times the usual change from point to point; or the strongest line has another "
                   "order, and one of both more than doubles.";
    sheet_column(of, sheet, "order", "order", WHIRL_QUANTITY_NUMBER, 4);
    sheet_jump(of, sheet, jump_up);
    sheet_jump(of, sheet, jump_down);
    sheet_values(of, sheet, "hysteresis", 6);
    sheet_column(of, sheet, "order_after", "order after", WHIRL_QUANTITY_NUMBER, 4);
    for (size_t k = 0; k < 2; k++) find_jumps(of, &sides[k], sheet);
    find_sheet_end(of);

    // Add the sheet of locked lines.
    sheet = find_sheet(of, "locking", "Lines locked at a ratio of the speed");
    sheet->about = "At three or more points in a row the order is the ratio to 0.001, and no motion is quasi-periodic.";
    sheet_texts(of, sheet, "ratio", "ratio");
    sheet_values(of, sheet, "from", 6);
    sheet_values(of, sheet, "to", 6);
    sheet_texts(of, sheet, "way", "way");
    sheet_column(of, sheet, "points", "points", WHIRL_QUANTITY_NUMBER, 6);
    for (size_t k = 0; k < 2; k++) find_locking(of, &sides[k], sheet);
    find_sheet_end(of);
}

void find_lines(const finder *of) {
    const bool along = of->table->role == WHIRL_ROLE_SURVEY || of->table->role == WHIRL_ROLE_MOTIONS;
    if (!along || of->table->count < 2 || !*of->table->parameter ||
        !whirl_layout_field(&of->table->layout, WHIRL_FIELD_SPECTRUM_LINES))
        return;
    line_side sides[2];
    const bool below = side_find(of, true, &sides[0]), above = side_find(of, false, &sides[1]);
    if (below && above)
        find_line_sheets(of, sides);
    else
        of->findings->failed = true;
    side_free(&sides[0]);
    side_free(&sides[1]);
}
