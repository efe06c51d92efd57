/// Writes strings of gnuplot scripts, and runs gnuplot.
#ifndef REPORT_GNUPLOT_H
#define REPORT_GNUPLOT_H

#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/// Writes text as a single-quoted gnuplot string. In such a string nothing is expanded (no backquotes, no escapes, no
/// macros). An apostrophe becomes U+2019: gnuplot 5.4 misreads a string that begins with an escaped one. Control
/// characters become spaces and bytes that are not UTF-8 become '?'.
void gnuplot_string(FILE *script, const char *text);

/// Writes text within a comment line: one line, and no backslash that would join it with the next.
void gnuplot_comment(FILE *script, const char *text);

/// A script in a folder; gnuplot_run sets `drawn`.
typedef struct gnuplot_job {
    const char *folder; ///< borrowed
    const char *script; ///< file name in the folder; borrowed
    bool drawn;
} gnuplot_job;

/// Runs `program` (NULL: gnuplot on the PATH) on all scripts, each in its folder, as many at once as there are cores.
/// gnuplot's output goes to SCRIPT.log next to the script; an empty log is removed. Returns WHIRL_MISSING_PROGRAM if
/// the program does not exist, WHIRL_IO_ERROR with the first script that failed, after all have been tried.
whirl_status gnuplot_run(const char *program, gnuplot_job *jobs, size_t count);

#endif
