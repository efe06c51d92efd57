// Findings on studies of tolerances: probabilities, spreads of numbers, and the parts of both that each parameter
// causes.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "number_name.h"
#include "shown_kinds.h"

/// Writes the cell of the parameter's value; it is empty in a row about all values.
static void cell_place(const finder *of, whirl_sheet *sheet, size_t place) {
    if (!*of->table->parameter) return;
    if (place == WHIRL_ANYWHERE)
        cell_number(of, sheet, (double)NAN);
    else
        cell_value(of, sheet, place);
}

/// Returns the next place of a loop over rows: one for each value of the parameter, and WHIRL_ANYWHERE if there are
/// several values.
static size_t next_place(size_t place, size_t places) {
    return place + 1 < places ? place + 1 : WHIRL_ANYWHERE;
}

static bool last_place(size_t place, size_t places) {
    return places > 1 ? place == WHIRL_ANYWHERE : place == 0;
}

/// Returns the number and its limits in words: "major of unbalance axes at disc, below 50 um".
static const char *limits_text(const finder *of, const whirl_spread_of *own) {
    const whirl_unit unit = number_unit(of->units, of->table, own);
    char name[NUMBER_NAME_SIZE], above[WHIRL_NAME_SIZE] = "", below[WHIRL_NAME_SIZE] = "";
    number_name(of->table, own, name);
    const char *gap = *unit.name ? " " : "";
    if (isfinite(own->above))
        snprintf(above, sizeof above, "not above %.6g%s%.30s", own->above / unit.size, gap, unit.name);
    if (isfinite(own->below))
        snprintf(below, sizeof below, "not below %.6g%s%.30s", own->below / unit.size, gap, unit.name);
    return find_text(of->findings, "%s %s%s%s", name, above, *above && *below ? " or " : "", below);
}

static void note_failure(const finder *of, const whirl_status *status) {
    if (status->code != WHIRL_OK) of->findings->failed = true;
}

// ---------------------------------------------------------------- parameters

