#include "file.h"
#include "settings.h"

#include <stdio.h>
#include <stdlib.h>

#include "arena.h"
#include "excerpt.h"
#include "exhausted.h"
#include "problem.h"
#include "source.h"
#include "tree.h"
#include "utf8.h"
#include "whirl/engine/descriptor.h"
#include "whirl/status.h"

whirl_status file_read(case_reader *reader, const char *text, size_t length, const char *name, file_read_fn *read,
                       void *into) {
    file_node *root;
    whirl_problems *problems = reader->problems;
    const int before = exhausted_watch();
    snprintf(problems->file, sizeof problems->file, "%s", name);
    const whirl_status status = tree_read(text, length, reader->arena, problems, &root);
    reader->no_memory = status.code == WHIRL_NO_MEMORY;
    if (status.code == WHIRL_OK) read(reader, root, into);
    problems_sort(problems);
    problems_quote(problems, text, length);
    reader->no_memory = reader->no_memory || exhausted(before) || problems_blame_memory(problems);
    return reader_outcome(reader, name);
}

/// An object being made, and its kind.
typedef struct making {
    const file_kind *kind;
    void *made;
} making;

static void read_root(case_reader *reader, const file_node *root, void *into) {
    const making *own = into;
    const whirl_group *group = own->kind->group;
    setting_list file;
    char shown[SHOWN_SIZE];
    if (root->kind != NODE_MAPPING) {
        problem_at(reader->problems, root, "is %s, expected a mapping that begins with %s: %d", node_shown(root, shown),
                   group->name, own->kind->version);
        return;
    }
    settings_read(reader, root, group, &file);
    const setting *version = settings_find(&file, group->name);
    if (version && version->good && version->value.number != (double)own->kind->version)
        problem_at(reader->problems, version->place, "is %s, expected %d, the version of the format",
                   node_shown(version->place, shown), own->kind->version);
    else
        own->kind->fill(reader, &file, own->made);
}

whirl_status file_parse(const file_kind *kind, const char *text, size_t length, const char *name,
                        whirl_problems *problems, void **made) {
    whirl_problems own = {0};
    memory_arena arena = {0};
    const parameter_table none = {0};
    making under_way = {kind, calloc(1, kind->size)};
    case_reader reader = {.arena = &arena, .problems = problems ? problems : &own, .parameters = &none};
    *made = NULL;
    text = utf8_skip_mark(text, &length);
    const whirl_status status = under_way.made ? file_read(&reader, text, length, name, read_root, &under_way)
                                               : whirl_fail(WHIRL_NO_MEMORY, "no memory to read %.200s", name);
    arena_free(&arena);
    whirl_problems_free(&own);
    if (status.code == WHIRL_OK)
        *made = under_way.made;
    else if (under_way.made)
        kind->release(under_way.made);
    return status;
}

whirl_status file_load(const file_kind *kind, const char *path, whirl_problems *problems, void **made) {
    char *text;
    size_t length;
    *made = NULL;
    whirl_status status = source_load(path, problems, &text, &length);
    if (status.code == WHIRL_OK) status = file_parse(kind, text, length, path, problems, made);
    free(text);
    return status;
}
