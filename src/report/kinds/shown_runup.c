// Findings on run-ups: course and end of a run, largest motions of stations, contacts.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "shown_kinds.h"

/// Words for the end of a run (runup/end).
static const char *const ends[] = {"as planned", "the shaft stood still", "the motion left all bounds",
                                   "the solver could not go on"};

static const double *runup_numbers_of(const finder *of, size_t point, const char *field, size_t which) {
    return whirl_table_done(of->table, point) ? whirl_table_field(of->table, point, field, which) : NULL;
}

static double runup_number_of(const finder *of, size_t point, const char *field, size_t which) {
    return whirl_table_number(of->table, point, field, which);
}

static const char *runup_ended(double end) {
    return end >= 0.0 && end < sizeof ends / sizeof *ends ? ends[(size_t)end] : "";
}

/// Adds a statement for every run that did not end as planned.
static void runup_find_failures(const finder *of) {
    for (size_t point = 0; point < of->table->count; point++) {
        const double end = runup_number_of(of, point, WHIRL_FIELD_RUNUP_END, 0);
        if (!whirl_table_done(of->table, point) || !(end > 0.0)) continue;
        whirl_statement *own = find_judgement(of, "run", "", WHIRL_NOT_KNOWN);
        statement_value(of, own, point);
        phrase_text(of, &own->asked, "runs to its end");
        phrase_text(of, &own->found, "%s at ", runup_ended(end));
        phrase_number(of, &own->found, WHIRL_QUANTITY_TIME, 6,
                      runup_number_of(of, point, WHIRL_FIELD_RUNUP_END_TIME, 0));
        phrase_text(of, &own->found, " after %.6g turns of the shaft",
                    runup_number_of(of, point, WHIRL_FIELD_RUNUP_END_TURNS, 0));
        phrase_text(of, &own->judged, " beyond");
    }
}

static void runup_find_error(const finder *of) {
    double error = 0.0;
    for (size_t point = 0; point < of->table->count; point++) {
        const double own = runup_number_of(of, point, WHIRL_FIELD_RUNUP_ERROR, 0);
        if (own > error) error = own;
    }
    if (error > 0.0)
        phrase_text(of, &find_statement(of, "coefficients over the speed")->found,
                    "err by up to %.2g of the largest between the speeds at which they were taken", error);
}

/// Adds a statement for every run whose motion is sensitive to rounding errors after some time.
static void runup_find_sensitivity(const finder *of) {
    if (!whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_SENSITIVITY)) return;
    for (size_t point = 0; point < of->table->count; point++) {
        const double *own = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_SENSITIVITY, 0);
        if (!own || isnan(own[3])) continue;
        whirl_phrase *found = find_at(of, point, "sensitive");
        phrase_text(of, found, "small changes grow by 1e%.0f from ", own[0] / log(10.0));
        phrase_number(of, found, WHIRL_QUANTITY_TIME, 6, own[1]);
        phrase_text(of, found, " to ");
        phrase_number(of, found, WHIRL_QUANTITY_TIME, 6, own[2]);
        phrase_text(of, found, ": from ");
        phrase_number(of, found, WHIRL_QUANTITY_TIME, 6, own[3]);
        phrase_text(of, found, " on, numbers of contacts and positions hold for this tolerance alone");
    }
}

/// Adds a statement for stations and runs whose slow roll was not subtracted from the motion.
static void runup_find_slow_roll(const finder *of) {
    const double speed = of->table->record.runup.slow_roll;
    if (!whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_SLOW_ROLL)) return;
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count && whirl_table_done(of->table, point); station++) {
            const double change = runup_number_of(of, point, WHIRL_FIELD_RUNUP_SLOW_ROLL_CHANGE, station);
            if (change <= WHIRL_MAX_SLOW_ROLL_CHANGE || of->result->stations[station].twists) continue;
            whirl_phrase *found = find_at(of, point, "slow roll");
            phrase_text(of, found, "of %s at ", of->result->stations[station].name);
            phrase_number(of, found, WHIRL_QUANTITY_SPEED, 6, speed);
            if (isnan(change))
                phrase_text(of, found, " is not subtracted: the run has no such speed");
            else
                phrase_text(of, found,
                            " is not subtracted: the motion at 1X changes there by %.2g %% of its largest within 10 %% "
                            "of the speed, expected at most 5 %%",
                            100.0 * change);
        }
}

