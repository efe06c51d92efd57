// Reading a claims file: the same tree, tables and problems as for cases.
#include "whirl/engine/claims.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims.h"
#include "file.h"
#include "problem.h"
#include "schema.h"
#include "settings.h"
#include "tree.h"

enum { MAX_CLAIMS = 1000 };

/// Reads a value of the parameter, with a unit or plain. Expressions cannot use names, since claims have no parameters.
static bool claims_read_number(case_reader *reader, const setting_list *item, const char *name, double *value) {
    const setting *given = settings_find(item, name);
    const whirl_key key = {.name = name, .unit = "", .range = WHIRL_ANY};
    number_formula read = {0};
    if (!given) return false;
    if (!formula_read(reader, given->place, &key, &read)) return false;
    if (read.expression) problem_at(reader->problems, given->place, "is an expression, expected a number");
    *value = read.number;
    return true;
}

static void read_range(case_reader *reader, const setting_list *item, whirl_claim *claim) {
    const bool at = settings_find(item, "at"), from = settings_find(item, "from"), to = settings_find(item, "to");
    if (at == (from || to) || from != to) {
        problem_at(reader->problems, item->place, "expected either at, or from and to");
        return;
    }
    if (at) {
        claims_read_number(reader, item, "at", &claim->from);
        claim->to = claim->from;
        return;
    }
    double first = 0.0, last = 0.0;
    if (!claims_read_number(reader, item, "from", &first) || !claims_read_number(reader, item, "to", &last)) return;
    claim->from = fmin(first, last);
    claim->to = fmax(first, last);
}

/// Reads an expected regime: "P-2", or a word.
static bool parse_regime(const char *word, whirl_claim *claim) {
    static const struct {
        const char *word;
        whirl_regime regime;
    } regimes[] = {{"periodic", WHIRL_PERIODIC},
                   {"quasi-periodic", WHIRL_QUASI_PERIODIC},
                   {"chaotic", WHIRL_CHAOTIC},
                   {"diverged", WHIRL_DIVERGING}};
    for (size_t i = 0; i < sizeof regimes / sizeof *regimes; i++) {
        claim->regime = regimes[i].regime;
        if (strcmp(word, regimes[i].word) == 0) return true;
    }
    claim->regime = WHIRL_PERIODIC;
    const size_t digits = strncmp(word, "P-", 2) == 0 ? strspn(word + 2, "0123456789") : 0;
    if (digits == 0 || digits > 2 || word[2 + digits]) return false;
    claim->period = (int)strtol(word + 2, NULL, 10);
    return claim->period >= 1 && claim->period <= WHIRL_MAX_PERIOD;
}

static void read_regime(case_reader *reader, const setting_list *item, whirl_claim *claim) {
    static const char *const names[] = {"P-1", "periodic", "quasi-periodic", "chaotic", "diverged"};
    char shown[SHOWN_SIZE], advice[WHY_SIZE];
    const setting *given = settings_find(item, "regime");
    if (!given) return;
    claim->has_regime = given->place->kind == NODE_TEXT && parse_regime(given->place->text, claim);
    if (claim->has_regime) return;
    describe_names(given->place->kind == NODE_TEXT ? given->place->text : "", names, sizeof names / sizeof *names,
                   advice);
    problem_at(reader->problems, given->place, "is %s, %s", node_shown(given->place, shown), advice);
}

/// Reads a whole number; 0 if it is absent.
static int read_whole(case_reader *reader, const setting_list *item, const char *name) {
    const setting *given = settings_find(item, name);
    if (!given || !given->good) return 0;
    if (given->value.expression) problem_at(reader->problems, given->place, "is an expression, expected a number");
    return (int)given->value.number;
}

