// Findings on torsional modes: where excitations meet them, and their separation from running speeds (after API 617,
// part 1, and API 684: the user has to check which edition applies).
#include <math.h>

#include "margins.h"
#include "mode_lines.h"
#include "quantities.h"
#include "shown_kinds.h"
#include "two_pi.h"

/// Required separation of a torsional mode from an excitation, %.
static const double asked_separation = 10.0;

/// Separation of a line of modes from an excitation.
typedef struct separation {
    size_t line;
    torsion_excitation by;
    double frequency; ///< rad/s of the mode, where it is nearest to the excitation
    double speed; ///< rad/s at which they meet; NaN for an excitation by the electric line, whose frequency is fixed
    double had;   ///< separation, % of the excitation's frequency; 0 within its range
    const char *side; ///< position of the mode: "above", "below" or "within" the excitation
} separation;

int torsion_excitation_count(const whirl_table *table) {
    return table->record.orders + (table->record.line_frequency > 0.0 ? 2 : 0);
}

torsion_excitation torsion_excitation_at(const whirl_table *table, int index) {
    const int orders = table->record.orders;
    return index < orders ? (torsion_excitation){index + 1, false} : (torsion_excitation){index - orders + 1, true};
}

double torsion_excitation_frequency(const whirl_table *table, torsion_excitation by, double speed) {
    return by.order * (by.line ? two_pi * table->record.line_frequency : speed);
}

/// Returns by how many per cent a frequency is below (negative) or above excitations from `low` to `high`.
static double torsion_apart(double frequency, double low, double high) {
    return frequency > high  ? 100.0 * (frequency / high - 1.0)
           : frequency < low ? 100.0 * (frequency / low - 1.0)
                             : 0.0;
}

/// Finds the point at which a line is nearest to an excitation. Returns false if the line has no point.
static bool torsion_separate(const whirl_table *table, const mode_lines *lines, separation *own) {
    double low, high, nearest = INFINITY;
    // With running speeds the excitation covers a range of frequencies, otherwise one at each point.
    const bool running = margin_running(table, &low, &high);
    for (size_t point = 0; point < table->count; point++) {
        const double speed = whirl_table_number(table, point, WHIRL_FIELD_MODES_SPEED, 0);
        if (!whirl_table_done(table, point)) continue;
        // Look at the mode of the point that belongs to the line.
        for (size_t i = 0; i < lines->modes; i++) {
            if (lines->line[point * lines->modes + i] != own->line) continue;
            const double frequency = whirl_table_field(table, point, WHIRL_FIELD_MODES_FREQUENCY, 0)[i];
            const double at = torsion_excitation_frequency(table, own->by, speed);
            const double apart =
                torsion_apart(frequency, running ? torsion_excitation_frequency(table, own->by, low) : at,
                              running ? torsion_excitation_frequency(table, own->by, high) : at);
            // Keep the point if the mode is nearer to the excitation than before.
            if (!(fabs(apart) < nearest)) continue;
            nearest = fabs(apart);
            own->frequency = frequency;
            own->speed = own->by.line ? (double)NAN : frequency / own->by.order;
            own->had = nearest;
            own->side = apart > 0.0 ? "above" : apart < 0.0 ? "below" : "within";
        }
    }
    return isfinite(nearest);
}

/// Returns true if any point of a line is a torsional mode.
static bool torsion_of_line(const whirl_table *table, const mode_lines *lines, size_t line) {
    for (size_t i = 0; i < table->count * lines->modes; i++)
        if (lines->line[i] == line && mode_way(table, i / lines->modes, i % lines->modes) == MODE_TORSIONAL)
            return true;
    return false;
}

static const char *torsion_excitation_name(const finder *of, torsion_excitation by) {
    if (!by.line) return find_text(of->findings, "%dX", by.order);
    return by.order == 1 ? "line frequency" : "twice line frequency";
}

