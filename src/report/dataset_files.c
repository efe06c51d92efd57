// Writes the files that accompany the signals of a data set: the table of its records, and its data sheet.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "findings_render.h"
#include "shown_kinds.h"
#include "text_written.h"
#include "whirl/engine/dataset.h"
#include "whirl/engine/report.h"
#include "whirl/handles.h"
#include "whirl/internal/findings.h"

const whirl_table *whirl_result_records(const whirl_result *result) {
    for (size_t i = 0; i < result->table_count; i++)
        if (result->tables[i].role == WHIRL_ROLE_RECORDS) return &result->tables[i];
    return NULL;
}

/// Writes the name of label or parameter `number` (what: "label", ...), which the result stores as a fact.
static void put_name(FILE *stream, const whirl_result *result, const char *what, size_t number) {
    char name[WHIRL_NAME_SIZE];
    records_fact(result, what, number, name);
    fputs(name, stream);
}

static void dataset_put_number(FILE *stream, double value) {
    if (isfinite(value))
        fprintf(stream, ",%.17g", value);
    else
        fputc(',', stream);
}

void whirl_dataset_write_index(const whirl_result *result, FILE *stream) {
    const whirl_table *table = whirl_result_records(result);
    if (!table) return;
    const size_t parameters = (size_t)table->record.dataset.parameters;
    // Headings.
    const bool runs = records_are_runs(table);
    fprintf(stream, "row,record,machine,split,label,severity,%scontact,speed,%sbegin,seed",
            runs ? "" : "verdict,confidence,", runs ? "end_speed,rate," : "");
    for (size_t i = 0; i < parameters; i++) fputc(',', stream), put_name(stream, result, "parameter", i + 1);
    fputs("\r\n", stream);
    // A row for each record.
    for (size_t p = 0, row = 0; p < table->count; p++) {
        if (!whirl_table_done(table, p)) continue;
        const double split = whirl_table_number(table, p, WHIRL_FIELD_DATASET_SPLIT, 0);
        const double label = whirl_table_number(table, p, WHIRL_FIELD_DATASET_LABEL, 0);
        const whirl_verdict found = whirl_table_verdict(table, p);
        const bool judged = found.regime != WHIRL_NOT_JUDGED;
        char verdict[WHIRL_NAME_SIZE];
        whirl_verdict_name(&found, verdict, sizeof verdict);
        fprintf(stream, "%zu,%.0f,%.0f,%s,", row++, whirl_table_number(table, p, WHIRL_FIELD_DATASET_RECORD, 0),
                whirl_table_number(table, p, WHIRL_FIELD_DATASET_MACHINE, 0), whirl_split_name((whirl_split)split));
        put_name(stream, result, "label", (size_t)label + 1);
        dataset_put_number(stream, whirl_table_number(table, p, WHIRL_FIELD_DATASET_SEVERITY, 0));
        if (!runs)
            fprintf(stream, ",%s,%s", judged ? verdict : "", judged ? whirl_confidence_name(found.confidence) : "");
        dataset_put_number(stream, records_contact(result, table, p));
        dataset_put_number(stream, whirl_table_number(table, p, WHIRL_FIELD_DATASET_SPEED, 0));
        if (runs) {
            dataset_put_number(stream, whirl_table_number(table, p, WHIRL_FIELD_DATASET_END_SPEED, 0));
            dataset_put_number(stream, whirl_table_number(table, p, WHIRL_FIELD_DATASET_RATE, 0));
        }
        dataset_put_number(stream, whirl_table_number(table, p, WHIRL_FIELD_DATASET_BEGIN, 0));
        fprintf(stream, ",%.0f", whirl_table_number(table, p, WHIRL_FIELD_DATASET_SEED, 0));
        const double *values = whirl_table_field(table, p, WHIRL_FIELD_DATASET_VALUES, 0);
        for (size_t i = 0; i < parameters; i++) dataset_put_number(stream, values ? values[i] : (double)NAN);
        fputs("\r\n", stream);
    }
}

// ---------------------------------------------------------------- data sheet

