#include "parameters.h"
#include "expression.h"
#include "quantity.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "problem.h"
#include "tree.h"

size_t parameters_find(const parameter_table *parameters, const char *name) {
    for (size_t i = 0; i < parameters->count; i++)
        if (strcmp(parameters->items[i].name, name) == 0) return i;
    return parameters->count;
}

whirl_status reader_outcome(const case_reader *reader, const char *name) {
    const whirl_problems *problems = reader->problems;
    char first[sizeof(whirl_problem)];
    if (reader->no_memory || (problems->count > 0 && !problems->items))
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", name);
    if (problems->count == 0) return whirl_ok();
    whirl_problem_text(problems, 0, first, sizeof first);
    return whirl_fail(WHIRL_BAD_INPUT, "%s", first);
}

bool reader_reports(case_reader *reader, const char *what, const char *name) {
    for (const reported_name *one = reader->reported; one; one = one->next)
        if (strcmp(one->name, name) == 0 && strcmp(one->what, what) == 0) return false;
    reported_name *one = arena_take(reader->arena, sizeof *one);
    const char *copy = arena_text(reader->arena, name, strlen(name));
    reader->no_memory = reader->no_memory || !one || !copy;
    if (!one || !copy) return true;
    *one = (reported_name){.name = copy, .what = what, .next = reader->reported};
    reader->reported = one;
    return true;
}

// ---------------------------------------------------------------- sets

static void parameters_put(parameter_set *set, size_t index) {
    set->bits[index / 64] |= (uint64_t)1 << index % 64;
}

static bool has(const parameter_set *set, size_t index) {
    return set->bits[index / 64] >> index % 64 & 1;
}

static bool share(const parameter_set *a, const parameter_set *b) {
    for (size_t i = 0; i < PARAMETERS_MAX / 64; i++)
        if (a->bits[i] & b->bits[i]) return true;
    return false;
}

// ---------------------------------------------------------------- names in expressions

typedef struct lookup {
    const parameter_table *parameters;
    parameter_set uses;
    char name[WHIRL_NAME_SIZE]; ///< last name that was requested
    const char *at;             ///< its beginning
} lookup;

static bool parameter_is_known(void *context, const char *name, size_t length) {
    lookup *l = context;
    l->at = name;
    if (length >= sizeof l->name) length = sizeof l->name - 1;
    memcpy(l->name, name, length);
    l->name[length] = '\0';
    const size_t index = parameters_find(l->parameters, l->name);
    if (index == l->parameters->count) return false;
    parameters_put(&l->uses, index);
    return true;
}

/// Returns the text after "=", or NULL if there is no expression.
static const char *expression_of(const char *text) {
    return text[0] == '=' ? text + 1 + strspn(text + 1, " ") : NULL;
}

/// Copies an expression into one line, with spaces in place of line breaks. NULL without memory.
static const char *one_line(case_reader *reader, const char *text) {
    char *copy = arena_text(reader->arena, text, strlen(text));
    reader->no_memory = reader->no_memory || !copy;
    for (char *c = copy; c && *c; c++)
        if (*c == '\n' || *c == '\t') *c = ' ';
    return copy;
}

/// Returns false once there are too many expressions; reports it once.
static bool can_afford(case_reader *reader, const file_node *where, const char *expression) {
    const size_t before = reader->expression_bytes;
    reader->expression_bytes += strlen(expression);
    if (reader->expression_bytes > EXPRESSIONS_MAX_BYTES && before <= EXPRESSIONS_MAX_BYTES)
        problem_at(reader->problems, where, "is too much: all expressions together have more than %d characters",
                   EXPRESSIONS_MAX_BYTES);
    return reader->expression_bytes <= EXPRESSIONS_MAX_BYTES;
}

/// Returns true for a name right after a number, which is meant as a unit: "10 N".
static bool follows_number(const char *expression, const char *name) {
    const char *before = name;
    while (before > expression && before[-1] == ' ') before--;
    return before < name && before > expression && (isdigit((unsigned char)before[-1]) || before[-1] == '.');
}

