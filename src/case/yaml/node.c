// Navigation in the tree of a file.
#include <stdio.h>
#include <string.h>

#include "tree.h"

const file_node *node_member(const file_node *mapping, const char *key) {
    for (const file_node *member = mapping->first; member; member = member->next)
        if (strcmp(member->key, key) == 0) return member;
    return NULL;
}

bool node_is_null(const file_node *node) {
    if (node->kind != NODE_TEXT || node->quoted) return false;
    return node->text[0] == '\0' || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0;
}

void node_path(const file_node *node, char *text, size_t size) {
    text[0] = '\0';
    if (!node->parent) {
        snprintf(text, size, "%s", node->key ? node->key : "");
        return;
    }
    node_path(node->parent, text, size);
    const size_t used = strlen(text);
    if (node->key)
        snprintf(text + used, size - used, "%s%s", used ? "." : "", node->key);
    else
        snprintf(text + used, size - used, "[%zu]", node->index);
}