/// Reads between `least` and `most` orders of the running speed.
static size_t read_orders(case_reader *reader, const setting_list *item, const char *name, size_t least, size_t most,
                          double *orders) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(item, name);
    if (!given) return 0;
    const file_node *list = given->place;
    if (list->kind != NODE_LIST || list->count < least || list->count > most) {
        problem_at(reader->problems, list, "is %s of %zu, expected a list of %zu to %zu orders",
                   node_shown(list, shown), list->count, least, most);
        return 0;
    }
    const whirl_key key = {.name = name, .unit = "1", .range = WHIRL_NOT_NEGATIVE};
    size_t count = 0;
    for (const file_node *order = list->first; order; order = order->next) {
        number_formula read = {0};
        if (formula_read(reader, order, &key, &read) && read.expression)
            problem_at(reader->problems, order, "is an expression, expected a number");
        orders[count++] = read.number;
    }
    return count;
}

/// Reads two orders, the lower one first.
static bool read_pair(case_reader *reader, const setting_list *item, const char *name, double orders[2]) {
    const bool there = read_orders(reader, item, name, 2, 2, orders) == 2;
    if (there && !(orders[0] < orders[1]))
        problem_at(reader->problems, settings_find(item, name)->place, "expected the lower order first");
    return there;
}

static whirl_claim_contact read_contact(const setting_list *item) {
    const char *word = settings_word(item, "rub");
    if (word && strcmp(word, "always") == 0) return WHIRL_CONTACT_ALWAYS;
    if (word && strcmp(word, "at_times") == 0) return WHIRL_CONTACT_AT_TIMES;
    return settings_yes(item, "rub") ? WHIRL_CONTACT_SOME : WHIRL_CONTACT_NEVER;
}

// ---------------------------------------------------------------- branches

/// Reads a kind of special points.
static bool read_kind(case_reader *reader, const file_node *where, whirl_special *kind) {
    static const char *const names[] = {"fold", "crossing", "doubling", "neimark-sacker", "hopf", "grazing"};
    static const whirl_special kinds[] = {WHIRL_FOLD,           WHIRL_BRANCHING, WHIRL_DOUBLING,
                                          WHIRL_NEIMARK_SACKER, WHIRL_HOPF,      WHIRL_GRAZE};
    char shown[SHOWN_SIZE], advice[WHY_SIZE];
    const char *word = where->kind == NODE_TEXT ? where->text : "";
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        *kind = kinds[i];
        if (strcmp(word, names[i]) == 0) return true;
    }
    describe_names(word, names, sizeof names / sizeof *names, advice);
    problem_at(reader->problems, where, "is %s, %s", node_shown(where, shown), advice);
    return false;
}

static void read_kinds(case_reader *reader, const setting_list *item, const char *name, whirl_claim_kinds *kinds) {
    char shown[SHOWN_SIZE];
    const setting *given = settings_find(item, name);
    if (!given) return;
    const file_node *list = given->place;
    if (list->kind != NODE_LIST || list->count == 0 || list->count > WHIRL_MAX_CLAIM_KINDS) {
        problem_at(reader->problems, list, "is %s, expected a list of 1 to %d kinds of special points",
                   node_shown(list, shown), WHIRL_MAX_CLAIM_KINDS);
        return;
    }
    for (const file_node *kind = list->first; kind; kind = kind->next)
        if (read_kind(reader, kind, &kinds->list[kinds->count])) kinds->count++;
}

static void read_given(case_reader *reader, const setting_list *item, whirl_claim *claim) {
    const bool from = settings_find(item, "given_from"), to = settings_find(item, "given_to");
    const bool named = settings_find(item, "given") != NULL;
    if (named != from || from != to) {
        problem_at(reader->problems, item->place, "expected given, given_from and given_to together");
        return;
    }
    if (!named) return;
    double first = 0.0, last = 0.0;
    settings_text(reader, item, "given", claim->given, sizeof claim->given);
    if (!claims_read_number(reader, item, "given_from", &first) || !claims_read_number(reader, item, "given_to", &last))
        return;
    claim->given_from = fmin(first, last);
    claim->given_to = fmax(first, last);
}

