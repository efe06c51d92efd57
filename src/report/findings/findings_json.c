// Writes findings as JSON: numbers in SI, next to their shown texts.
#include "document.h"
#include "findings_render.h"
#include "whirl/internal/findings.h"
#include "whirl/status.h"

static json_t *phrase_json(bool *well, const whirl_phrase *phrase) {
    char text[STATEMENT_SIZE];
    json_t *object = json_object(), *values = json_array();
    whirl_phrase_text(phrase, text, sizeof text);
    document_put(well, object, "text", document_text(text));
    for (size_t i = 0; i < phrase->count; i++)
        if (!phrase->pieces[i].text) document_append(well, values, document_number(phrase->pieces[i].value));
    document_put(well, object, "values", values);
    return object;
}

static json_t *statement_json(bool *well, const whirl_statement *statement) {
    char text[STATEMENT_SIZE];
    json_t *one = json_object();
    document_put(well, one, "table", document_text(statement->table));
    document_put(well, one, "what", document_text(statement->what));
    if (*statement->station) document_put(well, one, "station", document_text(statement->station));
    if (statement->at.count > 0) document_put(well, one, "at", phrase_json(well, &statement->at));
    if (*statement->clause) document_put(well, one, "clause", document_text(statement->clause));
    document_put(well, one, "verdict", document_text(whirl_judgement_name(statement->judgement)));
    document_put(well, one, "asked", phrase_json(well, &statement->asked));
    document_put(well, one, "found", phrase_json(well, &statement->found));
    document_put(well, one, "judged", phrase_json(well, &statement->judged));
    statement_text(statement, text, sizeof text);
    document_put(well, one, "text", document_text(text));
    return one;
}

static json_t *cell_json(bool *well, const whirl_column *column, const whirl_cell *cell) {
    if (cell->text) return document_text(cell->text);
    if (!column->between) return cell->count > 0 ? document_number(cell->number) : json_null();
    json_t *array = json_array();
    for (size_t i = 0; i < cell->count; i++)
        document_append(well, array, document_number(cell->numbers ? cell->numbers[i] : cell->number));
    return array;
}

static json_t *sheet_json(bool *well, const whirl_sheet *sheet) {
    char text[STATEMENT_SIZE];
    json_t *one = json_object(), *columns = json_array(), *rows = json_array(), *shown = json_array();
    // Put name and title.
    document_put(well, one, "table", document_text(sheet->table));
    document_put(well, one, "name", document_text(sheet->name));
    document_put(well, one, "title", document_text(sheet->title));
    if (*sheet->about) document_put(well, one, "about", document_text(sheet->about));
    if (sheet->looked_up) document_put(well, one, "looked_up", json_true());
    // Put the headings of columns.
    for (const whirl_column *column = sheet->column; column < sheet->column + sheet->columns; column++) {
        json_t *heading = json_object();
        document_put(well, heading, "key", document_text(column->key));
        document_put(well, heading, "heading", document_text(column->heading));
        document_put(well, heading, "unit", document_text(column->unit));
        document_put(well, heading, "size", document_number(column->size));
        if (column->zero != 0.0) document_put(well, heading, "zero", document_number(column->zero));
        document_put(well, heading, "digits", json_integer(column->digits));
        if (column->between) document_put(well, heading, "between", document_text(column->between));
        if (column->meaning) document_put(well, heading, "meaning", document_text(column->meaning));
        document_append(well, columns, heading);
    }
    // Put each row twice: as numbers in SI, and as texts in the units of display.
    for (size_t r = 0; r < sheet->rows; r++) {
        json_t *row = json_array(), *texts = json_array();
        for (size_t c = 0; c < sheet->columns; c++) {
            const whirl_cell *cell = &sheet->cells[r * sheet->columns + c];
            document_append(well, row, cell_json(well, &sheet->column[c], cell));
            whirl_cell_text(&sheet->column[c], cell, text, sizeof text);
            document_append(well, texts, document_text(text));
        }
        document_append(well, rows, row);
        document_append(well, shown, texts);
    }
    document_put(well, one, "columns", columns);
    document_put(well, one, "rows", rows);
    document_put(well, one, "shown", shown);
    return one;
}

json_t *statements_json(bool *well, const whirl_findings *findings) {
    json_t *array = json_array();
    for (size_t i = 0; i < findings->statement_count; i++)
        document_append(well, array, statement_json(well, &findings->statements[i]));
    return array;
}

json_t *sheets_json(bool *well, const whirl_findings *findings) {
    json_t *array = json_array();
    for (size_t i = 0; i < findings->sheet_count; i++)
        document_append(well, array, sheet_json(well, &findings->sheets[i]));
    return array;
}

whirl_status whirl_findings_write_json(const whirl_findings *findings, FILE *stream) {
    bool well = true;
    json_t *object = json_object();
    document_put(&well, object, "statements", statements_json(&well, findings));
    document_put(&well, object, "sheets", sheets_json(&well, findings));
    return document_finish(well, object, stream);
}

whirl_status sheet_write_json(const whirl_sheet *sheet, FILE *stream) {
    bool well = true;
    json_t *object = sheet_json(&well, sheet);
    return document_finish(well, object, stream);
}