/// Adds the sheet of all separations, finds the least, and returns their number.
static size_t torsion_sheet(const finder *of, const mode_lines *lines, separation *least) {
    // Set up the columns; margins need running speeds.
    double low, high;
    const bool running = margin_running(of->table, &low, &high);
    size_t count = 0;
    whirl_sheet *sheet = find_sheet(of, "interference", "Torsional modes and excitations");
    sheet_texts(of, sheet, "name", "mode");
    sheet_column(of, sheet, "frequency", "frequency", WHIRL_QUANTITY_FREQUENCY, 5);
    sheet_texts(of, sheet, "excitation", "excitation");
    sheet_column(of, sheet, "speed", "they meet at", WHIRL_QUANTITY_SPEED, 5);
    if (running) {
        sheet_column(of, sheet, "separation", "separation", WHIRL_QUANTITY_PERCENT, 3);
        sheet_texts(of, sheet, "side", "of the excitation");
        sheet_texts(of, sheet, "verdict", "10 % asked for");
    }
    // Add a row for each torsional line and each excitation, and note the least separation.
    for (size_t i = 0; i < lines->count; i++) {
        if (!torsion_of_line(of->table, lines, i)) continue;
        for (int k = 0; k < torsion_excitation_count(of->table); k++) {
            separation own = {.line = i, .by = torsion_excitation_at(of->table, k)};
            if (!torsion_separate(of->table, lines, &own)) continue;
            if (count++ == 0 || own.had < least->had) *least = own;
            sheet_row(of, sheet);
            cell_text(of, sheet, find_text(of->findings, "%s", lines->names[i]));
            cell_number(of, sheet, own.frequency);
            cell_text(of, sheet, torsion_excitation_name(of, own.by));
            cell_number(of, sheet, own.speed);
            if (!running) continue;
            cell_number(of, sheet, own.had);
            cell_text(of, sheet, own.side);
            cell_text(of, sheet, own.had >= asked_separation ? "holds" : "fails");
        }
    }
    find_sheet_end(of);
    return count;
}

/// Judges the least separation from excitations at running speeds.
static void torsion_judge(const finder *of, const mode_lines *lines, const separation *least) {
    const whirl_judgement judgement = least->had >= asked_separation ? WHIRL_HOLDS : WHIRL_FAILS;
    whirl_statement *own = find_judgement(of, "torsional separation margin", "SP6.8.7", judgement);
    phrase_number(of, &own->asked, WHIRL_QUANTITY_PERCENT, 3, asked_separation);
    phrase_text(of, &own->asked, " from every excitation");
    phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, least->had);
    phrase_text(of, &own->found, " %s: mode %s at ", least->side, lines->names[least->line]);
    phrase_number(of, &own->found, WHIRL_QUANTITY_FREQUENCY, 5, least->frequency);
    phrase_text(of, &own->found, " and %s", torsion_excitation_name(of, least->by));
    if (isfinite(least->speed)) {
        phrase_text(of, &own->found, ", which meet at ");
        phrase_number(of, &own->found, WHIRL_QUANTITY_SPEED, 5, least->speed);
    }
}

/// States what may justify a separation that fails: the largest shear stress at running speeds, in all responses to
/// torques of the result.
static void torsion_justify(const finder *of) {
    // Find the largest stress of all torsional responses at running speeds.
    double largest = -1.0, low, high;
    bool computed = false;
    margin_running(of->table, &low, &high);
    for (size_t t = 0; t < of->result->table_count; t++) {
        const whirl_table *table = &of->result->tables[t];
        const whirl_field *stress = whirl_layout_field(&table->layout, WHIRL_FIELD_TORSION_STRESS);
        for (size_t point = 0; stress && point < table->count; point++) {
            const double speed = whirl_table_number(table, point, WHIRL_FIELD_TORSION_SPEED, 0);
            if (!whirl_table_done(table, point) || speed < low * (1.0 - 1e-9) || speed > high * (1.0 + 1e-9)) continue;
            computed = true;
            for (size_t k = 0; k < stress->rows; k++) {
                const double own = whirl_table_field(table, point, WHIRL_FIELD_TORSION_STRESS, 0)[k];
                if (own > largest) largest = own;
            }
        }
    }
    // State it, or what is missing for it.
    whirl_phrase *found = &find_statement(of, "what may justify a separation that fails")->found;
    if (largest >= 0.0) {
        phrase_text(of, found, "the response to torques: shear stresses of at most ");
        phrase_number(of, found, WHIRL_QUANTITY_PRESSURE, 4, largest);
        phrase_text(of, found, " zero to peak where the machine runs, to be judged by the endurance of the shafts");
    } else {
        phrase_text(of, found,
                    computed ? "the response to torques; diameters of shafts are missing for stresses"
                             : "nothing: there is no response to torques where the machine runs (study: "
                               "torsion)");
    }
}

void find_torsion(const finder *of, const mode_lines *lines) {
    separation least = {.had = NAN};
    if (!lines->line || !whirl_layout_field(&of->table->layout, WHIRL_FIELD_MODES_TORSION)) return;
    if (torsion_sheet(of, lines, &least) == 0 || !margin_asked(of->table)) return;
    torsion_judge(of, lines, &least);
    if (least.had < asked_separation) torsion_justify(of);
}