static bool read_expression(case_reader *reader, const parameter_table *known, const file_node *where, const char *text,
                            number_formula *result) {
    // Check the expression and the names in it.
    lookup l = {.parameters = known};
    char why[WHY_SIZE], shown[SHOWN_SIZE];
    const char *expression = one_line(reader, text);
    if (!expression || !can_afford(reader, where, expression)) return false;
    if (expression_check(expression, parameter_is_known, &l, why)) {
        *result = (number_formula){.expression = expression, .uses = l.uses};
        return true;
    }
    // An unknown name may be a unit, which expressions do not have.
    const bool unit = !why[0] && follows_number(expression, l.at);
    if (!why[0] && !unit && !reader_reports(reader, "parameter", l.name)) return false;
    // Report the fault, with the nearest name.
    const char *near = why[0] || unit ? NULL : whirl_nearest_name(l.name, known->names, known->count);
    if (why[0])
        problem_at(reader->problems, where, "%s", why);
    else if (near)
        problem_at(reader->problems, where, "is = %s, but no parameter is called %s, did you mean %s?",
                   text_shown(expression, shown), l.name, near);
    else
        problem_at(reader->problems, where,
                   "is = %s, but no parameter is called %.63s (expressions are in SI and hold no units)",
                   text_shown(expression, shown), l.name);
    return false;
}

/// Returns the parameter that is the whole of an expression, or NULL.
static parameter *sole_name(const parameter_table *parameters, const char *expression) {
    char name[WHIRL_NAME_SIZE];
    const size_t length = strcspn(expression, " ");
    if (length >= sizeof name || expression[length + strspn(expression + length, " ")]) return NULL;
    memcpy(name, expression, length);
    name[length] = '\0';
    const size_t index = parameters_find(parameters, name);
    return index < parameters->count ? &parameters->items[index] : NULL;
}

const parameter *formula_parameter(const parameter_table *parameters, const number_formula *formula) {
    return formula->expression ? sole_name(parameters, formula->expression) : NULL;
}

/// Returns the unit of omega for "= omega", and "" (unknown) for longer expressions.
const char *expression_unit(const parameter_table *parameters, const char *expression) {
    const parameter *item = sole_name(parameters, expression);
    return item ? item->unit : "";
}

const char *parameter_expected_unit(const parameter *item) {
    return item->unit[0] ? item->unit : item->taken_as;
}

/// Notes the unit of a key whose value is a parameter alone, for this parameter and for those that it equals in turn.
static void note_use(const parameter_table *parameters, const char *expression, const char *unit) {
    parameter *item = sole_name(parameters, expression);
    for (size_t depth = 0; item && depth < parameters->count && !item->taken_as[0]; depth++) {
        item->taken_as = unit;
        item = item->value.expression ? sole_name(parameters, item->value.expression) : NULL;
    }
}

/// Returns the size in SI of the unit of a text such as "12 mm"; 0 without a unit, or for a unit with an offset, like
/// degrees Celsius.
static double size_of_unit(const char *text, const char *expected, char unit[WHIRL_NAME_SIZE]) {
    char quantities[2][WHIRL_NAME_SIZE + 2], why[WHY_SIZE];
    quantity one, none;
    double number;
    const char *end;
    if (!quantity_number(text, &number, &end) || *end != ' ') return 0.0;
    const char *name = end + strspn(end, " ");
    if (strlen(name) >= WHIRL_NAME_SIZE) return 0.0;
    strcpy(unit, name);
    for (int i = 0; i < 2; i++) snprintf(quantities[i], sizeof quantities[i], "%d %s", i, name);
    const bool read =
        quantity_read(quantities[0], expected, &none, why) && quantity_read(quantities[1], expected, &one, why);
    return read && none.value == 0.0 && one.value > 0.0 ? one.value : 0.0;
}

