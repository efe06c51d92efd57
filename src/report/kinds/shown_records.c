// Findings on data sets: labels and the motions of their machines, sensors, and parameters that differ between records.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "shown_kinds.h"
#include "whirl/engine/dataset.h"

const char *records_fact(const whirl_result *result, const char *what, size_t number, char name[WHIRL_NAME_SIZE]) {
    char key[WHIRL_NAME_SIZE];
    snprintf(key, sizeof key, "dataset %s %zu", what, number);
    const char *text = whirl_result_fact(result, key);
    const size_t length = strcspn(text, ":");
    snprintf(name, WHIRL_NAME_SIZE, "%.*s", (int)(length < WHIRL_NAME_SIZE ? length : WHIRL_NAME_SIZE - 1), text);
    text += length;
    return text + strspn(text, ": ");
}

bool records_are_runs(const whirl_table *table) {
    return whirl_layout_field(&table->layout, WHIRL_FIELD_DATASET_RATE) != NULL;
}

double records_contact(const whirl_result *result, const whirl_table *table, size_t point) {
    double most = result->contact_count > 0 ? 0.0 : (double)NAN;
    for (size_t c = 0; c < result->contact_count; c++) {
        const double *contact = whirl_table_field(table, point, WHIRL_FIELD_RUNUP_CONTACT, c);
        const double share = contact ? contact[2] / whirl_table_number(table, point, WHIRL_FIELD_RUNUP_END_TIME, 0)
                                     : whirl_table_number(table, point, WHIRL_FIELD_RUB_SHARE, c);
        most = fmax(most, share);
    }
    return most;
}

// ---------------------------------------------------------------- labels

/// Numbers of records with a label, by verdict and set.
typedef struct label_count {
    size_t records, periodic, quasi_periodic, chaotic, undetermined, ended, touching;
    size_t splits[3];
} label_count;

static void count_verdict(label_count *own, const whirl_verdict *verdict) {
    size_t *regime = &own->undetermined;
    if (verdict->regime == WHIRL_PERIODIC) regime = &own->periodic;
    if (verdict->regime == WHIRL_QUASI_PERIODIC) regime = &own->quasi_periodic;
    if (verdict->regime == WHIRL_CHAOTIC) regime = &own->chaotic;
    if (verdict->regime == WHIRL_DIVERGING) regime = &own->ended;
    ++*regime;
}

/// Counts the finished records of all labels, counts [WHIRL_MAX_LABELS].
static void count_labels(const finder *of, label_count *counts) {
    const whirl_table *table = of->table;
    memset(counts, 0, WHIRL_MAX_LABELS * sizeof *counts);
    for (size_t p = 0; p < table->count; p++) {
        const double label = whirl_table_number(table, p, WHIRL_FIELD_DATASET_LABEL, 0);
        if (!whirl_table_done(table, p) || !(label >= 0.0 && label < WHIRL_MAX_LABELS)) continue;
        label_count *own = &counts[(size_t)label];
        const double split = whirl_table_number(table, p, WHIRL_FIELD_DATASET_SPLIT, 0);
        const whirl_verdict verdict = whirl_table_verdict(table, p);
        own->records++;
        own->touching += records_contact(of->result, table, p) > 0.0;
        if (records_are_runs(table)) own->ended += whirl_table_number(table, p, WHIRL_FIELD_RUNUP_END, 0) != 0.0;
        if (split >= 0.0 && split <= 2.0) own->splits[(size_t)split]++;
        if (!records_are_runs(table)) count_verdict(own, &verdict);
    }
}

