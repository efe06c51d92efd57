// gnuplot: strings for its scripts, and running them.
#ifndef REPORT_GNUPLOT_H
#define REPORT_GNUPLOT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/status.h"

/// Writes text as a single-quoted gnuplot string. In such a string nothing is expanded (no backquotes, no escapes, no
/// macros). An apostrophe becomes U+2019: gnuplot 5.4 misreads a string that begins with an escaped one. Control
/// characters become spaces and bytes that are not UTF-8 become '?'.
void gnuplot_string(FILE *script, const char *text);

/// Writes text within a comment line: one line, and no backslash that would join it with the next.
void gnuplot_comment(FILE *script, const char *text);

/// A script in a folder; `drawn` tells how it ended.
typedef struct gnuplot_job {
    const char *folder; ///< borrowed
    const char *script; ///< file name in it; borrowed
    bool drawn;
} gnuplot_job;

/// Runs `program` (NULL: gnuplot on the PATH) on all scripts, each in its folder, as many at once as there are cores.
/// What gnuplot says goes to SCRIPT.log beside the script, which is removed when gnuplot says nothing.
/// WHIRL_MISSING_PROGRAM when the program is not there; WHIRL_IO_ERROR naming the first script that failed, after
/// all have been tried.
whirl_status gnuplot_run(const char *program, gnuplot_job *jobs, size_t count);

#endif