static void read_branches(case_reader *reader, const setting_list *item, whirl_claim *claim) {
    const char *sense = settings_word(item, "sense");
    read_kinds(reader, item, "changes", &claim->changes);
    read_kinds(reader, item, "unchanged", &claim->unchanged);
    if (sense && *sense) claim->sense = strcmp(sense, "subcritical") == 0 ? 1 : -1;
    claim->order_count = read_orders(reader, item, "orders", 1, WHIRL_MAX_CLAIM_LINES, claim->orders);
    claim->regions = read_whole(reader, item, "regions");
    if (claim->sense && claim->changes.count == 0)
        problem_at(reader->problems, item->place, "has a sense and no changes, expected both");
    read_given(reader, item, claim);
}

static void read_claim(case_reader *reader, const file_node *where, whirl_claim *claim) {
    setting_list item;
    settings_read(reader, where, &schema_claim, &item);
    if (where->kind != NODE_MAPPING || reader->no_memory) return;
    settings_text(reader, &item, "where", claim->where, sizeof claim->where);
    settings_text(reader, &item, "says", claim->says, sizeof claim->says);
    read_range(reader, &item, claim);
    read_regime(reader, &item, claim);
    claim->curves = read_whole(reader, &item, "curves");
    claim->has_contact = settings_find(&item, "rub") != NULL;
    claim->contact = read_contact(&item);
    claim->has_dry_whip = settings_find(&item, "dry_whip") != NULL;
    claim->dry_whip = settings_yes(&item, "dry_whip");
    claim->line_count = read_orders(reader, &item, "lines", 1, WHIRL_MAX_CLAIM_LINES, claim->lines);
    claim->only_lines = settings_yes(&item, "only_lines");
    claim->has_band = read_pair(reader, &item, "band", claim->band);
    claim->has_largest = read_pair(reader, &item, "largest", claim->largest);
    const setting *whirl = settings_find(&item, "whirl");
    claim->has_whirl = whirl && whirl->word;
    if (claim->has_whirl) snprintf(claim->whirl, sizeof claim->whirl, "%.63s", whirl->word);
    read_branches(reader, &item, claim);
}

static void read_items(case_reader *reader, const file_node *where, whirl_claims *claims) {
    char shown[SHOWN_SIZE];
    if (where->kind != NODE_LIST || where->count == 0 || where->count > MAX_CLAIMS) {
        problem_at(reader->problems, where, "is %s, expected a list of 1 to %d claims",
                   where->kind == NODE_LIST ? where->count ? "a longer list" : "an empty list"
                                            : node_shown(where, shown),
                   MAX_CLAIMS);
        return;
    }
    claims->items = calloc(where->count, sizeof *claims->items);
    reader->no_memory = reader->no_memory || !claims->items;
    for (const file_node *item = where->first; item && claims->items; item = item->next)
        read_claim(reader, item, &claims->items[claims->count++]);
}

static void claims_fill(case_reader *reader, const setting_list *file, void *into) {
    whirl_claims *claims = into;
    const setting *items = settings_find(file, "items");
    settings_text(reader, file, "source", claims->source, sizeof claims->source);
    settings_text(reader, file, "parameter", claims->parameter, sizeof claims->parameter);
    settings_text(reader, file, "station", claims->station, sizeof claims->station);
    if (items) read_items(reader, items->place, claims);
}

static void claims_release(void *made) {
    whirl_claims_free(made);
}

static const file_kind kind = {&schema_claims, SCHEMA_VERSION, sizeof(whirl_claims), claims_fill, claims_release};

whirl_status claims_parse(const char *text, size_t length, const char *name, whirl_problems *problems,
                          whirl_claims **out) {
    void *made;
    const whirl_status status = file_parse(&kind, text, length, name, problems, &made);
    *out = made;
    return status;
}

whirl_status whirl_claims_load(const char *path, whirl_problems *problems, whirl_claims **claims) {
    void *made;
    const whirl_status status = file_load(&kind, path, problems, &made);
    *claims = made;
    return status;
}

void whirl_claims_free(whirl_claims *claims) {
    if (!claims) return;
    free(claims->items);
    free(claims);
}