static void runup_find_runs(const finder *of) {
    whirl_sheet *sheet = find_sheet(of, "runs", "Runs");
    sheet_values(of, sheet, "", 6);
    sheet_column(of, sheet, "time", "ended at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "speed", "speed there", WHIRL_QUANTITY_SPEED, 6);
    sheet_column(of, sheet, "turns", "turns", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "end", "ended");
    for (size_t point = 0; point < of->table->count; point++) {
        if (!runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_END_TIME, 0)) continue;
        sheet_row(of, sheet);
        cell_value(of, sheet, point);
        cell_number(of, sheet, runup_number_of(of, point, WHIRL_FIELD_RUNUP_END_TIME, 0));
        cell_number(of, sheet, runup_number_of(of, point, WHIRL_FIELD_RUNUP_END_SPEED, 0));
        cell_number(of, sheet, runup_number_of(of, point, WHIRL_FIELD_RUNUP_END_TURNS, 0));
        cell_text(of, sheet, runup_ended(runup_number_of(of, point, WHIRL_FIELD_RUNUP_END, 0)));
    }
    find_sheet_end(of);
}

/// Adds the sheet of shafts with a speed of their own: where they end, and the largest motions at their speeds.
static void runup_find_shafts(const finder *of) {
    const whirl_field *shafts = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_SHAFT_END);
    const whirl_field *amplitudes = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_SHAFT_AMPLITUDE);
    if (!shafts || !amplitudes) return;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "shafts", "Other shafts of a run");
    sheet->about = "Shafts with a speed of their own: speed and turns at the end of the run, and the largest amplitude "
                   "at 1X of the shaft at a station, of x or y, with the speed of the shaft there.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "shaft", "shaft");
    sheet_column(of, sheet, "speed", "speed at the end", WHIRL_QUANTITY_SPEED, 6);
    sheet_column(of, sheet, "turns", "turns", WHIRL_QUANTITY_NUMBER, 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "amplitude", "largest 1X", WHIRL_QUANTITY_LENGTH, 5);
    sheet_column(of, sheet, "amplitude_speed", "at", WHIRL_QUANTITY_SPEED, 6);
    // Add a row for each shaft of each run.
    const size_t rows = amplitudes->rows / shafts->rows;
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t k = 0; k < shafts->rows; k++) {
            const double *end = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_SHAFT_END, 0);
            const double *speeds = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_SHAFT_SPEED, 0);
            double largest = NAN, at = NAN;
            char name[WHIRL_NAME_SIZE];
            size_t which = 0;
            if (!end || isnan(end[2 * k])) continue;
            for (size_t station = 0; station < of->result->station_count; station++) {
                const double *own = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_SHAFT_AMPLITUDE, station);
                for (size_t row = k * rows; own && row < (k + 1) * rows; row++)
                    for (size_t axis = 0; axis < 2; axis++) {
                        const double size = own[row * amplitudes->columns + axis];
                        if (!isfinite(size) || size <= largest) continue;
                        largest = size;
                        at = speeds[row];
                        which = station;
                    }
            }
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            whirl_runup_shaft_name(&of->table->record.runup, k, name);
            cell_text(of, sheet, find_text(of->findings, "%s", name));
            cell_number(of, sheet, end[2 * k]);
            cell_number(of, sheet, end[2 * k + 1]);
            cell_text(of, sheet, isnan(largest) ? "" : of->result->stations[which].name);
            cell_number(of, sheet, whirl_result_length_scale(of->result, of->table, point) * largest);
            cell_number(of, sheet, at);
        }
    find_sheet_end(of);
}

