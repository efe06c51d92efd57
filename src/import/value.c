#include "value.h"

#include <stdio.h>
#include <string.h>

value *value_add(memory_arena *arena, value *parent, value_kind kind, const char *key, size_t key_length, int line) {
    value *const added = arena_take(arena, sizeof *added);
    if (!added) return NULL;
    *added = (value){.kind = kind, .line = line};
    if (key && !(added->key = arena_text(arena, key, key_length))) return NULL;
    if (!parent) return added;
    *(parent->last ? &parent->last->next : &parent->first) = added;
    parent->last = added;
    parent->count++;
    return added;
}

bool value_set_text(memory_arena *arena, value *to, const char *text, size_t length) {
    to->text = arena_text(arena, text, length);
    return to->text != NULL;
}

value *value_member(value *table, const char *key) {
    for (value *one = table->first; one; one = one->next)
        if (one->key && strcmp(one->key, key) == 0) {
            one->seen = true;
            return one->kind == VALUE_NOTHING ? NULL : one;
        }
    return NULL;
}

const char *value_shown(const value *of, char shown[VALUE_SHOWN_SIZE]) {
    static const char *const words[] = {[VALUE_TABLE] = "a table", [VALUE_NOTHING] = "null", [VALUE_DATE] = "a date"};
    switch (of->kind) {
    case VALUE_TEXT:
        snprintf(shown, VALUE_SHOWN_SIZE, strlen(of->text) > 30 ? "\"%.30s...\"" : "\"%.30s\"", of->text);
        whirl_make_plain(shown);
        return shown;
    case VALUE_NUMBER:
        snprintf(shown, VALUE_SHOWN_SIZE, "%.10g", of->number);
        return shown;
    case VALUE_TRUTH:
        return of->number != 0.0 ? "true" : "false";
    case VALUE_LIST:
        snprintf(shown, VALUE_SHOWN_SIZE, "a list of %zu", of->count);
        return shown;
    default:
        return words[of->kind];
    }
}
