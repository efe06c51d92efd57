/// Files that are read by tables of keys: the steps that all of them go through.
#ifndef CASE_FILE_H
#define CASE_FILE_H

#include "settings.h"

/// What makes something of the root of a file.
typedef void file_read_fn(case_reader *reader, const file_node *root, void *into);

/// Reads a text with a reader whose arena and problems are set; problems come in the order of the file, with what
/// stands there. `name` stands for the file in messages.
whirl_status file_read(case_reader *reader, const char *text, size_t length, const char *name, file_read_fn *read,
                       void *into);

/// Files other than cases: they have no parameters.
typedef struct file_kind {
    const whirl_group *group; ///< of their keys, by the name of the first, which holds the version
    int version;              ///< that is read
    size_t size;              ///< of what is made of one
    /// Fills it, all zero before, from the settings of the file.
    void (*fill)(case_reader *reader, const setting_list *file, void *into);
    void (*release)(void *made);
} file_kind;

/// Makes what a file says, in memory or at a path: *made, NULL after a failure. problems: NULL, or takes what is wrong.
whirl_status file_parse(const file_kind *kind, const char *text, size_t length, const char *name,
                        whirl_problems *problems, void **made);
whirl_status file_load(const file_kind *kind, const char *path, whirl_problems *problems, void **made);

#endif