/// Writes the effects of an event: "motor lost, blade lost at fan", "motor of core lost".
static void runup_say_event(const finder *of, const double *event, char *text, size_t size) {
    const bool named = event[3] >= 0.0 && event[3] < (double)of->result->station_count;
    const whirl_runup_options *options = &of->table->record.runup;
    char shaft[WHIRL_NAME_SIZE], motor[WHIRL_NAME_SIZE + 16] = "motor lost";
    if (event[2] > 1.0 && event[2] <= 1.0 + (double)options->shaft_count) {
        whirl_runup_shaft_name(options, (size_t)event[2] - 2, shaft);
        snprintf(motor, sizeof motor, "motor of %s lost", shaft);
    }
    const char *const parts[] = {event[2] > 0.0 ? motor : "", named ? "blade lost at " : "",
                                 event[6] > 0.0 ? "parameters change" : "", event[7] > 0.0 ? "run ends" : ""};
    size_t used = 0;
    text[0] = '\0';
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        if (!*parts[i]) continue;
        snprintf(text + used, size - used, "%s%s%s", used ? ", " : "", parts[i],
                 i == 1 ? of->result->stations[(size_t)event[3]].name : "");
        used = strlen(text);
    }
    if (used == 0) snprintf(text, size, "condition for other events");
}

/// Adds the sheet of events of all runs, in the order of the case, with events that did not happen.
static void runup_find_events(const finder *of) {
    enum { COLUMNS = 8 };
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_HAPPENED);
    if (!rows) return;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "events", "Events of a run");
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "event", "event");
    sheet_column(of, sheet, "time", "at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    // Add a row for each event of each run; a row without a kind is unused.
    for (size_t point = 0; point < of->table->count; point++) {
        const double *events = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_HAPPENED, 0);
        for (size_t row = 0; events && row < rows->rows; row++) {
            const double *own = events + COLUMNS * row;
            char text[WHIRL_NAME_SIZE + 80];
            if (isnan(own[2])) continue;
            runup_say_event(of, own, text, sizeof text);
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_text(of, sheet, find_text(of->findings, isnan(own[0]) ? "%s (did not happen)" : "%s", text));
            for (size_t i = 0; i < 2; i++) cell_number(of, sheet, own[i]);
        }
    }
    find_sheet_end(of);
}

static void runup_find_peaks(const finder *of) {
    whirl_sheet *sheet = find_sheet(of, "peaks", "Largest motions of a run");
    sheet->about = "The largest distance of a station from the centre, when, and at which speed of the shaft.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "radius", "largest radius", WHIRL_QUANTITY_LENGTH, 5);
    sheet_column(of, sheet, "time", "at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double peak = runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK, station);
            const double time = runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK_TIME, station);
            if (!whirl_table_done(of->table, point) || isnan(time) || of->result->stations[station].twists) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_station(of, sheet, station);
            cell_number(of, sheet, whirl_result_length_scale(of->result, of->table, point) * peak);
            cell_number(of, sheet, time);
            cell_number(of, sheet, runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK_SPEED, station));
        }
    find_sheet_end(of);
}

/// Motions of stations besides x and y: fields of their extremes in a run, and the words of their sheets.
static const struct {
    const char *extreme, *time, *speed, *sheet, *title, *about;
    whirl_quantity quantity;
    bool twists;
} runup_extras[] = {
    {WHIRL_FIELD_RUNUP_AXIAL_EXTREME, WHIRL_FIELD_RUNUP_AXIAL_TIME, WHIRL_FIELD_RUNUP_AXIAL_SPEED, "axial",
     "Axial displacements in a run",
     "The least and the largest displacement of a station along its shaft, in the direction of growing positions, "
     "when, and at which speed of the shaft.",
     WHIRL_QUANTITY_LENGTH, false},
    {WHIRL_FIELD_RUNUP_TWIST_EXTREME, WHIRL_FIELD_RUNUP_TWIST_TIME, WHIRL_FIELD_RUNUP_TWIST_SPEED, "turned",
     "Twists in a run",
     "The least and the largest twist of a station that also moves along x and y, from x towards y and relative to the "
     "mean turn, when, and at which speed of the shaft.",
     WHIRL_QUANTITY_DEGREES, true}};

/// Returns the factor from such a motion in a result to what is shown.
static double runup_extra_factor(const finder *of, size_t point, bool twists) {
    return twists ? 180.0 / acos(-1.0) : whirl_result_length_scale(of->result, of->table, point);
}