static void find_parameters(const finder *of) {
    char fact[WHIRL_NAME_SIZE], name[WHIRL_NAME_SIZE];
    whirl_sheet *sheet = find_sheet(of, "parameters", "Parameters with tolerances");
    sheet_texts(of, sheet, "parameter", "parameter");
    sheet_texts(of, sheet, "distribution", "distribution");
    for (size_t i = 0; *whirl_result_tolerance(of->result, i, name); i++) {
        snprintf(fact, sizeof fact, "tolerance %zu", i + 1);
        const char *text = whirl_result_fact(of->result, fact) + strlen(name);
        sheet_row(of, sheet);
        cell_text(of, sheet, find_text(of->findings, "%s", name));
        cell_text(of, sheet, find_text(of->findings, "%s", text + strspn(text, ": ")));
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- probabilities

/// A probability that the study computes.
typedef struct asked_chance {
    const char *what;
    const whirl_spread_of
        *number; ///< number that may be beyond its limits; NULL: the probability of a verdict or of touching
    whirl_chance chance;
    whirl_verdict verdict;
} asked_chance;

static whirl_status chance_at(const finder *of, const asked_chance *own, size_t place, size_t samples,
                              whirl_spread *spread) {
    return own->number ? whirl_table_spread(of->result, of->table, own->number, place, samples, spread)
                       : whirl_table_chance(of->table, own->chance, &own->verdict, place, samples, spread);
}

enum { MAX_ASKED = 64 };

/// Lists the numbers whose spread the study computes; returns their number.
static size_t list_numbers(const finder *of, whirl_spread_of numbers[MAX_ASKED]) {
    size_t count = 0;
    while (count < MAX_ASKED && whirl_table_asked(of->result, of->table, count, &numbers[count])) count++;
    return count;
}

enum { MAX_VERDICTS = 32 };

/// Lists the different verdicts of a table, in the order of their first points; returns their number.
static size_t tolerances_verdicts(const whirl_table *table, whirl_verdict verdicts[MAX_VERDICTS]) {
    size_t count = 0;
    for (size_t point = 0; point < table->count && whirl_layout_has_verdict(&table->layout); point++) {
        if (!whirl_table_done(table, point)) continue;
        const whirl_verdict own = whirl_table_verdict(table, point);
        size_t i = 0;
        if (own.regime == WHIRL_UNDETERMINED || own.regime == WHIRL_NOT_JUDGED) continue;
        while (i < count &&
               (verdicts[i].regime != own.regime || (own.regime == WHIRL_PERIODIC && verdicts[i].period != own.period)))
            i++;
        if (i == count && count < MAX_VERDICTS) verdicts[count++] = own;
    }
    return count;
}

/// Lists all probabilities of a table: of limits, of touching, of verdicts. Returns their number.
static size_t list_chances(const finder *of, const whirl_spread_of *numbers, size_t number_count,
                           asked_chance chances[2 * MAX_ASKED]) {
    whirl_verdict verdicts[MAX_VERDICTS];
    size_t count = 0;
    for (size_t i = 0; i < number_count; i++)
        if (isfinite(numbers[i].above) || isfinite(numbers[i].below))
            chances[count++] = (asked_chance){.what = limits_text(of, &numbers[i]), .number = &numbers[i]};
    const whirl_field *share = whirl_layout_field(&of->table->layout, WHIRL_FIELD_RUB_SHARE);
    if (share && share->repeat > 0 && of->result->contact_count > 0)
        chances[count++] = (asked_chance){.what = "a contact closes", .chance = WHIRL_CHANCE_TOUCH};
    const size_t found = tolerances_verdicts(of->table, verdicts);
    for (size_t i = 0; i < found; i++) {
        char name[WHIRL_NAME_SIZE];
        if (verdicts[i].regime == WHIRL_PERIODIC)
            snprintf(name, sizeof name, "P-%d", verdicts[i].period);
        else
            snprintf(name, sizeof name, "%s", whirl_regime_name(verdicts[i].regime));
        chances[count++] = (asked_chance){
            .what = find_text(of->findings, "%s", name), .chance = WHIRL_CHANCE_VERDICT, .verdict = verdicts[i]};
    }
    return count;
}

static void find_chances(const finder *of, const asked_chance *chances, size_t count) {
    const size_t places = whirl_table_places(of->table);
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "probabilities", "Probabilities");
    sheet->about =
        "Standard errors are those of 16 independent scramblings of the samples. The interval is Wilson's, of "
        "95 %, for as many independent samples; samples without a number (failed) widen it to both sides. A row "
        "without "
        "a value of the parameter is about all of them.";
    sheet_texts(of, sheet, "what", "of");
    if (*of->table->parameter) sheet_values(of, sheet, "", 6);
    sheet_column(of, sheet, "probability", "probability", WHIRL_QUANTITY_PERCENT, 4);
    sheet_column(of, sheet, "error", "standard error", WHIRL_QUANTITY_PERCENT, 2);
    sheet_column(of, sheet, "from", "from", WHIRL_QUANTITY_PERCENT, 4);
    sheet_column(of, sheet, "to", "to", WHIRL_QUANTITY_PERCENT, 4);
    sheet_column(of, sheet, "samples", "samples", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "failed", "failed", WHIRL_QUANTITY_NUMBER, 8);
    // Add a row for each value of the parameter, and one for all of them.
    for (size_t i = 0; i < count; i++)
        for (size_t place = 0;; place = next_place(place, places)) {
            whirl_spread spread;
            const whirl_status status = chance_at(of, &chances[i], place, 0, &spread);
            note_failure(of, &status);
            sheet_row(of, sheet);
            cell_text(of, sheet, chances[i].what);
            cell_place(of, sheet, place);
            cell_number(of, sheet, 100.0 * spread.beyond.of.value);
            cell_number(of, sheet, 100.0 * spread.beyond.of.error);
            cell_number(of, sheet, 100.0 * spread.beyond.from);
            cell_number(of, sheet, 100.0 * spread.beyond.to);
            cell_number(of, sheet, (double)spread.samples);
            cell_number(of, sheet, (double)spread.failed);
            if (last_place(place, places) || status.code != WHIRL_OK) break;
        }
    find_sheet_end(of);
}

/// States the probability over the whole study.
static void state_chance(const finder *of, const asked_chance *chance) {
    const size_t places = whirl_table_places(of->table);
    whirl_spread s;
    const whirl_status status = chance_at(of, chance, places > 1 ? WHIRL_ANYWHERE : 0, 0, &s);
    note_failure(of, &status);
    if (status.code != WHIRL_OK) return;
    whirl_statement *own = find_statement(of, "probability");
    phrase_text(of, &own->found, "%s%s: ", chance->what,
                places < 2                                               ? ""
                : chance->number || chance->chance == WHIRL_CHANCE_TOUCH ? " at any value"
                                                                         : " at some value");
    phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * s.beyond.of.value);
    phrase_text(of, &own->found, " of the samples, 95 %% interval ");
    phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * s.beyond.from);
    phrase_text(of, &own->found, " to ");
    phrase_number(of, &own->found, WHIRL_QUANTITY_PERCENT, 3, 100.0 * s.beyond.to);
    if (s.failed > 0)
        phrase_text(of, &own->found, "; %zu of %zu samples have no number, and are counted to both sides", s.failed,
                    s.samples);
}