static void find_labels(const finder *of, const label_count *counts) {
    char name[WHIRL_NAME_SIZE];
    const bool contacts = of->result->contact_count > 0, runs = records_are_runs(of->table);
    // Set up the columns.
    whirl_sheet *sheet = find_sheet(of, "labels", "Labels and what their machines do");
    sheet->about =
        "Numbers of records. Sets are divided by machine, since records of one machine resemble one another.";
    sheet_texts(of, sheet, "label", "label");
    sheet_column(of, sheet, "records", "records", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "train", "train", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "validation", "validation", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "test", "test", WHIRL_QUANTITY_NUMBER, 8);
    if (!runs) sheet_column(of, sheet, "periodic", "periodic", WHIRL_QUANTITY_NUMBER, 8);
    if (!runs) sheet_column(of, sheet, "quasi_periodic", "quasi-periodic", WHIRL_QUANTITY_NUMBER, 8);
    if (!runs) sheet_column(of, sheet, "chaotic", "chaotic", WHIRL_QUANTITY_NUMBER, 8);
    if (!runs) sheet_column(of, sheet, "undetermined", "undetermined", WHIRL_QUANTITY_NUMBER, 8);
    sheet_column(of, sheet, "ended", "without signals", WHIRL_QUANTITY_NUMBER, 8);
    if (contacts) sheet_column(of, sheet, "touching", "in contact", WHIRL_QUANTITY_NUMBER, 8);
    sheet_texts(of, sheet, "fault", "fault");
    // Add a row for each label.
    for (size_t i = 0; i < (size_t)of->table->record.dataset.labels; i++) {
        const label_count own = counts[i];
        const char *fault = records_fact(of->result, "label", i + 1, name);
        enum { VERDICTS = 4, VERDICTS_END = VERDICTS + 4 };
        const double numbers[] = {(double)own.records,   (double)own.splits[0],    (double)own.splits[1],
                                  (double)own.splits[2], (double)own.periodic,     (double)own.quasi_periodic,
                                  (double)own.chaotic,   (double)own.undetermined, (double)own.ended};
        sheet_row(of, sheet);
        cell_text(of, sheet, find_text(of->findings, "%s", name));
        for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
            if (!runs || k < VERDICTS || k >= VERDICTS_END) cell_number(of, sheet, numbers[k]);
        if (contacts) cell_number(of, sheet, (double)own.touching);
        cell_text(of, sheet, find_text(of->findings, "%s", *fault ? fault : "none"));
    }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- channels and parameters

static void find_channels(const finder *of) {
    char name[WHIRL_NAME_SIZE];
    whirl_sheet *sheet = find_sheet(of, "channels", "Channels");
    sheet_texts(of, sheet, "channel", "channel");
    sheet_texts(of, sheet, "sensor", "sensor and converter");
    for (size_t i = 0; i < (size_t)of->table->record.dataset.channels; i++) {
        const char *sensor = records_fact(of->result, "channel", i + 1, name);
        sheet_row(of, sheet);
        cell_text(of, sheet, find_text(of->findings, "%s", name));
        cell_text(of, sheet, find_text(of->findings, "%s", sensor));
    }
    find_sheet_end(of);
}

static void find_drawn(const finder *of) {
    static const char *const between[] = {"machines", "records"};
    char name[WHIRL_NAME_SIZE];
    whirl_sheet *sheet = find_sheet(of, "drawn", "Parameters that differ whatever the label");
    sheet_texts(of, sheet, "parameter", "parameter");
    sheet_texts(of, sheet, "between", "between");
    sheet_texts(of, sheet, "distribution", "distribution");
    for (size_t k = 0; k < 2; k++)
        for (size_t i = 0;; i++) {
            const char *text = records_fact(of->result, between[k], i + 1, name);
            if (!*name) break;
            sheet_row(of, sheet);
            cell_text(of, sheet, find_text(of->findings, "%s", name));
            cell_text(of, sheet, between[k]);
            cell_text(of, sheet, find_text(of->findings, "%s", text));
        }
    find_sheet_end(of);
}

// ---------------------------------------------------------------- statements

static void state_records(const finder *of, const label_count *counts) {
    const whirl_dataset_options *options = &of->table->record.dataset;
    size_t records = 0, ended = 0;
    for (size_t i = 0; i < WHIRL_MAX_LABELS; i++) {
        records += counts[i].records;
        ended += counts[i].ended;
    }
    whirl_statement *own = find_statement(of, "records");
    phrase_text(of, &own->found, "%zu record%s of %d channel%s with %d samples, ", records, records == 1 ? "" : "s",
                options->channels, options->channels == 1 ? "" : "s", options->samples);
    if (options->rate > 0.0)
        phrase_text(of, &own->found, "%.6g Hz", options->rate);
    else
        phrase_text(of, &own->found, "%.6g of a revolution", options->per_revolution);
    phrase_text(of, &own->found, "; %d machine%s, %d label%s; signals are free of aliases up to %.6g %s",
                options->machines, options->machines == 1 ? "" : "s", options->labels, options->labels == 1 ? "" : "s",
                0.42 * (options->rate > 0.0 ? options->rate : options->per_revolution),
                options->rate > 0.0 ? "Hz" : "orders");
    if (records_are_runs(of->table)) {
        char name[WHIRL_NAME_SIZE];
        const char *law = records_fact(of->result, "law", 1, name);
        phrase_text(of, &own->found, "; runs with %s", law);
        for (size_t i = 2; *(law = records_fact(of->result, "law", i, name)); i++)
            phrase_text(of, &own->found, "; %s: %s", name, law);
    }
    if (ended > 0)
        phrase_text(of, &own->found, "; %zu motion%s did not last and ha%s no signals", ended, ended == 1 ? "" : "s",
                    ended == 1 ? "s" : "ve");
}

/// States how many records with a label touch, if its fault is a contact and many of its records have none.
static void state_untouched(const finder *of, const label_count *counts) {
    char name[WHIRL_NAME_SIZE];
    for (size_t i = 0; i < (size_t)of->table->record.dataset.labels && of->result->contact_count > 0; i++) {
        const label_count own = counts[i];
        const char *fault = records_fact(of->result, "label", i + 1, name);
        if (!*fault || own.touching == 0 || own.touching == own.records) continue;
        phrase_text(of, &find_statement(of, "touching")->found, "%zu of %zu records with the label %s touch",
                    own.touching, own.records, name);
    }
}

static void records_find(const finder *of) {
    label_count counts[WHIRL_MAX_LABELS];
    count_labels(of, counts);
    state_records(of, counts);
    state_untouched(of, counts);
    find_labels(of, counts);
    find_channels(of);
    find_drawn(of);
}

const shown_kind shown_records = {
    .field = WHIRL_FIELD_DATASET_RECORD,
    .anchor = "records",
    .name = "Data set",
    .about =
        "Records of machines with known faults, as sensors see them. Any record can be made anew alone, by its number "
        "(dataset: {only: ...}).",
    .held = "a run opens and closes",
    .find = records_find,
};
