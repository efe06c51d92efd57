/// Findings of one subject, a bearing or weights that balance a rotor, as a command prints them.
#ifndef CLI_FOUND_H
#define CLI_FOUND_H

#include "whirl/engine/findings.h"

/// Selection and form of findings to print.
typedef struct found_arguments {
    const char *units, *sheet; ///< NULL: the file's units; all of them
    bool formed;               ///< a form was given
    whirl_sheet_form form;     ///< default: text
} found_arguments;

/// Keys of the options below; a command's own are others.
enum { KEY_FOUND_UNITS = 0x200, KEY_FOUND_SHEET, KEY_FOUND_FORMAT };

/// The options of a command that prints findings.
#define FOUND_OPTIONS                                                                                                  \
    {.name = "units",                                                                                                  \
     .key = KEY_FOUND_UNITS,                                                                                           \
     .arg = "UNITS",                                                                                                   \
     .doc = "Units of numbers, such as 'mil, psi' or US; default: those of FILE"},                                     \
        {.name = "sheet", .key = KEY_FOUND_SHEET, .arg = "NAME", .doc = "Print only this table"}, {                    \
        .name = "format", .key = KEY_FOUND_FORMAT, .arg = "FORMAT",                                                    \
        .doc = "Format of that table: text (default), csv, latex, markdown or json"                                    \
    }

/// Takes one of these options. Returns false for other keys.
bool found_take(int key, char *argument, const struct argp_state *state, found_arguments *arguments);

/// Reports options that exclude each other.
void found_check(const found_arguments *arguments, const struct argp_state *state);

/// Prints the title, statements and sheets, or the requested sheet. Returns the exit status.
int found_print(const whirl_findings *findings, const char *title, const found_arguments *arguments);

#endif
