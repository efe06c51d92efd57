// Converts a file of another program, a rotor saved by ROSS, to a case.
#include "whirl/internal/import.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input.h"
#include "ross.h"
#include "utf8.h"
#include "whirl/engine/case.h"
#include "whirl/engine/rotor.h"
#include "whirl/status.h"

enum { MAX_BYTES = 1 << 24, MAX_CASE_BYTES = 1 << 20 };

/// Returns true for JSON: it begins with a brace, with which no TOML file begins.
static bool is_json(const char *text, size_t length) {
    size_t i = 0;
    while (i < length && strchr(" \t\r\n", text[i]) && text[i]) i++;
    return i < length && text[i] == '{';
}

static whirl_status take_notes(const note_list *notes, whirl_imported *out) {
    out->notes = calloc(notes->count + 1, sizeof *out->notes);
    for (const note *one = notes->first; one && out->notes; one = one->next) {
        char *const copy = malloc(strlen(one->text) + 1);
        if (!copy) return whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
        out->notes[out->note_count++] = strcpy(copy, one->text);
    }
    return out->notes ? whirl_ok() : whirl_fail(WHIRL_NO_MEMORY, "%s", whirl_code_text(WHIRL_NO_MEMORY));
}

/// Rejects a converted case that `whirl check` would reject, with the same messages.
static whirl_status check_case(const char *file, const whirl_imported *made) {
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    whirl_status status = whirl_case_parse(made->text, made->length, file, &problems, &object);
    if (status.code == WHIRL_BAD_INPUT && problems.count > 0)
        status = whirl_fail(WHIRL_BAD_INPUT, "%.120s: converts to an invalid case: %.120s: %.240s", file,
                            problems.items[0].key, problems.items[0].message);
    whirl_problems_free(&problems);
    whirl_case_free(object);
    return status;
}

static bool has_frequencies(const ross_rotor *rotor) {
    for (size_t i = 0; i < rotor->bearing_count; i++)
        if (rotor->bearings[i].frequency_count > 0) return true;
    return false;
}

/// Notes the curve fits that replace frequency-dependent tables in motions.
static void note_machine(note_list *notes, const char *text, size_t length, const char *file) {
    char sentence[WHIRL_MESSAGE_SIZE];
    whirl_problems problems = {0};
    whirl_case *object = NULL;
    whirl_rotor *rotor = NULL;
    whirl_status status = whirl_case_parse(text, length, file, &problems, &object);
    if (status.code == WHIRL_OK) status = whirl_case_rotor_outline(object, NULL, 0.0, &rotor);
    notes->no_memory = notes->no_memory || status.code == WHIRL_NO_MEMORY;
    for (size_t i = 0; rotor && whirl_rotor_note(rotor, i, sentence); i++)
        note_add(notes,
                 "In motions at the speed of the case a rational function replaces a table over frequencies of "
                 "whirl: %s.",
                 sentence);
    if (problems.count > 0)
        note_add(notes, "Motions at the speed of the case are refused: %s.", problems.items[0].message);
    whirl_problems_free(&problems);
    whirl_rotor_free(rotor);
    whirl_case_free(object);
}

/// Notes what a study of motions would have in place of the tables: parses the case again with `response` as its study.
static void note_in_time(note_list *notes, const whirl_imported *made, const char *file) {
    static const char study[] = "\nstudy:\n", response[] = "  response: {}\n";
    const char *const place = strstr(made->text, study);
    if (!place) return;
    const int kept = (int)(place - made->text) + (int)strlen(study);
    char *const moving = malloc((size_t)kept + sizeof response);
    notes->no_memory = notes->no_memory || !moving;
    if (!moving) return;
    sprintf(moving, "%.*s%s", kept, made->text, response);
    note_machine(notes, moving, strlen(moving), file);
    free(moving);
}

static whirl_status convert(import_reader *reader, value *root, whirl_imported *out) {
    ross_rotor rotor;
    ross_read(reader, root, &rotor);
    ross_join(reader, &rotor);
    if (field_good(reader)) ross_find_stations(reader, &rotor);
    if (!field_good(reader)) return reader->status;
    const whirl_status status = ross_write(reader, &rotor, &out->text, &out->length);
    if (status.code != WHIRL_OK) return status;
    if (out->length > MAX_CASE_BYTES)
        return whirl_fail(WHIRL_BAD_INPUT, "%.200s: makes a case of %zu bytes, expected at most %d", reader->file,
                          out->length, MAX_CASE_BYTES);
    const whirl_status good = check_case(reader->file, out);
    if (good.code != WHIRL_OK) return good;
    if (has_frequencies(&rotor)) note_in_time(&reader->notes, out, reader->file);
    if (reader->notes.no_memory) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the notes on a rotor");
    return take_notes(&reader->notes, out);
}

whirl_status whirl_import_parse(const char *text, size_t length, const char *name, whirl_imported *out) {
    memory_arena arena = {0};
    import_reader reader = {.file = name, .arena = &arena, .notes = {.arena = &arena}};
    value *root;
    *out = (whirl_imported){0};
    text = utf8_skip_mark(text, &length);
    if (length > MAX_BYTES)
        return whirl_fail(WHIRL_BAD_INPUT, "%.200s: is larger than %d MiB, expected a rotor saved by ROSS", name,
                          MAX_BYTES >> 20);
    whirl_status status = is_json(text, length) ? value_read_json(&arena, text, length, name, &root)
                                                : value_read_toml(&arena, text, length, name, &root);
    if (status.code == WHIRL_BAD_INPUT)
        status = whirl_fail(WHIRL_BAD_INPUT, "%s; expected a rotor that ROSS has saved (Rotor.save), as TOML or JSON",
                            status.message);
    if (status.code == WHIRL_OK) status = convert(&reader, root, out);
    arena_free(&arena);
    if (status.code != WHIRL_OK) whirl_imported_free(out);
    return status;
}

whirl_status whirl_import_load(const char *path, whirl_imported *out) {
    input_file in;
    char *text;
    size_t length;
    *out = (whirl_imported){0};
    if (!input_read(path, MAX_BYTES + 1, &in, &text, &length))
        return whirl_fail(in.no_memory ? WHIRL_NO_MEMORY : WHIRL_BAD_INPUT, "%.200s cannot be read: %s", path,
                          in.reason);
    const whirl_status status = whirl_import_parse(text, length, path, out);
    free(text);
    return status;
}

void whirl_imported_free(whirl_imported *imported) {
    for (size_t i = 0; i < imported->note_count; i++) free(imported->notes[i]);
    free(imported->notes);
    free(imported->text);
    *imported = (whirl_imported){0};
}
