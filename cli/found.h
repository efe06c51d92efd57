/// Options and output of `whirl bearing` and `whirl balance`, which print findings (statements and sheets).
#ifndef CLI_FOUND_H
#define CLI_FOUND_H

#include "whirl/internal/findings.h"

/// Selection and form of findings to print.
typedef struct found_arguments {
    const char *units;     ///< NULL: the units of the file
    const char *sheet;     ///< NULL: all sheets
    bool formed;           ///< --format was given
    whirl_sheet_form form; ///< default: text
} found_arguments;

/// Keys of the options below; a command must not use them for its own.
enum { KEY_FOUND_UNITS = 0x200, KEY_FOUND_SHEET, KEY_FOUND_FORMAT };

/// Rows of these options in a command's table of options.
#define FOUND_OPTIONS                                                                                                  \
    {.name = "units",                                                                                                  \
     .key = KEY_FOUND_UNITS,                                                                                           \
     .arg = "UNITS",                                                                                                   \
     .doc = "Units of numbers, such as 'mil, psi' or US; default: those of FILE"},                                     \
        {.name = "sheet", .key = KEY_FOUND_SHEET, .arg = "NAME", .doc = "Print only this table"}, {                    \
        .name = "format", .key = KEY_FOUND_FORMAT, .arg = "FORMAT",                                                    \
        .doc = "Format of that table: text (default), csv, latex, markdown or json"                                    \
    }

/// Reads one of these options. Returns false for other keys.
bool found_take(int key, char *argument, const struct argp_state *state, found_arguments *arguments);

/// Ends the program with an error for options that exclude each other.
void found_check(const found_arguments *arguments, const struct argp_state *state);

/// Prints the title, statements and sheets, or the requested sheet. Returns the exit status.
int found_print(const whirl_findings *findings, const char *title, const found_arguments *arguments);

#endif
