/// whirl describe: prints the tables of keys by which cases are read, and lists of analyses and methods.
#include "command.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "terminal.h"
#include "whirl/internal/balance.h"
#include "whirl/internal/bearing_table.h"

// ---------------------------------------------------------------- subjects: names that can be described

typedef enum subject_kind { SUBJECT_GROUP, SUBJECT_ANALYSIS, SUBJECT_METHOD } subject_kind;

typedef struct subject {
    subject_kind kind;
    const char *part; ///< "element", "station", ...
    const char *name, *meaning, *source;
    const whirl_group *group; ///< for SUBJECT_GROUP
} subject;

enum { MAX_SUBJECTS = 128, LONGEST_DEFAULT = 10 };

typedef struct catalogue {
    subject items[MAX_SUBJECTS];
    size_t count;
} catalogue;

static void add_subject(catalogue *all, subject one) {
    if (all->count < MAX_SUBJECTS) all->items[all->count++] = one;
}

static void add_group(catalogue *all, const char *part, const whirl_group *group) {
    add_subject(all, (subject){SUBJECT_GROUP, part, group->name, group->meaning, group->source, group});
}

static void add_groups(catalogue *all, const char *part, const whirl_group *const *groups) {
    for (; *groups && (*groups)->name; groups++) add_group(all, part, *groups);
}

/// Collects everything that can be described, in the order of a case file.
static void collect(catalogue *all) {
    add_group(all, "stations", whirl_station_keys());
    add_group(all, "shafts", whirl_shaft_keys());
    add_group(all, "materials", whirl_material_keys());
    add_groups(all, "elements", whirl_element_groups());
    add_groups(all, "groups of a case file", whirl_case_groups());
    add_groups(all, "groups of a claims file", whirl_claims_groups());
    add_groups(all, "groups of a balancing file", whirl_balance_groups());
    add_groups(all, "groups of a bearing's file", whirl_bearing_groups());
    const whirl_method *method;
    for (size_t i = 0; (method = whirl_method_at(i)) != NULL; i++)
        add_subject(all, (subject){SUBJECT_METHOD, "methods of integration", method->name, method->meaning, "", NULL});
    for (const whirl_analysis *analysis = whirl_analyses(); analysis->name; analysis++)
        add_subject(all,
                    (subject){SUBJECT_ANALYSIS, "analyses", analysis->name, analysis->meaning, analysis->source, NULL});
}

// ---------------------------------------------------------------- printing

/// Prints a text and blanks up to `width` columns, at least one blank.
static void print_padded(const char *text, int width) {
    const int columns = text_columns(text);
    printf("%s%*s", text, columns < width ? width - columns : 1, "");
}

static void list_all(const catalogue *all, int width) {
    enum { NAME_COLUMNS = 16, INDENT = 2 };
    const char *part = "";
    for (size_t i = 0; i < all->count; i++) {
        const subject *const one = &all->items[i];
        if (strcmp(part, one->part) != 0) printf("%s%s:\n", *part ? "\n" : "", one->part);
        part = one->part;
        printf("%*s", INDENT, "");
        print_padded(one->name, NAME_COLUMNS);
        print_wrapped(one->meaning, INDENT + NAME_COLUMNS, INDENT + NAME_COLUMNS, width);
        putchar('\n');
    }
    putchar('\n');
    print_wrapped("'whirl describe NAME' shows the keys of one with units, defaults, ranges and sources.", 0, 0, width);
    putchar('\n');
}

/// Writes a range in words: "> 0", "0 to 1", "any".
static void range_text(const whirl_range *range, char *text, size_t size) {
    const bool low = isfinite(range->low) || range->low > 0, high = isfinite(range->high) || range->high < 0;
    if (low && high)
        snprintf(text, size, "%s%.8g to %s%.8g", range->low_open ? "above " : "", range->low,
                 range->high_open ? "below " : "", range->high);
    else if (low)
        snprintf(text, size, "%s %.8g", range->low_open ? ">" : ">=", range->low);
    else if (high)
        snprintf(text, size, "%s %.8g", range->high_open ? "<" : "<=", range->high);
    else
        snprintf(text, size, "any");
}