/// Adds the sheet of the extremes of axial displacements, or of twists.
static void runup_find_extra(const finder *of, size_t kind) {
    if (!whirl_layout_field(&of->table->layout, runup_extras[kind].extreme)) return;
    // Set up the columns.
    const whirl_quantity quantity = runup_extras[kind].quantity;
    whirl_sheet *sheet = find_sheet(of, runup_extras[kind].sheet, runup_extras[kind].title);
    sheet->about = runup_extras[kind].about;
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "station", "station");
    sheet_column(of, sheet, "least", "least", quantity, 5);
    sheet_column(of, sheet, "least_time", "at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "least_speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_column(of, sheet, "largest", "largest", quantity, 5);
    sheet_column(of, sheet, "largest_time", "at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "largest_speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    // Add a row for each station of each run that moves so.
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double *extreme = runup_numbers_of(of, point, runup_extras[kind].extreme, station);
            const double *time = runup_numbers_of(of, point, runup_extras[kind].time, station);
            const double *speed = runup_numbers_of(of, point, runup_extras[kind].speed, station);
            if (!extreme || !time || !speed || isnan(extreme[0])) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_station(of, sheet, station);
            for (size_t side = 0; side < 2; side++) {
                cell_number(of, sheet, runup_extra_factor(of, point, runup_extras[kind].twists) * extreme[side]);
                cell_number(of, sheet, time[side]);
                cell_number(of, sheet, speed[side]);
            }
        }
    find_sheet_end(of);
}

/// Names the place, the time and the speed of a largest value.
static void runup_phrase_when(const finder *of, whirl_phrase *found, size_t station, double time, double speed) {
    phrase_text(of, found, " at %s, at ", of->result->stations[station].name);
    phrase_number(of, found, WHIRL_QUANTITY_TIME, 6, time);
    phrase_text(of, found, " and ");
    phrase_number(of, found, WHIRL_QUANTITY_SPEED, 6, speed);
}

/// States the largest motion of all stations and runs.
static void runup_find_largest_motion(const finder *of) {
    double largest = -1.0;
    size_t at = 0, which = 0;
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count; station++) {
            const double peak = runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK, station) *
                                whirl_result_length_scale(of->result, of->table, point);
            if (!whirl_table_done(of->table, point) || of->result->stations[station].twists || !(peak > largest))
                continue;
            largest = peak;
            at = point;
            which = station;
        }
    if (largest < 0.0) return;
    whirl_phrase *found = find_at(of, at, "largest motion");
    phrase_number(of, found, WHIRL_QUANTITY_LENGTH, 5, largest);
    phrase_text(of, found, " from the centre");
    runup_phrase_when(of, found, which, runup_number_of(of, at, WHIRL_FIELD_RUNUP_PEAK_TIME, which),
                      runup_number_of(of, at, WHIRL_FIELD_RUNUP_PEAK_SPEED, which));
}

/// States the largest axial displacement, or the largest twist, in either direction, of all stations and runs.
static void runup_find_largest_extra(const finder *of, size_t kind) {
    double largest = 0.0, time = NAN, speed = NAN;
    size_t at = 0, which = 0;
    bool any = false;
    for (size_t point = 0; point < of->table->count; point++)
        for (size_t station = 0; station < of->result->station_count && whirl_table_done(of->table, point); station++) {
            const double *extreme = runup_numbers_of(of, point, runup_extras[kind].extreme, station);
            const double factor = runup_extra_factor(of, point, runup_extras[kind].twists);
            for (size_t side = 0; side < 2 && extreme; side++) {
                if (isnan(extreme[side]) || (any && !(fabs(factor * extreme[side]) > fabs(largest)))) continue;
                largest = factor * extreme[side];
                time = runup_numbers_of(of, point, runup_extras[kind].time, station)[side];
                speed = runup_numbers_of(of, point, runup_extras[kind].speed, station)[side];
                at = point, which = station, any = true;
            }
            // The twist of a station that moves no other way is that of a point 1 m from the axis.
            const double peak = runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK, station) *
                                whirl_result_length_scale(of->result, of->table, point) * 180.0 / acos(-1.0);
            if (!runup_extras[kind].twists || !of->result->stations[station].twists || !(peak > fabs(largest)))
                continue;
            largest = peak;
            time = runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK_TIME, station);
            speed = runup_number_of(of, point, WHIRL_FIELD_RUNUP_PEAK_SPEED, station);
            at = point, which = station, any = true;
        }
    if (!any) return;
    whirl_phrase *found = find_at(of, at, runup_extras[kind].twists ? "largest twist" : "largest axial displacement");
    phrase_number(of, found, runup_extras[kind].quantity, 5, largest);
    runup_phrase_when(of, found, which, time, speed);
}