whirl_unit formula_unit(const parameter_table *parameters, const char *text, const char *expected) {
    whirl_unit unit = {.name = "", .size = 0.0};
    for (size_t depth = 0; expression_of(text) && depth <= parameters->count; depth++) {
        const parameter *item = sole_name(parameters, expression_of(text));
        if (!item) return unit;
        text = item->text;
    }
    unit.size = size_of_unit(text, expected, unit.name);
    return unit;
}

/// Adds a hint to the error for a negative speed: the sense of rotation has its own key.
static whirl_status with_direction(const whirl_key *key, double value, whirl_status status) {
    if (status.code == WHIRL_OK || !(value < 0.0) || strcmp(key->name, "speed") != 0) return status;
    return whirl_fail(status.code, "%s, and rotation: clockwise for a rotor that turns from y to x", status.message);
}

static whirl_status check_as_written(const whirl_key *key, double value, const char *text) {
    char unit[WHIRL_NAME_SIZE];
    const whirl_status status = whirl_key_check_number(key, value);
    const double size = status.code == WHIRL_OK ? 0.0 : size_of_unit(text, key->unit, unit);
    if (size == 0.0) return with_direction(key, value, status);
    whirl_key spoken = *key;
    spoken.unit = unit;
    spoken.range.low /= size;
    spoken.range.high /= size;
    const whirl_status checked = whirl_key_check_number(&spoken, value / size);
    return with_direction(key, value, checked.code == WHIRL_OK ? status : checked);
}

whirl_status formula_check(const parameter_table *parameters, const whirl_key *key, const number_formula *formula,
                           double value) {
    const parameter *item = formula_parameter(parameters, formula);
    return check_as_written(key, value, item ? item->text : "");
}

bool angle_is_likely(const whirl_key *key, double number, char why[WHY_SIZE]) {
    const double full_turn = 6.2831853071795865; // 2 pi
    if (strcmp(key->unit, "rad") != 0 || !isfinite(number) || fabs(number) <= full_turn * (1.0 + 1e-12)) return true;
    snprintf(why, WHY_SIZE,
             "is %.10g without a unit, which is in radians, expected at most a full turn (2 pi); write degrees as "
             "'%.10g degree'",
             number, number);
    return false;
}

/// Returns true for a number without a unit.
static bool is_plain(const char *text) {
    const char *end;
    double value;
    return quantity_number(text, &value, &end) && !*end;
}

bool formula_has_unit(const case_reader *reader, const char *text) {
    const char *const expression = expression_of(text), *end;
    const char *const unit = expression ? expression_unit(reader->parameters, expression) : "";
    double value;
    if (expression) return unit[0] && strcmp(unit, "1") != 0;
    return quantity_number(text, &value, &end) && *end == ' ';
}

bool formula_read(case_reader *reader, const file_node *where, const whirl_key *key, number_formula *result) {
    char why[WHY_SIZE], shown[SHOWN_SIZE];
    if (where->kind != NODE_TEXT) {
        problem_at(reader->problems, where, "is %s, expected a number", node_shown(where, shown));
        return false;
    }
    const char *expression = expression_of(where->text);
    // Read an expression: check its names, and its unit if that is known.
    if (expression) {
        if (!read_expression(reader, reader->parameters, where, expression, result)) return false;
        note_use(reader->parameters, result->expression, key->unit);
        const char *unit = expression_unit(reader->parameters, result->expression);
        if (!unit[0] || !key->unit[0] || strcmp(unit, "1") == 0 || quantity_fits(unit, key->unit, why)) return true;
        if (reader_reports(reader, key->unit, result->expression))
            problem_at(reader->problems, where, "= %s %s", text_shown(expression, shown), why);
        return false;
    }
    // Read a number, with or without a unit.
    quantity read;
    if (!quantity_read(where->text, key->unit, &read, why)) {
        problem_at(reader->problems, where, "%s", why);
        return false;
    }
    *result = (number_formula){.number = read.value};
    if (is_plain(where->text) && !angle_is_likely(key, read.value, why)) {
        problem_at(reader->problems, where, "%s", why);
        return false;
    }
    const whirl_status status = check_as_written(key, read.value, where->text);
    if (status.code != WHIRL_OK) problem_at(reader->problems, where, "%s", status.message);
    return status.code == WHIRL_OK;
}