/// Writes the choices of a key. Blanks are added where they are too wide for a narrow line, so that they can be broken.
static void choices_text(const char *choices, char *text, size_t size) {
    enum { NARROW = 54 };
    const bool wide = strlen(choices) > NARROW;
    size_t used = 0;
    for (const char *c = choices; *c && used + 4 < size; c++)
        used += (size_t)snprintf(text + used, size - used, wide && *c == '|' ? " %c " : "%c", *c);
    text[used] = '\0';
}

static void allowed_text(const whirl_key *key, char *text, size_t size) {
    switch (key->kind) {
    case WHIRL_KEY_CHOICE:
        choices_text(key->choices, text, size);
        return;
    case WHIRL_KEY_STATION:
        snprintf(text, size, "a station");
        return;
    case WHIRL_KEY_STATIONS:
        snprintf(text, size, "two stations");
        return;
    case WHIRL_KEY_NAME:
        snprintf(text, size, "of %s", key->choices);
        return;
    case WHIRL_KEY_WHOLE:
    case WHIRL_KEY_NUMBER:
    case WHIRL_KEY_NUMBERS:
        range_text(&key->range, text, size);
        return;
    }
}

/// Writes a default; long numbers are rounded: -1.5707963267948966 becomes -1.5708.
static void default_text(const whirl_key *key, char *text, size_t size) {
    const bool number = key->kind == WHIRL_KEY_NUMBER && strlen(key->fallback) > LONGEST_DEFAULT;
    if (number)
        snprintf(text, size, "%.5g", strtod(key->fallback, NULL));
    else
        snprintf(text, size, "%s", key->required ? "required" : *key->fallback ? key->fallback : "-");
}

/// A printed key: cells side by side, and its meaning in a line below.
enum { CELLS = 5, RANGE_CELL = CELLS - 1, CELL_SIZE = 128, KEY_INDENT = 2, MEANING_INDENT = 6 };
typedef char key_cells[CELLS][CELL_SIZE];

static void fill_cells(const whirl_key *key, key_cells cells) {
    snprintf(cells[0], CELL_SIZE, "%s", key->name);
    snprintf(cells[1], CELL_SIZE, "%s", *key->symbol ? key->symbol : "-");
    snprintf(cells[2], CELL_SIZE, "%s", *key->unit ? key->unit : "-");
    default_text(key, cells[3], CELL_SIZE);
    allowed_text(key, cells[RANGE_CELL], CELL_SIZE);
}

static int longest_word(const char *text) {
    int longest = 0;
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        const int length = (int)strcspn(text, " ");
        if (length > longest) longest = length;
        text += length;
    }
    return longest;
}

/// Prints a row of cells; the last one continues below its column, or on a line of its own if it is too wide.
static void print_cells(key_cells cells, const int columns[CELLS], int width) {
    int at = KEY_INDENT;
    printf("%*s", KEY_INDENT, "");
    for (int i = 0; i < RANGE_CELL; i++) {
        print_padded(cells[i], columns[i]);
        at += columns[i];
    }
    if (at + longest_word(cells[RANGE_CELL]) > width) {
        at = MEANING_INDENT;
        printf("\n%*s", at, "");
    }
    print_wrapped(cells[RANGE_CELL], at, at, width);
    putchar('\n');
}

