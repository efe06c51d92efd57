// What is found of spectra along a parameter: lines below and above the synchronous one, from where to where they are
// there, with what they take of clearances.
#include <math.h>

#include "quantities.h"
#include "shown_kinds.h"

/// A line counts from this share of the largest one of its station on.
static const double least_share = 0.05;

/// Of more points a line is one of several neighbours: at single ones among chaotic motions it is none.
enum { FEW_POINTS = 8 };

/// Orders that are one multiple of the speed to a reader of spectra; and how much an order drifts from point to point.
static const double multiple = 0.02, drift = 0.1;

/// The strongest line of a point on one side of the synchronous one.
typedef struct line_seen {
    size_t station;
    double order, size; ///< size in m, zero to peak, along the axis where it is larger; 0: there is none
    double share;       ///< of the clearance there; NaN where there is none
    double direction;   ///< 1: forward, -1: backward
} line_seen;

/// Of a line and all that is around its station.
static line_seen line_of(const finder *of, size_t point, size_t station, const double *line) {
    const whirl_probe *around = &of->result->stations[station];
    const double largest = fmax(line[1], line[2]), clearance = around->gap > 0.0 ? around->gap : around->clearance;
    return (line_seen){.station = station,
                       .order = line[0],
                       .size = largest * whirl_result_length_scale(of->result, of->table, point),
                       .share = clearance > 0.0 ? largest / clearance : (double)NAN,
                       .direction = (line[3] - line[4]) / fmax(line[3] + line[4], 1e-300)};
}

/// Below the synchronous line, or above it and no multiple of it.
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
            const line_seen own = line_of(of, point, station, line);
            if (own.size > best.size) best = own;
        }
    }
    return best;
}

/// Neighbouring points at which a line is there, whose order hardly changes from one to the next.
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

/// All lines on one side, a row each; the one that is largest.
static line_track find_side(const finder *of, whirl_sheet *sheet, bool below) {
    line_track track = {.largest = {.size = 0.0}}, most = track;
    bool open = false;
    for (size_t point = 0; point <= of->table->count; point++) {
        const bool done = point < of->table->count && whirl_table_done(of->table, point);
        const line_seen line = done ? strongest_line(of, point, below) : (line_seen){.size = 0.0};
        const bool there = line.size > 0.0;
        if (open && !(there && track_goes_on(of, &track, point, &line))) {
            const bool told = track.last > track.first || of->table->count <= FEW_POINTS;
            if (told) track_row(of, sheet, &track);
            if (told && track.largest.size > most.largest.size) most = track;
            open = false;
        }
        if (!there) continue;
        if (!open) track = (line_track){.first = point, .from = line, .largest = {.size = 0.0}};
        open = true;
        track.last = point;
        track.to = line;
        if (line.size > track.largest.size) track.largest = line, track.largest_at = point;
    }
    return most;
}

static void tell_largest(const finder *of, const char *what, const line_track *most) {
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

void find_lines(const finder *of) {
    const bool along = of->table->role == WHIRL_ROLE_SURVEY || of->table->role == WHIRL_ROLE_MOTIONS;
    if (!along || of->table->count < 2 || !*of->table->parameter ||
        !whirl_layout_field(&of->table->layout, WHIRL_FIELD_SPECTRUM_LINES))
        return;
    whirl_sheet *sheet = find_sheet(of, "lines", "Lines of spectra beside the synchronous one and its multiples");
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
    const line_track below = find_side(of, sheet, true), above = find_side(of, sheet, false);
    find_sheet_end(of);
    tell_largest(of, "sub-synchronous lines", &below);
    if (above.largest.size > 0.0) tell_largest(of, "super-synchronous lines", &above);
}