// ---------------------------------------------------------------- reading

static bool is_identifier(const char *name) {
    if (!isalpha((unsigned char)name[0]) && name[0] != '_') return false;
    for (const char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '_') return false;
    return strlen(name) < WHIRL_NAME_SIZE;
}

static void check_name(case_reader *reader, const file_node *where) {
    char shown[SHOWN_SIZE];
    if (!is_identifier(where->key))
        problem_at_key(reader->problems, where,
                       "is no name for a parameter, expected a letter, then letters, digits and '_'");
    else if (expression_has_word(where->key))
        problem_at_key(reader->problems, where, "%s is a function or constant of expressions, expected another name",
                       text_shown(where->key, shown));
}

/// Makes a node for a value from outside of the file.
static const file_node *outside(case_reader *reader, const parameter_override *override) {
    file_node *made = arena_take(reader->arena, sizeof *made);
    if (made) *made = (file_node){.kind = NODE_TEXT, .text = override->text, .key = override->name};
    reader->no_memory = reader->no_memory || !made;
    return made;
}

/// Reads the value of a parameter. A value set from outside must have the dimension of the file's value, `expected`;
/// "" allows any.
static bool read_quantity(case_reader *reader, const file_node *where, const char *expected, parameter *result) {
    char why[WHY_SIZE];
    quantity read;
    if (!quantity_read(where->text, expected, &read, why)) {
        problem_at(reader->problems, where, "%s", why);
        return false;
    }
    // A plain number has the SI unit of the value it replaces.
    const bool plain = strcmp(read.unit, "1") == 0 && expected[0];
    const char *given = plain ? expected : read.unit;
    char *unit = arena_text(reader->arena, given, strlen(given));
    reader->no_memory = reader->no_memory || !unit;
    result->value = (number_formula){.number = read.value};
    result->unit = unit ? unit : "1";
    return true;
}

static void read_one(case_reader *reader, const parameter_table *all, const file_node *where, const char *expected,
                     parameter *result) {
    char shown[SHOWN_SIZE];
    result->unit = "1";
    result->taken_as = "";
    result->place = where;
    result->text = where->kind == NODE_TEXT ? where->text : "";
    const char *expression = where->kind == NODE_TEXT ? expression_of(where->text) : NULL;
    if (where->kind != NODE_TEXT || node_is_null(where)) {
        problem_at(reader->problems, where, "is %s, expected a number, a quantity or an expression",
                   node_is_null(where) ? "empty" : node_shown(where, shown));
    } else if (expression) {
        result->unit = "";
        read_expression(reader, all, where, expression, &result->value);
    } else {
        read_quantity(reader, where, expected, result);
    }
}

static const parameter_override *find_override(const char *name, const parameter_override *overrides, size_t count) {
    for (size_t i = count; i > 0; i--)
        if (strcmp(overrides[i - 1].name, name) == 0) return &overrides[i - 1];
    return NULL;
}

static bool parameters_allocate(case_reader *reader, size_t count, parameter_table *result) {
    result->items = arena_take(reader->arena, count * sizeof *result->items);
    result->names = arena_take(reader->arena, count * sizeof *result->names);
    result->order = arena_take(reader->arena, count * sizeof *result->order);
    const bool done = result->items && result->names && result->order;
    reader->no_memory = reader->no_memory || !done;
    return done;
}

// ---------------------------------------------------------------- order

typedef struct dependence_walk {
    case_reader *reader;
    parameter_table *result;
    size_t done;                         ///< indices in result->order
    unsigned char state[PARAMETERS_MAX]; ///< 0 not visited, 1 on the path, 2 done
    size_t path[PARAMETERS_MAX], depth;
    bool cyclic;
} dependence_walk;

