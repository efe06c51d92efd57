// Writes units.inc, the table of units, by means of the real UDUNITS-2. This program runs on the build machine.
//
//   unit_table < NAMES > units.inc
//
// A line of NAMES is a tag of the database's XML files with its content: "<singular>meter<", "<value>1e24<". Units are
// looked up by their exact names, so that the table has the library's own numbers.
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <udunits2.h>

enum { BASE_COUNT = 8, NAME_SIZE = 128, MAX_UNITS = 4096 };
static const char *const bases[BASE_COUNT] = {"m", "kg", "s", "A", "K", "mol", "cd", "rad"};

typedef struct entry {
    char name[NAME_SIZE];
    double scale, origin;
    int powers[BASE_COUNT];
    bool logarithmic;
} entry;

typedef struct table {
    size_t count;
    entry items[MAX_UNITS];
} table;

static table names, symbols;

// ---------------------------------------------------------------- parts of a unit

static ut_status see_product(const ut_unit *unit, int count, const ut_unit *const *units, const int *powers,
                             void *context) {
    (void)unit;
    entry *e = context;
    for (int i = 0; i < count; i++)
        for (int b = 0; b < BASE_COUNT; b++)
            if (strcmp(ut_get_symbol(units[i], UT_ASCII), bases[b]) == 0) e->powers[b] = powers[i];
    return UT_SUCCESS;
}

static ut_status see_basic(const ut_unit *unit, void *context) {
    const int power = 1;
    return see_product(unit, 1, &unit, &power, context);
}

static ut_status see_galilean(const ut_unit *unit, double scale, const ut_unit *underlying, double origin,
                              void *context);
static ut_status see_time(const ut_unit *unit, const ut_unit *time, double origin, void *context) {
    (void)unit, (void)time, (void)origin, (void)context;
    return UT_NOT_SAME_SYSTEM; // the database has no timestamp units
}

static ut_status see_logarithm(const ut_unit *unit, double base, const ut_unit *reference, void *context) {
    (void)unit, (void)base, (void)reference;
    ((entry *)context)->logarithmic = true;
    return UT_SUCCESS;
}

static const ut_visitor visitor = {see_basic, see_product, see_galilean, see_time, see_logarithm};

static ut_status see_galilean(const ut_unit *unit, double scale, const ut_unit *underlying, double origin,
                              void *context) {
    (void)unit;
    entry *e = context;
    e->scale = scale;
    e->origin = origin;
    return ut_accept_visitor(underlying, &visitor, context);
}

static void unit_table_add(table *to, const char *name, ut_unit *unit) {
    if (!unit) return;
    for (size_t i = 0; i < to->count; i++)
        if (strcmp(to->items[i].name, name) == 0) unit = NULL;
    if (!unit || to->count == MAX_UNITS) return;
    entry *e = &to->items[to->count++];
    *e = (entry){.scale = 1.0};
    snprintf(e->name, sizeof e->name, "%s", name);
    if (ut_accept_visitor(unit, &visitor, e) != UT_SUCCESS) to->count--;
}

// ---------------------------------------------------------------- reading

/// Writes a character in UTF-8.
static size_t encode(unsigned long code, char *to) {
    if (code < 0x80) return to[0] = (char)code, 1;
    if (code < 0x800) return to[0] = (char)(0xC0 | code >> 6), to[1] = (char)(0x80 | (code & 63)), 2;
    to[0] = (char)(0xE0 | code >> 12);
    to[1] = (char)(0x80 | (code >> 6 & 63));
    to[2] = (char)(0x80 | (code & 63));
    return 3;
}

/// Reads the content of a tag, trimmed, with &#xB5; and similar resolved.
static void read_text(const char *from, char text[NAME_SIZE]) {
    size_t length = 0;
    from += strspn(from, " \t");
    while (*from && *from != '<' && length + 4 < NAME_SIZE) {
        char *end;
        const bool hexadecimal = strncmp(from, "&#x", 3) == 0;
        if (hexadecimal) {
            length += encode(strtoul(from + 3, &end, 16), text + length);
            from = *end == ';' ? end + 1 : end;
        } else {
            text[length++] = *from++;
        }
    }
    while (length > 0 && isspace((unsigned char)text[length - 1])) length--;
    text[length] = '\0';
}

