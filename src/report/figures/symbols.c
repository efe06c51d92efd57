#include "figure_build.h"
#include "units.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name, *letter;
} greek[] = {
    {"alpha", "\u03b1"},  {"beta", "\u03b2"},  {"gamma", "\u03b3"}, {"delta", "\u03b4"}, {"epsilon", "\u03b5"},
    {"zeta", "\u03b6"},   {"eta", "\u03b7"},   {"theta", "\u03b8"}, {"kappa", "\u03ba"}, {"lambda", "\u03bb"},
    {"mu", "\u03bc"},     {"nu", "\u03bd"},    {"xi", "\u03be"},    {"rho", "\u03c1"},   {"sigma", "\u03c3"},
    {"tau", "\u03c4"},    {"phi", "\u03c6"},   {"chi", "\u03c7"},   {"psi", "\u03c8"},   {"omega", "\u03c9"},
    {"Delta", "\u0394"},  {"Gamma", "\u0393"}, {"Omega", "\u03a9"}, {"Phi", "\u03a6"},   {"Psi", "\u03a8"},
    {"Lambda", "\u039b"}, {"Sigma", "\u03a3"}, {"Theta", "\u0398"},
};

/// Returns the letter of a Greek name, or NULL.
static const char *greek_letter(const char *name, size_t length) {
    for (size_t i = 0; i < sizeof greek / sizeof *greek; i++)
        if (strlen(greek[i].name) == length && strncmp(greek[i].name, name, length) == 0) return greek[i].letter;
    return NULL;
}

/// Returns the length of the symbol at the beginning of a name: a letter or the name of a Greek letter, followed by
/// nothing, digits or a subscript. Returns 0 for a word.
static size_t letters_of(const char *name) {
    const size_t letters = strcspn(name, "_0123456789");
    const bool symbol = (letters == 1 && isalpha((unsigned char)*name)) || greek_letter(name, letters);
    return symbol && strspn(name + letters, "0123456789") + letters >= strcspn(name, "_") ? letters : 0;
}

void symbol_of(const char *name, char *text, size_t size) {
    const size_t letters = letters_of(name);
    if (letters == 0) {
        snprintf(text, size, "%s", name);
        return;
    }
    const char *rest = name + letters + (name[letters] == '_'), *letter = greek_letter(name, letters);
    const char *under = greek_letter(rest, strlen(rest));
    char symbol[8];
    snprintf(symbol, sizeof symbol, "%.*s", letter ? 7 : 1, letter ? letter : name);
    if (*rest)
        snprintf(text, size, "$%s_{%s}$", symbol, under ? under : rest);
    else
        snprintf(text, size, "$%s$", symbol);
}

whirl_shown_units symbol_units(const whirl_shown_units *units) {
    whirl_shown_units marked = *units;
    // A name such as "c" is a symbol; "(0.2 mm)" is none.
    if (units->ratio && *units->length_name != '(')
        symbol_of(units->length_name, marked.length_name, sizeof marked.length_name);
    return marked;
}

void symbol_parameter(const whirl_shown_units *units, const char *name, char *text, size_t size) {
    const whirl_unit unit = whirl_shown_parameter(units, name);
    char symbol[SYMBOL_SIZE / 2];
    symbol_of(name, symbol, sizeof symbol);
    snprintf(text, size, *unit.name ? "%s (%s)" : "%s", symbol, unit.name);
}

void symbol_length(const whirl_shown_units *units, whirl_counting counting, const char *quantity, char *text,
                   size_t size) {
    const whirl_shown_units marked = symbol_units(units);
    units_length_label(&marked, counting, quantity, text, size);
}