/// Reports a cycle of parameters, "a -> b -> a".
static void report_cycle(dependence_walk *w, size_t again) {
    char text[160] = "";
    size_t first = 0;
    while (w->path[first] != again) first++;
    for (size_t i = first; i <= w->depth; i++) {
        const size_t used = strlen(text);
        const size_t index = i < w->depth ? w->path[i] : again;
        snprintf(text + used, sizeof text - used, "%s%s", used ? " -> " : "", w->result->items[index].name);
    }
    problem_at(w->reader->problems, w->result->items[again].place, "depends on itself: %s", text);
    w->cyclic = true;
}

static void visit(dependence_walk *w, size_t index);

static bool visit_name(void *context, const char *name, size_t length) {
    dependence_walk *w = context;
    lookup l = {.parameters = w->result};
    if (!parameter_is_known(&l, name, length)) return false;
    visit(w, parameters_find(w->result, l.name));
    return true;
}

/// Orders parameters by dependence, depth first; at most PARAMETERS_MAX deep.
static void visit(dependence_walk *w, size_t index) {
    char why[WHY_SIZE];
    parameter *item = &w->result->items[index];
    if (w->state[index] == 1 && !w->cyclic) report_cycle(w, index);
    if (w->state[index]) return;
    w->state[index] = 1;
    w->path[w->depth++] = index;
    if (item->value.expression) {
        expression_check(item->value.expression, visit_name, w, why);
        item->unit = expression_unit(w->result, item->value.expression);
    }
    w->depth--;
    w->state[index] = 2;
    w->result->order[w->done++] = index;
}

static void sort_by_dependence(case_reader *reader, parameter_table *result) {
    dependence_walk w = {.reader = reader, .result = result};
    for (size_t i = 0; i < result->count; i++) {
        w.cyclic = false; // each cycle is reported once
        visit(&w, i);
    }
}

void parameters_read(case_reader *reader, const file_node *where, const parameter_override *overrides,
                     size_t override_count, parameter_table *result) {
    char shown[SHOWN_SIZE];
    *result = (parameter_table){0};
    if (!where || node_is_null(where)) return;
    if (where->kind != NODE_MAPPING) {
        problem_at(reader->problems, where, "is %s, expected a mapping from names to values", node_shown(where, shown));
        return;
    }
    if (where->count > PARAMETERS_MAX) {
        problem_at(reader->problems, where, "has %zu parameters, expected at most %d", where->count, PARAMETERS_MAX);
    }
    if (!parameters_allocate(reader, PARAMETERS_MAX, result)) return;
    // Names come first, since an expression may use later ones. A duplicate name counts once.
    for (const file_node *member = where->first; member && result->count < PARAMETERS_MAX; member = member->next) {
        check_name(reader, member);
        if (parameters_find(result, member->key) < result->count) continue;
        result->items[result->count] = (parameter){.name = member->key, .place = member, .taken_as = ""};
        result->names[result->count++] = member->key;
    }
    for (size_t i = 0; i < result->count; i++) {
        parameter *item = &result->items[i];
        const parameter_override *set = find_override(item->name, overrides, override_count);
        read_one(reader, result, item->place, "", item);
        const file_node *place = set ? outside(reader, set) : NULL;
        const char *bound = strcmp(item->unit, "1") == 0 ? "" : item->unit;
        *item = place ? (parameter){.name = item->name} : *item;
        if (place) read_one(reader, result, place, bound, item);
    }
    sort_by_dependence(reader, result);
}

// ---------------------------------------------------------------- values

static whirl_status take_given(valuation *v, const whirl_given *given, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const size_t index = parameters_find(v->parameters, given[i].name);
        if (index == v->parameters->count)
            return whirl_fail(WHIRL_BAD_INPUT, "no parameter is called %.63s", given[i].name);
        parameters_put(&v->changed, index);
        v->values[index] = given[i].value;
    }
    return whirl_ok();
}

void value_text(const parameter_table *parameters, const char *name, double value, char *text, size_t size) {
    const size_t index = parameters_find(parameters, name);
    const bool known = index < parameters->count;
    const char *const own = known ? parameter_expected_unit(&parameters->items[index]) : "";
    const char *const si = strcmp(own, "1") == 0 ? "" : own;
    const whirl_unit written = known ? formula_unit(parameters, parameters->items[index].text, si) : (whirl_unit){0};
    const char *const unit = written.size > 0.0 ? written.name : si;
    snprintf(text, size, "%.10g%s%s", written.size > 0.0 ? value / written.size : value, *unit ? " " : "", unit);
}