static void print_keys(const whirl_group *group, int width) {
    key_cells cells = {"name", "symbol", "unit", "default", "range"};
    int columns[CELLS] = {0};
    const key_cells headings = {"name", "symbol", "unit", "default", "range"};
    const whirl_key *key = NULL;
    for (size_t k = 0; k == 0 || key; k++) {
        for (int i = 0; i < CELLS; i++)
            if (text_columns(cells[i]) + 2 > columns[i]) columns[i] = text_columns(cells[i]) + 2;
        if ((key = whirl_group_at(group, k)) != NULL) fill_cells(key, cells);
    }
    memcpy(cells, headings, sizeof headings);
    print_cells(cells, columns, width);
    for (size_t k = 0; (key = whirl_group_at(group, k)) != NULL; k++) {
        char text[2 * WHIRL_MESSAGE_SIZE];
        fill_cells(key, cells);
        print_cells(cells, columns, width);
        snprintf(text, sizeof text, *key->source ? "%s [%s]" : "%s", key->meaning, key->source);
        printf("%*s", MEANING_INDENT, "");
        print_wrapped(text, MEANING_INDENT, MEANING_INDENT, width);
        putchar('\n');
    }
}

static void print_sentence(const char *before, const char *text, int width) {
    char sentence[2 * WHIRL_MESSAGE_SIZE];
    snprintf(sentence, sizeof sentence, "%s: %s", before, text);
    print_wrapped(sentence, 0, 2, width);
    putchar('\n');
}

static void print_subject(const subject *one, int width) {
    print_sentence(one->name, one->meaning, width);
    if (*one->source) print_sentence("Source", one->source, width);
    if (one->kind == SUBJECT_METHOD) puts("Written as `integrate: {method: ...}`.");
    whirl_analysis_set own = 0;
    if (one->kind == SUBJECT_ANALYSIS && whirl_analysis_add(&own, one->name)) puts(whirl_analysis_kind(own)->asked);
    if (!one->group || !whirl_group_at(one->group, 0)) return;
    putchar('\n');
    print_keys(one->group, width);
    if (one->group->shorthand) printf("\n`%s: VALUE` alone sets %s.\n", one->group->name, one->group->shorthand);
}

/// Prints all subjects of a name (an element and an analysis may share one). Returns EXIT_BAD_INPUT if there is none.
static int describe(const catalogue *all, const char *name, int width) {
    const char *names[MAX_SUBJECTS];
    size_t found = 0;
    for (size_t i = 0; i < all->count; i++) {
        const subject *const one = &all->items[i];
        names[i] = one->name;
        if (strcmp(one->name, name) != 0) continue;
        if (found++) putchar('\n');
        print_subject(one, width);
    }
    if (found) return EXIT_DONE;
    const char *nearest = whirl_nearest_name(name, names, all->count);
    if (nearest)
        complain("there is nothing called '%s' to describe, did you mean '%s'?", name, nearest);
    else
        complain("there is nothing called '%s' to describe; 'whirl describe' lists what there is", name);
    return EXIT_BAD_INPUT;
}

// ---------------------------------------------------------------- command

static error_t describe_parse(int key, char *argument, struct argp_state *state) {
    const char **name = state->input;
    if (key != ARGP_KEY_ARG) return ARGP_ERR_UNKNOWN;
    if (*name) bad_argument(state, "takes one name, '%s' is one too many", argument);
    *name = argument;
    return 0;
}

static int describe_run(int argc, char **argv) {
    static const struct argp argp = {
        .parser = describe_parse,
        .args_doc = "[NAME]",
        .doc = "Lists what a case file may hold: the keys of stations, the elements, the groups of the study and of a "
               "claims file, the methods of integration and the analyses. With NAME: its keys with symbol, unit, "
               "default, range, meaning and "
               "source.",
    };
    const char *name = NULL;
    const int read = read_arguments(&argp, argc, argv, 0, &name);
    if (read != EXIT_DONE) return read;
    catalogue all = {.count = 0};
    collect(&all);
    const int width = terminal_columns(STDOUT_FILENO);
    int outcome = EXIT_DONE;
    if (name)
        outcome = describe(&all, name, width);
    else
        list_all(&all, width);
    return outcome == EXIT_DONE ? finish_output() : outcome;
}

const command describe_command = {"describe", "list elements, keys, methods and analyses, or show one in full",
                                  describe_run};