/// Returns the largest normal force of a contact over all instants of a run, N.
static double runup_largest_force(const finder *of, size_t point, size_t contact, size_t rows) {
    const double *force = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_FORCE, contact);
    double largest = 0.0;
    for (size_t row = 0; force && row < rows; row++) largest = fmax(largest, force[row]);
    return of->result->force_scale * largest;
}

/// States for each contact how often it closes in the run in which its force is largest.
static void runup_find_touches(const finder *of) {
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_FORCE);
    for (size_t c = 0; c < of->result->contact_count && rows; c++) {
        // Find the run with the largest force of the contact.
        double largest = -1.0;
        size_t at = 0;
        for (size_t point = 0; point < of->table->count; point++) {
            const double force = runup_largest_force(of, point, c, rows->rows);
            if (isnan(runup_number_of(of, point, WHIRL_FIELD_RUNUP_CONTACT_NUMBER, c)) || !(force > largest)) continue;
            largest = force;
            at = point;
        }
        if (largest < 0.0) continue;
        // State how often the contact closes in that run, when first, and its force.
        whirl_phrase *found = find_at(of, at, find_text(of->findings, "%s", of->result->contacts[c]));
        const double count = runup_number_of(of, at, WHIRL_FIELD_RUNUP_CONTACT_NUMBER, c);
        if (!(count > 0.0)) {
            phrase_text(of, found, "does not close");
            continue;
        }
        phrase_text(of, found, "closes %.6g %s, first at ", count, count == 1.0 ? "time" : "times");
        phrase_number(of, found, WHIRL_QUANTITY_TIME, 6, *runup_numbers_of(of, at, WHIRL_FIELD_RUNUP_CONTACT, c));
        phrase_text(of, found, ", with up to ");
        phrase_number(of, found, WHIRL_QUANTITY_FORCE, 5, largest);
    }
}

/// States the torque with the largest absolute value, of motors and between twists.
static void runup_find_largest_torque(const finder *of) {
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    const double *own = NULL, *of_what = NULL;
    size_t at = 0;
    // Find the largest extreme of all torques and runs.
    for (size_t point = 0; rows && point < of->table->count; point++) {
        const double *names = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
        const double *extremes = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_EXTREME, 0);
        for (size_t row = 0; names && extremes && row < 2 * rows->rows; row++) {
            const double *extreme = extremes + 2 * row;
            if (isnan(names[3 * (row / 2)]) || (own && !(fabs(*extreme) > fabs(*own)))) continue;
            own = extreme;
            of_what = names + 3 * (row / 2);
            at = point;
        }
    }
    if (!own) return;
    // State it.
    char name[2 * WHIRL_NAME_SIZE + 40];
    torque_name(of->result, of_what, name, sizeof name);
    whirl_phrase *found = find_at(of, at, "largest torque");
    phrase_number(of, found, WHIRL_QUANTITY_MOMENT, 6, own[0]);
    phrase_text(of, found, ", %s, at ", name);
    phrase_number(of, found, WHIRL_QUANTITY_TIME, 6, own[1]);
}

static void runup_find_contacts(const finder *of) {
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "contacts", "Contacts of a run");
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "contact", "contact");
    sheet_column(of, sheet, "count", "times closed", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "first", "first at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "last", "opened last at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "time", "closed for", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "force", "largest normal force", WHIRL_QUANTITY_FORCE, 5);
    // Add a row for each contact of each run, with its largest force over all instants.
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_FORCE);
    for (size_t point = 0; point < of->table->count && rows; point++)
        for (size_t c = 0; c < of->result->contact_count; c++) {
            const double *own = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_CONTACT, c);
            const double count = runup_number_of(of, point, WHIRL_FIELD_RUNUP_CONTACT_NUMBER, c);
            if (!own || isnan(count)) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_text(of, sheet, of->result->contacts[c]);
            cell_number(of, sheet, count);
            for (size_t i = 0; i < 3; i++) cell_number(of, sheet, own[i]);
            cell_number(of, sheet, runup_largest_force(of, point, c, rows->rows));
        }
    find_sheet_end(of);
}