// ---------------------------------------------------------------- numbers

static void cell_estimate(const finder *of, whirl_sheet *sheet, whirl_estimate estimate) {
    cell_number(of, sheet, estimate.value);
    cell_number(of, sheet, estimate.error);
}

static void find_spread(const finder *of, const whirl_spread_of *number, const char *sheet_name) {
    // Keys and headings of the quantiles.
    static const char *const keys[WHIRL_QUANTILES] = {"q05", "q25", "median", "q75", "q95"};
    static const char *const error_keys[WHIRL_QUANTILES] = {"q05_error", "q25_error", "median_error", "q75_error",
                                                            "q95_error"};
    static const char *const headings[WHIRL_QUANTILES] = {"5 %", "25 %", "median", "75 %", "95 %"};
    // Set up the columns.
    const size_t places = whirl_table_places(of->table);
    const whirl_unit unit = number_unit(of->units, of->table, number);
    char name[NUMBER_NAME_SIZE];
    number_name(of->table, number, name);
    whirl_sheet *sheet = find_sheet(of, sheet_name, find_text(of->findings, "Spread of %s", name));
    sheet->of_points = true;
    if (places > 1) sheet->about = "The row without a value of the parameter is about the worst of all values.";
    if (*of->table->parameter) sheet_values(of, sheet, "", 6);
    sheet_units(of, sheet, "mean", "mean", &unit, 5);
    sheet_units(of, sheet, "mean_error", "+-", &unit, 2);
    sheet_units(of, sheet, "deviation", "standard deviation", &unit, 4);
    sheet_units(of, sheet, "deviation_error", "+-", &unit, 2);
    for (size_t q = 0; q < WHIRL_QUANTILES; q++) {
        sheet_units(of, sheet, keys[q], headings[q], &unit, 5);
        sheet_units(of, sheet, error_keys[q], "+-", &unit, 2);
    }
    sheet_units(of, sheet, "least", "least", &unit, 5);
    sheet_units(of, sheet, "most", "most", &unit, 5);
    sheet_column(of, sheet, "samples", "samples", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "failed", "failed", WHIRL_QUANTITY_NUMBER, 8);
    // Add a row for each value of the parameter, and one for the worst of all.
    for (size_t place = 0;; place = next_place(place, places)) {
        whirl_spread spread;
        const whirl_status status = whirl_table_spread(of->result, of->table, number, place, 0, &spread);
        note_failure(of, &status);
        sheet_row(of, sheet);
        cell_place(of, sheet, place);
        cell_estimate(of, sheet, spread.mean);
        cell_estimate(of, sheet, spread.deviation);
        for (size_t q = 0; q < WHIRL_QUANTILES; q++) cell_estimate(of, sheet, spread.quantiles[q]);
        cell_number(of, sheet, spread.least);
        cell_number(of, sheet, spread.most);
        cell_number(of, sheet, (double)spread.samples);
        cell_number(of, sheet, (double)spread.failed);
        if (last_place(place, places) || status.code != WHIRL_OK) break;
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- indices

/// Adds a row for each parameter.
static void index_rows(const finder *of, whirl_sheet *sheet, const char *what, size_t place, size_t count,
                       const whirl_index *indices) {
    char name[WHIRL_NAME_SIZE];
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(indices[i].total.value)) continue;
        sheet_row(of, sheet);
        cell_text(of, sheet, what);
        cell_place(of, sheet, place);
        cell_text(of, sheet, find_text(of->findings, "%s", whirl_result_tolerance(of->result, i, name)));
        cell_estimate(of, sheet, indices[i].first);
        cell_estimate(of, sheet, indices[i].total);
    }
}

