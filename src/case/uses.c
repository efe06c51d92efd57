// Uses of a case's parameters, their comments in the case, and its other numbers, for interactive programs.
#include <stdio.h>
#include <string.h>

#include "content.h"
#include "whirl/engine/analyze.h"

typedef struct walk {
    const whirl_case *object;
    whirl_case_use_fn see;
    void *context;
    const setting *at;
} walk;

/// Accepts every name in an expression, and reports those that are parameters.
static bool see_name(void *context, const char *name, size_t length) {
    const walk *w = context;
    const char *expression = w->at->value.expression;
    const parameter_table *parameters = &w->object->content.parameters;
    whirl_use use = {.key = w->at->key};
    char text[WHIRL_NAME_SIZE];
    if (length >= sizeof text) return true;
    memcpy(text, name, length);
    text[length] = '\0';
    const size_t index = parameters_find(parameters, text);
    if (index == parameters->count) return true;
    use.parameter = parameters->items[index].name;
    use.alone = name == expression + strspn(expression, " ") && strspn(name + length, " ") == strlen(name + length);
    node_path(w->at->place, use.path, sizeof use.path);
    w->see(w->context, &use);
    return true;
}

static void see_list(walk *w, const setting_list *list) {
    char why[WHY_SIZE];
    for (size_t i = 0; i < list->count; i++) {
        const size_t count = setting_numbers(&list->items[i], &w->at);
        for (size_t k = 0; k < count; k++, w->at++)
            if (w->at->key && w->at->value.expression) expression_check(w->at->value.expression, see_name, w, why);
    }
}

void whirl_case_uses(const whirl_case *object, whirl_case_use_fn see, void *context) {
    const machine_parts *machine = &object->content.machine;
    const study_plan *plan = &object->content.plan;
    walk w = {.object = object, .see = see, .context = context};
    see_list(&w, &machine->rotor);
    for (size_t i = 0; i < machine->materials.count; i++) see_list(&w, &machine->materials.items[i]);
    for (size_t i = 0; i < machine->shafts.count; i++) see_list(&w, &machine->shafts.items[i]);
    for (size_t i = 0; i < machine->stations.count; i++) see_list(&w, &machine->stations.items[i]);
    for (size_t i = 0; i < machine->element_count; i++) see_list(&w, &machine->elements[i]);
    for (size_t i = 0; i < plan->start_count; i++) see_list(&w, &plan->starts[i].state);
    for (size_t i = 0; i < plan->range_count; i++) see_list(&w, &plan->ranges[i].low);
    for (size_t i = 0; i < plan->range_count; i++) see_list(&w, &plan->ranges[i].high);
}

// ---------------------------------------------------------------- numbers that are written as such

/// Reports a number that is written as a text at a place of the file, with the name OWNER.KEY.
static void number_see(const file_node *place, const char *owner, const whirl_key *key, double value,
                       whirl_case_number_fn see, void *context) {
    whirl_written_number number = {.key = key, .text = place->text, .value = value};
    if (place->kind != NODE_TEXT || !place->text) return;
    snprintf(number.name, sizeof number.name, "%.60s.%.60s", owner, key->name);
    see(context, &number);
}

/// Reports the numbers of a station or an element.
static void numbers_see_list(const setting_list *list, const char *owner, whirl_case_number_fn see, void *context) {
    for (size_t i = 0; i < list->count; i++) {
        const setting *item = &list->items[i];
        const bool plain = item->good && item->key && item->key->kind == WHIRL_KEY_NUMBER && !item->scaled;
        if (plain && !item->value.expression && !item->entries)
            number_see(item->place, owner, item->key, item->value.number, see, context);
    }
}

/// Reports the numbers of the run-up; a list of several run-ups is left out, since they have no names.
static void numbers_see_runup(const file_node *runup, whirl_case_number_fn see, void *context) {
    for (const file_node *at = runup->kind == NODE_MAPPING ? runup->first : NULL; at; at = at->next)
        for (const whirl_member *member = whirl_runup_members(); member->part; member++) {
            double value;
            const bool own = at->key && member->key.name && strcmp(member->key.name, at->key) == 0;
            if (own && member->key.kind == WHIRL_KEY_NUMBER && at->text &&
                whirl_quantity_value(at->text, member->key.unit, &value).code == WHIRL_OK)
                number_see(at, "runup", &member->key, value, see, context);
        }
}