/// Adds the sheet of the extremes of torques, of motors and between twists.
static void runup_find_torques(const finder *of) {
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    if (!rows) return;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "torques", "Torques of a run");
    sheet->about =
        "Torques of motors on their stations and of shafts and meshes between stations that twist, positive where "
        "they drive; the largest and the least instant of the run.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "torque", "torque");
    sheet_column(of, sheet, "largest", "largest", WHIRL_QUANTITY_MOMENT, 6);
    sheet_column(of, sheet, "largest_time", "at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "least", "least", WHIRL_QUANTITY_MOMENT, 6);
    sheet_column(of, sheet, "least_time", "at", WHIRL_QUANTITY_TIME, 6);
    sheet_column(of, sheet, "open", "without contact", WHIRL_QUANTITY_PERCENT, 4);
    // Add a row for each torque of each run.
    for (size_t point = 0; point < of->table->count; point++) {
        const double *names = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
        const double *extremes = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_EXTREME, 0);
        for (size_t row = 0; names && extremes && row < rows->rows; row++) {
            char name[2 * WHIRL_NAME_SIZE + 40];
            if (isnan(names[3 * row])) continue;
            torque_name(of->result, names + 3 * row, name, sizeof name);
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_text(of, sheet, find_text(of->findings, "%s", name));
            for (size_t i = 0; i < 4; i++) cell_number(of, sheet, extremes[4 * row + i]);
            cell_number(of, sheet, 100.0 * whirl_table_field(of->table, point, WHIRL_FIELD_RUNUP_OPEN, 0)[row]);
        }
    }
    find_sheet_end(of);
}

/// Adds the sheet of cycles of torques between twists, counted by rain flow: the largest classes that have cycles.
static void runup_find_cycles(const finder *of) {
    enum { CLASSES_SHOWN = 8 };
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_CYCLES);
    const whirl_field *torques = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    if (!rows || !torques || torques->rows == 0) return;
    const size_t classes = rows->rows / torques->rows;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "cycles", "Cycles of torques between twists");
    sheet->about = "Counted by rain flow (ASTM E1049) in 32 classes of their ranges, peak to peak; the largest classes "
                   "with cycles.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "torque", "torque");
    sheet_column(of, sheet, "range", "range up to", WHIRL_QUANTITY_MOMENT, 6);
    sheet_column(of, sheet, "number", "cycles", WHIRL_QUANTITY_NUMBER, 6);
    // Add the largest classes that have cycles, of torques between twists and of meshes.
    for (size_t point = 0; point < of->table->count; point++) {
        const double *names = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
        const double *cycles = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_CYCLES, 0);
        for (size_t t = 0; names && cycles && t < torques->rows; t++) {
            char name[2 * WHIRL_NAME_SIZE + 40];
            size_t shown = 0;
            if (names[3 * t] != WHIRL_TORQUE_BETWEEN && names[3 * t] < WHIRL_TORQUE_MESH) continue;
            torque_name(of->result, names + 3 * t, name, sizeof name);
            for (size_t k = classes; k-- > 0 && shown < CLASSES_SHOWN;) {
                const double *own = cycles + 2 * (t * classes + k);
                if (!(own[1] > 0.0)) continue;
                shown++;
                sheet_row(of, sheet);
                cell_value(of, sheet, point);
                cell_text(of, sheet, find_text(of->findings, "%s", name));
                for (size_t i = 0; i < 2; i++) cell_number(of, sheet, own[i]);
            }
        }
    }
    find_sheet_end(of);
}

/// States torques whose cycles were not counted because there were too many.
static void runup_find_uncounted(const finder *of) {
    const whirl_field *torques = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_TORQUE_OF);
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_CYCLES);
    for (size_t point = 0; torques && rows && point < of->table->count; point++) {
        const double *names = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
        const double *cycles = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_CYCLES, 0);
        const double *extremes = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_EXTREME, 0);
        for (size_t t = 0; names && cycles && extremes && t < torques->rows; t++) {
            char name[2 * WHIRL_NAME_SIZE + 40];
            if (!isnan(cycles[2 * t * (rows->rows / torques->rows)]) || !(extremes[4 * t] > extremes[4 * t + 2]))
                continue;
            torque_name(of->result, names + 3 * t, name, sizeof name);
            whirl_phrase *found = find_at(of, point, "cycles");
            phrase_text(of, found,
                        "of %s are not counted: the run has more than 4000000 turning points of this "
                        "torque, expected a shorter run",
                        name);
        }
    }
}