whirl_status whirl_dataset_write_sheet(const whirl_result *result, const char *name, FILE *stream) {
    const whirl_table *table = whirl_result_records(result);
    whirl_findings *findings;
    if (!table) return whirl_ok();
    const whirl_status status = whirl_findings_new(result, NULL, &findings);
    if (status.code != WHIRL_OK) return status;
    const whirl_dataset_options *options = &table->record.dataset;
    const bool runs = records_are_runs(table);
    // The title and the files.
    fprintf(
        stream,
        "# %s\n\nComputed by whirl %s from the case %s, which is in the file with all its numbers. Files:\n\n"
        "- `%s.h5`: the result. Its dataset `records/dataset/signals` holds [record][channel][sample] as float32; a "
        "row of it is a row of all other datasets of `records`, and of the table.\n"
        "- `%s-records.csv`: for each record its machine, set, label, severity, %slargest share of the time in "
        "contact, "
        "%s, angle of the shaft at the first sample (revolutions), seed, and the parameters that differ (SI).\n\n",
        result->title[0] ? result->title : result->case_name, whirl_result_fact(result, "version"), result->case_name,
        name, name, runs ? "" : "verdict on the computed motion with its confidence, ",
        runs ? "speeds at the first and the last sample (rad/s), rate of the speed at the first sample (rad/s2)"
             : "speed (rad/s)");
    // Statements and sheets.
    for (size_t i = 0; i < findings->statement_count; i++) {
        char text[2 * WHIRL_MESSAGE_SIZE];
        if (strcmp(findings->statements[i].table, table->name) != 0) continue;
        whirl_phrase_text(&findings->statements[i].found, text, sizeof text);
        fprintf(stream, "- %c%s.\n", text[0] >= 'a' && text[0] <= 'z' ? text[0] - 'a' + 'A' : text[0], text + 1);
    }
    for (size_t i = 0; i < findings->sheet_count; i++) {
        const whirl_sheet *sheet = &findings->sheets[i];
        if (strcmp(sheet->table, table->name) != 0 || sheet->rows == 0) continue;
        fprintf(stream, "\n## %s\n\n%s%s", sheet->title, sheet->about, *sheet->about ? "\n\n" : "");
        sheet_write_markdown(stream, sheet);
    }
    // Limits of the signals.
    char before[WHIRL_MESSAGE_SIZE];
    if (runs)
        snprintf(before, sizeof before,
                 "The shaft turns at the first speed for %.3g s before the first sample, in which sensors and filters "
                 "settle; where the speed stays at its last value, the law ended before the record.",
                 whirl_dataset_lead(options, 1.0));
    else
        snprintf(before, sizeof before,
                 "Transients before the records are %d revolutions long; the speed is constant in a record.",
                 table->record.transient);
    fprintf(
        stream,
        "\n## What to know before use\n\n"
        "- The motions are solutions of the equations of the case by %s: every effect that the case does not have is "
        "missing from the signals. A classifier that is right here has shown that it finds these faults in this "
        "model, not on a machine.\n"
        "- Labels say which parameters were changed, severities how far. %s whether the motion is another one: a rub "
        "that does not touch is a healthy motion with the label of a rub.\n"
        "- Sets are divided by machine: %.3g %% for training, %.3g %% for validation, the rest for testing. Windows "
        "of one record, or records of one machine, in two sets show a classifier what it should find.\n"
        "- %s\n"
        "- Any record is computed again by `whirl run CASE.yaml --set dataset.only=NUMBER`, with the same bits on the "
        "same instruction set.\n",
        runs ? table->record.runup.method : table->integrate.method,
        runs ? "Contact shows" : "Verdict and contact show", 100.0 * options->train, 100.0 * options->validation,
        before);
    whirl_findings_free(findings);
    return whirl_ok();
}

// ---------------------------------------------------------------- as texts

/// A data set, and the name of its files.
typedef struct records_named {
    const whirl_result *result;
    const char *name;
} records_named;

static whirl_status records_write_index(const void *of, FILE *stream) {
    const records_named *own = of;
    whirl_dataset_write_index(own->result, stream);
    return whirl_ok();
}

static whirl_status records_write_sheet(const void *of, FILE *stream) {
    const records_named *own = of;
    return whirl_dataset_write_sheet(own->result, own->name, stream);
}

whirl_status whirl_result_dataset(const whirl_result *result, const char *what, const char *name, char **text) {
    const records_named named = {result, name};
    const bool index = strcmp(what, "index") == 0;
    *text = NULL;
    if (!index && strcmp(what, "datasheet") != 0)
        return whirl_fail(WHIRL_BAD_INPUT, "a data set has no '%.40s', expected index or datasheet", what);
    if (!whirl_result_records(result))
        return whirl_fail(WHIRL_BAD_INPUT, "the result of %.200s is no data set, expected one of a study 'dataset'",
                          result->case_name);
    return index ? text_written(records_write_index, &named, "for the table of records", text)
                 : text_written(records_write_sheet, &named, "for the data sheet", text);
}