/// Adds a name with its plural, if UDUNITS has one.
static void add_name(const ut_system *system, const char *name) {
    static const char *const endings[] = {"", "s", "es"};
    char text[NAME_SIZE + 8];
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        snprintf(text, sizeof text, "%s%s", name, endings[i]);
        unit_table_add(&names, text, ut_get_unit_by_name(system, text));
    }
    const size_t length = strlen(name);
    if (length == 0 || name[length - 1] != 'y') return;
    snprintf(text, sizeof text, "%.*sies", (int)(length - 1), name);
    unit_table_add(&names, text, ut_get_unit_by_name(system, text));
}

/// Adds a name; a name of several words also with underscores instead of spaces, in place.
static void add_names(const ut_system *system, char *name) {
    add_name(system, name);
    for (char *c = name; *c; c++)
        if (*c == ' ') *c = '_';
    add_name(system, name);
}

// ---------------------------------------------------------------- writing

static int by_name(const void *a, const void *b) {
    const entry *one = a, *other = b;
    const int order = strcasecmp(one->name, other->name);
    return order ? order : strcmp(one->name, other->name);
}

static int by_symbol(const void *a, const void *b) {
    return strcmp(((const entry *)a)->name, ((const entry *)b)->name);
}

static void write_text(const char *text) {
    putchar('"');
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        printf(*c < 0x80 && *c != '"' && *c != '\\' ? "%c" : "\\%03o", *c);
    putchar('"');
}

static void write_table(const char *heading, table *t, int (*order)(const void *, const void *)) {
    qsort(t->items, t->count, sizeof *t->items, order);
    printf("static const known_unit %s[] = {\n", heading);
    for (size_t i = 0; i < t->count; i++) {
        const entry *e = &t->items[i];
        printf("{");
        write_text(e->name);
        printf(", {%a, %a, {", e->scale, e->origin);
        for (int b = 0; b < BASE_COUNT; b++) printf("%d,", e->powers[b]);
        printf("}, %d}},\n", e->logarithmic);
    }
    printf("};\n");
}

int main(void) {
    char line[1024], text[NAME_SIZE], value[NAME_SIZE] = "";
    char prefixes[2][64][2][NAME_SIZE];
    size_t counts[2] = {0, 0};
    ut_set_error_message_handler(ut_ignore);
    ut_system *system = ut_read_xml(NULL);
    if (!system) return 1;
    // Collect prefixes, whose value stands before their names, and units.
    while (fgets(line, sizeof line, stdin)) {
        const char *content = strchr(line, '>');
        if (!content) continue;
        read_text(content + 1, text);
        const bool symbol = strncmp(line, "<symbol", 7) == 0;
        if (strncmp(line, "<value", 6) == 0)
            snprintf(value, sizeof value, "%s", text);
        else if (value[0] && (symbol || strncmp(line, "<name", 5) == 0) && counts[symbol] < 64) {
            snprintf(prefixes[symbol][counts[symbol]][0], NAME_SIZE, "%s", text);
            snprintf(prefixes[symbol][counts[symbol]++][1], NAME_SIZE, "%s", value);
        } else if (symbol)
            unit_table_add(&symbols, text, ut_get_unit_by_symbol(system, text));
        else
            add_names(system, text);
    }
    // Write the tables of units, then those of prefixes.
    write_table("unit_names", &names, by_name);
    write_table("unit_symbols", &symbols, by_symbol);
    for (int kind = 0; kind < 2; kind++) {
        printf("static const unit_prefix %s[] = {\n", kind ? "symbol_prefixes" : "name_prefixes");
        for (size_t i = 0; i < counts[kind]; i++) {
            printf("{");
            write_text(prefixes[kind][i][0]);
            printf(", %s},\n", prefixes[kind][i][1]);
        }
        printf("};\n");
    }
    return 0;
}