/// Adds the sheet of damage by Miner's sum, for torques with an S-N curve.
static void runup_find_damage(const finder *of) {
    const whirl_field *torques = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_DAMAGE);
    if (!torques) return;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "fatigue", "Fatigue by the torques of a run");
    sheet->about = "Miner's sum over the S-N curve of the case, without a correction for the mean; failure is expected "
                   "where the sum of all runs is 1.";
    sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "torque", "torque");
    sheet_column(of, sheet, "damage", "damage of a run", WHIRL_QUANTITY_NUMBER, 5);
    sheet_column(of, sheet, "runs", "runs to failure", WHIRL_QUANTITY_NUMBER, 5);
    sheet_texts(of, sheet, "remark", "remark");
    // Add a row for each torque with an S-N curve; a sum is unknown if a range is above the curve.
    for (size_t point = 0; point < of->table->count; point++) {
        const double *names = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_TORQUE_OF, 0);
        const double *damage = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_DAMAGE, 0);
        for (size_t t = 0; names && damage && t < torques->rows; t++) {
            char name[2 * WHIRL_NAME_SIZE + 40];
            const double sum = damage[2 * t];
            if (isnan(damage[2 * t + 1])) continue;
            torque_name(of->result, names + 3 * t, name, sizeof name);
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_text(of, sheet, find_text(of->findings, "%s", name));
            cell_number(of, sheet, sum);
            cell_number(of, sheet, sum > 0.0 ? 1.0 / sum : (double)NAN);
            cell_text(of, sheet,
                      damage[2 * t + 1] > 0.0 ? "ranges above the S-N curve"
                      : sum > 0.0             ? sum >= 1.0 ? "fails in one run" : ""
                                              : "no damage");
        }
    }
    find_sheet_end(of);
}

/// States the largest damage of a torque in a run.
static void runup_find_worst_damage(const finder *of) {
    const whirl_field *torques = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_DAMAGE);
    // Find the largest damage; a torque with ranges above its curve counts as the largest.
    double largest = -1.0;
    size_t at = 0, which = 0;
    for (size_t point = 0; torques && point < of->table->count; point++) {
        const double *damage = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_DAMAGE, 0);
        for (size_t t = 0; damage && t < torques->rows; t++) {
            const double own = damage[2 * t + 1] > 0.0 ? (double)INFINITY : damage[2 * t];
            if (own > largest) largest = own, at = point, which = t;
        }
    }
    if (largest < 0.0) return;
    // State what it means for the number of runs.
    char name[2 * WHIRL_NAME_SIZE + 40];
    torque_name(of->result, runup_numbers_of(of, at, WHIRL_FIELD_RUNUP_TORQUE_OF, 0) + 3 * which, name, sizeof name);
    whirl_phrase *found = find_at(of, at, "fatigue");
    if (!isfinite(largest))
        phrase_text(of, found, "not known for %s: ranges of its torque are above its S-N curve", name);
    else if (largest > 0.0)
        phrase_text(of, found, "%s fails after %.4g such runs (Miner's sum of one: %.4g)", name, 1.0 / largest,
                    largest);
    else
        phrase_text(of, found, "no damage: all ranges of torques are within their endurance");
}

