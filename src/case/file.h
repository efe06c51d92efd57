/// Files that are read by tables of keys: the steps that all of them go through.
#ifndef CASE_FILE_H
#define CASE_FILE_H

#include "parameters.h"
#include "settings.h"

/// Makes an object from the root of a file.
typedef void file_read_fn(case_reader *reader, const file_node *root, void *into);

/// Reads a text with a reader whose arena and problems are set; problems are in the order of the file, with excerpts.
/// `name` is used in messages.
whirl_status file_read(case_reader *reader, const char *text, size_t length, const char *name, file_read_fn *read,
                       void *into);

/// Files other than cases: they have no parameters.
typedef struct file_kind {
    const whirl_group *group; ///< group of the file's keys, named after the first key, which holds the version
    int version;              ///< version that is read
    size_t size;              ///< size of the object
    /// Fills the object, all zero before, from the settings of the file.
    void (*fill)(case_reader *reader, const setting_list *file, void *into);
    void (*release)(void *made);
} file_kind;

/// Makes the object of a file, from memory or a path: *made, NULL after a failure. `problems` may be NULL.
whirl_status file_parse(const file_kind *kind, const char *text, size_t length, const char *name,
                        whirl_problems *problems, void **made);
whirl_status file_load(const file_kind *kind, const char *path, whirl_problems *problems, void **made);

#endif