void whirl_case_numbers(const whirl_case *object, whirl_case_number_fn see, void *context) {
    const machine_parts *machine = &object->content.machine;
    const file_node *root = object->content.root, *study = root ? node_member(root, "study") : NULL;
    const file_node *runup = study ? node_member(study, "runup") : NULL;
    if (runup) numbers_see_runup(runup, see, context);
    for (size_t i = 0; i < machine->stations.count; i++)
        numbers_see_list(&machine->stations.items[i], machine->stations.names[i], see, context);
    for (size_t i = 0; i < machine->element_count; i++) {
        const setting_list *element = &machine->elements[i];
        size_t which = 0, all = 0; // among the elements of its kind, from 1
        char owner[WHIRL_NAME_SIZE];
        for (size_t k = 0; k < machine->element_count; k++) {
            all += strcmp(machine->elements[k].name, element->name) == 0;
            if (k == i) which = all;
        }
        snprintf(owner, sizeof owner, all > 1 ? "%.40s[%zu]" : "%.40s", element->name, which);
        numbers_see_list(element, owner, see, context);
    }
}

// ---------------------------------------------------------------- dependence

/// Search for a parameter in an expression, directly or through other parameters.
typedef struct dependence {
    const parameter_table *parameters;
    const char *on;
    bool found;
} dependence;

static bool look(void *context, const char *name, size_t length) {
    dependence *d = context;
    char text[WHIRL_NAME_SIZE], why[WHY_SIZE];
    snprintf(text, sizeof text, "%.*s", (int)length, name);
    d->found = d->found || strcmp(text, d->on) == 0;
    const size_t index = parameters_find(d->parameters, text);
    const char *expression = index < d->parameters->count ? d->parameters->items[index].value.expression : NULL;
    return d->found || !expression || expression_check(expression, look, d, why);
}

bool case_depends(const case_content *content, const char *expression, const char *name) {
    dependence d = {&content->parameters, name, false};
    char why[WHY_SIZE];
    expression_check(expression, look, &d, why);
    return d.found;
}

bool case_depends_on_batch(const case_content *content, const char *expression, const whirl_batch *batch) {
    const char *const names[] = {batch->parameter, batch->second, batch->third};
    for (size_t i = 0; i < 3; i++)
        if (*names[i] && case_depends(content, expression, names[i])) return true;
    for (size_t i = 0; i < batch->given_count; i++)
        if (case_depends(content, expression, batch->given[i].name)) return true;
    for (int i = 0; i < batch->tolerances.parameters; i++)
        if (case_depends(content, expression, batch->tolerated[i].name)) return true;
    for (size_t i = 0; batch->dataset && i < batch->dataset->parameter_count; i++)
        if (case_depends(content, expression, batch->dataset->parameters[i])) return true;
    return false;
}

const setting *case_list_depends(const case_content *content, const setting_list *list, const char *name) {
    for (size_t i = 0; i < list->count; i++) {
        const setting *number;
        const size_t count = setting_numbers(&list->items[i], &number);
        for (size_t k = 0; k < count; k++) {
            const char *expression = number[k].key ? number[k].value.expression : NULL;
            if (expression && case_depends(content, expression, name)) return &number[k];
        }
    }
    return NULL;
}

const setting *case_machine_use(const case_content *content, const char *name) {
    const machine_parts *machine = &content->machine;
    const struct {
        const setting_list *lists;
        size_t count;
    } parts[] = {{&machine->rotor, 1},
                 {machine->materials.items, machine->materials.count},
                 {machine->shafts.items, machine->shafts.count},
                 {machine->stations.items, machine->stations.count},
                 {machine->elements, machine->element_count}};
    const setting *found = NULL;
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        for (size_t i = 0; i < parts[p].count && !found; i++)
            found = case_list_depends(content, &parts[p].lists[i], name);
    return found;
}

/// Finds line number `line` of a text, from 1.
static const char *line_at(const char *text, int line) {
    for (; line > 1 && text; line--) {
        text = strchr(text, '\n');
        text = text ? text + 1 : NULL;
    }
    return text;
}

void whirl_case_comment(const whirl_case *object, const char *name, char *comment, size_t size) {
    const parameter_table *parameters = &object->content.parameters;
    const size_t index = parameters_find(parameters, name);
    const file_node *root = object->content.root, *all = root ? node_member(root, "parameters") : NULL;
    const file_node *node = index < parameters->count && all ? node_member(all, name) : NULL;
    comment[0] = '\0';
    // A comment belongs to the parameter if no other one is on its line.
    for (const file_node *other = all ? all->first : NULL; other && node; other = other->next)
        if (other != node && other->line == node->line) node = NULL;
    const char *line = node ? line_at(object->text, node->line) : NULL;
    if (!line) return;
    const size_t length = strcspn(line, "\r\n");
    size_t at = (size_t)node->column - 1 + (node->text ? strlen(node->text) : 0);
    while (at < length && !(line[at] == '#' && (line[at - 1] == ' ' || line[at - 1] == '\t'))) at++;
    at += strspn(line + at, "# \t");
    snprintf(comment, size, "%.*s", (int)(at < length ? length - at : 0), line + at);
}