/// Adds the sheet of the stationary speeds of a motor, with the factor of its torque at each.
static void runup_find_stationary(const finder *of) {
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_STATIONARY);
    if (!rows) return;
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "stationary", "Stationary speeds of the drive");
    sheet->about =
        "Speeds at which the motor's torque equals what brakes the shaft while its motions are small and "
        "settled; and folds, at which two such speeds meet if the motor's torque is multiplied by the factor. A "
        "run may pass a speed that holds the shaft, since its motion needs time to build up.";
    sheet_values(of, sheet, "", 6);
    sheet_column(of, sheet, "speed", "speed", WHIRL_QUANTITY_SPEED, 6);
    sheet_texts(of, sheet, "kind", "what");
    sheet_column(of, sheet, "torque", "motor's torque", WHIRL_QUANTITY_MOMENT, 6);
    sheet_column(of, sheet, "factor", "factor of the motor's torque", WHIRL_QUANTITY_NUMBER, 6);
    // Add stationary speeds, then folds, of each run.
    for (size_t point = 0; point < of->table->count; point++) {
        const double *speeds = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_STATIONARY, 0);
        const double *folds = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_FOLD, 0);
        for (size_t row = 0; speeds && folds && row < 2 * rows->rows; row++) {
            const bool fold = row >= rows->rows;
            const double *own = fold ? folds + 3 * (row - rows->rows) : speeds + 3 * row;
            if (isnan(own[0])) continue;
            sheet_row(of, sheet);
            cell_value(of, sheet, point);
            cell_number(of, sheet, own[0]);
            cell_text(of, sheet,
                      fold           ? own[2] > 0.0 ? "fold: released upwards" : "fold: captured downwards"
                      : own[2] > 0.0 ? "holds the shaft"
                                     : "unstable");
            cell_number(of, sheet, fold ? (double)NAN : own[1]);
            cell_number(of, sheet, fold ? own[1] : (double)NAN);
        }
    }
    find_sheet_end(of);
}

/// Judges runs at every speed at which the drive could stay, except the highest: a run passed the speed or is held
/// there.
static void runup_find_capture(const finder *of) {
    const whirl_field *rows = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUNUP_STATIONARY);
    for (size_t point = 0; point < of->table->count && rows; point++) {
        const double *speeds = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_STATIONARY, 0);
        const double end = runup_number_of(of, point, WHIRL_FIELD_RUNUP_END_SPEED, 0);
        const double *events = runup_numbers_of(of, point, WHIRL_FIELD_RUNUP_EVENTS, 0);
        // Count the speeds that hold the shaft, and find the last.
        size_t holding = 0, last = 0;
        for (size_t row = 0; speeds && row < rows->rows; row++)
            if (speeds[3 * row + 2] > 0.0) last = row, holding++;
        // If there is only one speed that holds the shaft, the shaft is meant to run there.
        if (holding < 2 || (events && isfinite(events[0]))) continue;
        // Judge each speed below the last that the run reached.
        for (size_t row = 0; row < last; row++) {
            const double speed = speeds[3 * row];
            const bool passed = end > 1.02 * speed;
            if (!(speeds[3 * row + 2] > 0.0) || end < 0.98 * speed) continue;
            whirl_statement *own = find_judgement(of, "passage of a resonance", "", passed ? WHIRL_HOLDS : WHIRL_FAILS);
            statement_value(of, own, point);
            phrase_text(of, &own->asked, "above ");
            phrase_number(of, &own->asked, WHIRL_QUANTITY_SPEED, 6, speed);
            phrase_text(of, &own->asked, ", where the drive could stay");
            phrase_text(of, &own->found, passed ? "the run passed it, to " : "the run is held there, at ");
            phrase_number(of, &own->found, WHIRL_QUANTITY_SPEED, 6, end);
        }
    }
}

static void runup_find(const finder *of) {
    runup_find_failures(of);
    runup_find_error(of);
    runup_find_sensitivity(of);
    runup_find_capture(of);
    runup_find_largest_motion(of);
    for (size_t kind = 0; kind < sizeof runup_extras / sizeof *runup_extras; kind++) runup_find_largest_extra(of, kind);
    runup_find_touches(of);
    runup_find_largest_torque(of);
    runup_find_slow_roll(of);
    runup_find_runs(of);
    runup_find_shafts(of);
    runup_find_events(of);
    runup_find_peaks(of);
    for (size_t kind = 0; kind < sizeof runup_extras / sizeof *runup_extras; kind++) runup_find_extra(of, kind);
    runup_find_contacts(of);
    runup_find_torques(of);
    runup_find_cycles(of);
    runup_find_uncounted(of);
    runup_find_damage(of);
    runup_find_worst_damage(of);
    runup_find_stationary(of);
}

const shown_kind shown_runup = {.field = WHIRL_FIELD_RUNUP_END,
                                .anchor = "runup",
                                .name = "Run-up and coast-down",
                                .held = "the run opens and closes",
                                .find = runup_find};