static void find_indices(const finder *of, const whirl_spread_of *numbers, size_t number_count,
                         const asked_chance *chances, size_t chance_count) {
    // Set up the columns.
    const size_t places = whirl_table_places(of->table);
    char name[NUMBER_NAME_SIZE];
    whirl_sheet *sheet = find_sheet(of, "indices", "Parts of the variance that parameters cause");
    sheet->about =
        "Alone: the part that vanishes if this parameter alone is known. With others: the part that is left if "
        "all others are known. Rows that name a probability give the parts of "
        "its variance, since verdicts are labels and have no variance.";
    sheet_texts(of, sheet, "what", "of");
    if (*of->table->parameter) sheet_values(of, sheet, "", 6);
    sheet_texts(of, sheet, "parameter", "parameter");
    sheet_column(of, sheet, "first", "alone", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(of, sheet, "first_error", "+-", WHIRL_QUANTITY_NUMBER, 2);
    sheet_column(of, sheet, "total", "with others", WHIRL_QUANTITY_NUMBER, 3);
    sheet_column(of, sheet, "total_error", "+-", WHIRL_QUANTITY_NUMBER, 2);
    // Add the indices of each number, then of each probability, at each value of the parameter.
    for (size_t i = 0; i < number_count + chance_count && of->table->tolerances.indices; i++)
        for (size_t place = 0;; place = next_place(place, places)) {
            whirl_spread s;
            const bool number = i < number_count;
            const whirl_status status = number ? whirl_table_spread(of->result, of->table, &numbers[i], place, 0, &s)
                                               : chance_at(of, &chances[i - number_count], place, 0, &s);
            note_failure(of, &status);
            if (status.code != WHIRL_OK) break;
            if (number) number_name(of->table, &numbers[i], name);
            index_rows(of, sheet,
                       number ? find_text(of->findings, "%s", name)
                              : find_text(of->findings, "probability of %s", chances[i - number_count].what),
                       place, s.index_count, number ? s.indices : s.beyond_of);
            if (last_place(place, places)) break;
        }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- convergence

static void find_convergence(const finder *of, const whirl_spread_of *numbers, size_t number_count,
                             const asked_chance *chances, size_t chance_count) {
    // With several values of the parameter, take the worst of them.
    const size_t all = (size_t)of->table->tolerances.samples,
                 place = whirl_table_places(of->table) > 1 ? WHIRL_ANYWHERE : 0;
    char name[NUMBER_NAME_SIZE];
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "convergence", "The same estimates from fewer samples");
    sheet->about =
        "From the first quarter and half of the samples, which are the samples of a study of that size. Means and "
        "deviations are divided by those from all samples.";
    sheet_texts(of, sheet, "what", "of");
    sheet_column(of, sheet, "samples", "samples", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "mean", "mean", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "mean_error", "+-", WHIRL_QUANTITY_NUMBER, 2);
    sheet_column(of, sheet, "deviation", "standard deviation", WHIRL_QUANTITY_NUMBER, 6);
    sheet_column(of, sheet, "deviation_error", "+-", WHIRL_QUANTITY_NUMBER, 2);
    sheet_column(of, sheet, "probability", "probability", WHIRL_QUANTITY_PERCENT, 4);
    sheet_column(of, sheet, "probability_error", "+-", WHIRL_QUANTITY_PERCENT, 2);
    // Estimate each number and probability from a quarter, a half and all samples.
    for (size_t i = 0; i < number_count + chance_count; i++) {
        const bool number = i < number_count;
        whirl_spread parts[3] = {{.samples = 0}};
        if (number) number_name(of->table, &numbers[i], name);
        for (size_t k = 0; k < 3; k++) {
            const size_t some = all >> (2 - k);
            const whirl_status status =
                number ? whirl_table_spread(of->result, of->table, &numbers[i], place, some, &parts[k])
                       : chance_at(of, &chances[i - number_count], place, some, &parts[k]);
            note_failure(of, &status);
        }
        // Add their rows; means and deviations are divided by those from all samples.
        for (size_t k = 0; k < 3; k++) {
            const double mean = parts[2].mean.value, deviation = parts[2].deviation.value;
            sheet_row(of, sheet);
            cell_text(of, sheet, number ? find_text(of->findings, "%s", name) : chances[i - number_count].what);
            cell_number(of, sheet, (double)(all >> (2 - k)));
            cell_number(of, sheet, number ? parts[k].mean.value / mean : (double)NAN);
            cell_number(of, sheet, number ? fabs(parts[k].mean.error / mean) : (double)NAN);
            cell_number(of, sheet, number ? parts[k].deviation.value / deviation : (double)NAN);
            cell_number(of, sheet, number ? parts[k].deviation.error / deviation : (double)NAN);
            cell_number(of, sheet, number ? (double)NAN : 100.0 * parts[k].beyond.of.value);
            cell_number(of, sheet, number ? (double)NAN : 100.0 * parts[k].beyond.of.error);
        }
    }
    find_sheet_end(of);
}

void find_spread_of(const finder *of, const whirl_spread_of *number) {
    const bool limited = isfinite(number->above) || isfinite(number->below);
    const asked_chance chance = {.what = limits_text(of, number), .number = number};
    find_spread(of, number, "spread");
    find_chances(of, &chance, limited);
    find_indices(of, number, 1, &chance, limited);
}

static void tolerances_find(const finder *of) {
    whirl_spread_of numbers[MAX_ASKED];
    asked_chance chances[2 * MAX_ASKED];
    const size_t count = list_numbers(of, numbers), chance_count = list_chances(of, numbers, count, chances);
    for (size_t i = 0; i < chance_count; i++) state_chance(of, &chances[i]);
    find_parameters(of);
    find_chances(of, chances, chance_count);
    for (size_t i = 0; i < count; i++) find_spread(of, &numbers[i], find_text(of->findings, "spread-%zu", i + 1));
    find_indices(of, numbers, count, chances, chance_count);
    find_convergence(of, numbers, count, chances, chance_count);
}

const shown_kind shown_tolerances = {
    .field = WHIRL_FIELD_TOLERANCES_VALUES,
    .anchor = "tolerances",
    .name = "Tolerances",
    .about = "Every point is computed at samples of the parameters with tolerances: points of a scrambled Sobol "
             "sequence, each of them equally likely.",
    .find = tolerances_find,
};
