/// Renderers of figures and documents: external programs.
#ifndef REPORT_RENDER_H
#define REPORT_RENDER_H

#include "whirl/engine/figure.h"
#include "whirl/status.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

// ---------------------------------------------------------------- gnuplot
// gnuplot: strings for its scripts, and running them.

/// Writes text as a single-quoted gnuplot string. In such a string nothing is expanded (no backquotes, no escapes, no
/// macros). An apostrophe becomes U+2019: gnuplot 5.4 misreads a string that begins with an escaped one. Control
/// characters become spaces and bytes that are not UTF-8 become '?'.
void gnuplot_string(FILE *script, const char *text);

/// Writes text within a comment line: one line, and no backslash that would join it with the next.
void gnuplot_comment(FILE *script, const char *text);

/// A script in a folder; `drawn` is the result.
typedef struct gnuplot_job {
    const char *folder; ///< borrowed
    const char *script; ///< file name in it; borrowed
    bool drawn;
} gnuplot_job;

/// Runs `program` (NULL: gnuplot on the PATH) on all scripts, each in its folder, as many at once as there are cores.
/// gnuplot's output goes to SCRIPT.log next to the script; an empty log is removed. Returns WHIRL_MISSING_PROGRAM if
/// the program does not exist, WHIRL_IO_ERROR with the first script that failed, after all have been tried.
whirl_status gnuplot_run(const char *program, gnuplot_job *jobs, size_t count);

// ---------------------------------------------------------------- gnuplot_script
// Figures for gnuplot: a script and its data.

/// Writes the numbers of a figure, one block for each series, in the order of panels and series.
void gnuplot_write_data(FILE *data, const whirl_figure *figure);

/// Writes the script that draws them from the file `data` into NAME.FORMAT for each word of `formats` ("png pdf").
void gnuplot_write_script(FILE *script, const whirl_figure *figure, const char *name, const char *data,
                          const char *formats);

/// Converts a label to gnuplot's enhanced text: symbols in italics, special characters escaped. At most `size` bytes,
/// never cut within an escape.
void gnuplot_markup(const char *label, char *markup, size_t size);

// ---------------------------------------------------------------- print
// Documents to be printed, from pages.

/// Makes FOLDER/PDF from FOLDER/PAGE with weasyprint (`program`; NULL: the one on the PATH). Returns
/// WHIRL_MISSING_PROGRAM if that does not exist, WHIRL_IO_ERROR if it fails.
whirl_status document_print(const char *program, const char *folder, const char *page, const char *pdf);

// ---------------------------------------------------------------- program
// Programs that are run for reports, in other folders than this one.

/// Returns the name to execute for a program: a bare name for the PATH, or an absolute path, since a relative one would
/// not work from another folder. NULL if the file does not exist, or without memory. Freed by the caller.
char *program_found(const char *program);

#endif
