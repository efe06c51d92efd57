// JSON by Jansson.
#include <jansson.h>
#include <string.h>

#include "arena.h"
#include "exhausted.h"
#include "value.h"

typedef struct json_copier {
    memory_arena *arena;
    bool no_memory, too_deep;
} json_copier;

static value *copy(json_copier *by, value *parent, const char *key, size_t key_length, json_t *from, int depth);

static void copy_parts(json_copier *by, value *to, json_t *from, int depth) {
    if (json_is_array(from)) {
        for (size_t i = 0; i < json_array_size(from); i++) copy(by, to, NULL, 0, json_array_get(from, i), depth);
        return;
    }
    const char *key;
    json_t *member;
    json_object_foreach(from, key, member) {
        copy(by, to, key, strlen(key), member, depth);
    }
}

static value_kind json_kind(const json_t *from) {
    switch (json_typeof(from)) {
    case JSON_OBJECT:
        return VALUE_TABLE;
    case JSON_ARRAY:
        return VALUE_LIST;
    case JSON_STRING:
        return VALUE_TEXT;
    case JSON_INTEGER:
    case JSON_REAL:
        return VALUE_NUMBER;
    case JSON_TRUE:
    case JSON_FALSE:
        return VALUE_TRUTH;
    default:
        return VALUE_NOTHING;
    }
}

static value *copy(json_copier *by, value *parent, const char *key, size_t key_length, json_t *from, int depth) {
    by->too_deep = by->too_deep || depth > VALUE_MAX_DEPTH;
    if (by->no_memory || by->too_deep) return NULL;
    value *const made = value_add(by->arena, parent, json_kind(from), key, key_length, 0);
    by->no_memory = !made;
    if (!made) return NULL;
    if (made->kind == VALUE_TABLE || made->kind == VALUE_LIST) copy_parts(by, made, from, depth + 1);
    if (made->kind == VALUE_TEXT)
        by->no_memory = !value_set_text(by->arena, made, json_string_value(from), json_string_length(from));
    if (made->kind == VALUE_NUMBER) made->number = json_number_value(from);
    if (made->kind == VALUE_TRUTH) made->number = json_is_true(from) ? 1.0 : 0.0;
    return made;
}

whirl_status value_read_json(memory_arena *arena, const char *text, size_t length, const char *name, value **root) {
    json_error_t error = {0};
    *root = NULL;
    const int before = exhausted_watch();
    json_t *const read = json_loadb(text, length, JSON_REJECT_DUPLICATES, &error);
    if (exhausted(before) || (!read && json_error_code(&error) == json_error_out_of_memory)) {
        json_decref(read);
        return whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", name);
    }
    if (!read) {
        whirl_make_plain(error.text);
        return whirl_fail(WHIRL_BAD_INPUT, "%.120s:%d: is no JSON: %.200s", name, error.line, error.text);
    }
    json_copier by = {.arena = arena};
    *root = copy(&by, NULL, NULL, 0, read, 0);
    json_decref(read);
    if (by.no_memory) return whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", name);
    if (by.too_deep)
        return whirl_fail(WHIRL_BAD_INPUT, "%.120s: has more than %d lists or tables within each other", name,
                          (int)VALUE_MAX_DEPTH);
    return whirl_ok();
}