void given_text(const parameter_table *parameters, const whirl_given *given, size_t count, char *text, size_t size) {
    *text = '\0';
    for (size_t i = 0, used = 0; i < count && used < size; i++) {
        const char *before = i == 0 ? "" : i + 1 == count ? " and " : ", ";
        char value[3 * WHIRL_NAME_SIZE];
        value_text(parameters, given[i].name, given[i].value, value, sizeof value);
        snprintf(text + used, size - used, "%s%s = %s", before, given[i].name, value);
        used += strlen(text + used);
    }
}

whirl_status valuation_open(valuation *v, const parameter_table *parameters, const whirl_given *given, size_t count) {
    *v = (valuation){.parameters = parameters, .culprit = PARAMETERS_MAX};
    whirl_status status = take_given(v, given, count);
    const parameter_set taken = v->changed;
    for (size_t i = 0; i < parameters->count && status.code == WHIRL_OK; i++) {
        const size_t index = parameters->order[i];
        const number_formula *formula = &parameters->items[index].value;
        if (has(&taken, index)) continue;
        if (share(&formula->uses, &v->changed)) parameters_put(&v->changed, index);
        status = valuation_number(v, formula, &v->values[index]);
        if (status.code == WHIRL_OK) continue;
        v->culprit = index;
        status = whirl_fail(status.code, "parameter %.63s %.300s", parameters->items[index].name, status.message);
    }
    return status;
}

void valuation_close(valuation *v) {
    evaluator_free(v->evaluator);
    v->evaluator = NULL;
}

/// Evaluates a product or quotient of parameters without the parser; most expressions that depend on a family's
/// parameter are of this kind. Returns false for other expressions, and if the value is not finite.
static bool multiply_parameters(const valuation *v, const char *expression, double *number) {
    char sign = '\0';
    for (const char *c = expression; *c; c += strspn(c, " ")) {
        char name[WHIRL_NAME_SIZE];
        size_t length = 0;
        while (isalnum((unsigned char)c[length]) || c[length] == '_') length++;
        if (length == 0 || length >= sizeof name) return false;
        memcpy(name, c, length);
        name[length] = '\0';
        const size_t index = parameters_find(v->parameters, name);
        if (index == v->parameters->count) return false; // not a parameter: a number or a constant
        const double value = v->values[index];
        *number = sign == '*' ? *number * value : sign == '/' ? *number / value : value;
        c += length;
        c += strspn(c, " ");
        sign = *c;
        if (!*c) return isfinite(*number);
        if (*c != '*' && *c != '/') return false;
        c++;
    }
    return false;
}

whirl_status valuation_number(valuation *v, const number_formula *formula, double *number) {
    char why[WHY_SIZE];
    *number = formula->number;
    if (!formula->expression || (formula->settled && !share(&formula->uses, &v->changed))) return whirl_ok();
    if (multiply_parameters(v, formula->expression, number)) return whirl_ok();
    if (!v->evaluator) v->evaluator = evaluator_new(v->parameters->names, v->values, v->parameters->count);
    if (!v->evaluator) return whirl_fail(WHIRL_NO_MEMORY, "no memory to evaluate expressions");
    if (evaluator_value(v->evaluator, formula->expression, number, why)) return whirl_ok();
    return whirl_fail(WHIRL_BAD_INPUT, "%s", why);
}

void formula_settle(valuation *v, number_formula *formula) {
    double number;
    if (!formula->expression || valuation_number(v, formula, &number).code != WHIRL_OK) return;
    formula->number = number;
    formula->settled = true;
}

void parameters_settle(valuation *v, parameter_table *parameters) {
    for (size_t i = 0; i < parameters->count; i++) formula_settle(v, &parameters->items[i].value);
}
