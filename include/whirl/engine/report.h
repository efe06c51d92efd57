/// Reports: figures and an HTML page from results.
#ifndef WHIRL_REPORT_H
#define WHIRL_REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "whirl/engine/claims.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What a report is made of, and with what.
typedef struct whirl_report_options {
    const whirl_claims *claims; ///< NULL: none
    const char *gnuplot;        ///< program; NULL: "gnuplot" on the PATH
    /// Template of the explorer's page, which `make explorer` builds; NULL: no explorer.html is written.
    const char *explorer;
    /// Units of figures and pages, "um, rpm, Hz, p-p" (docs/guide/04-studies.md), where they shall not be those of the
    /// case; NULL: none. WHIRL_BAD_INPUT for a word that is no unit.
    const char *units;
    bool lateral;           ///< DIR/lateral.html and lateral.pdf besides: a lateral analysis in the order of its parts
    const char *weasyprint; ///< program that makes the PDF of it; NULL: "weasyprint" on the PATH
} whirl_report_options;

/// Returns true where a report would replace a page, or files in the folder of a result, and writes the path of the
/// first one in at most `size` bytes. Arguments as of whirl_report_write.
bool whirl_report_find(const char *const *names, size_t count, const char *directory,
                       const whirl_report_options *options, char *found, size_t size);

/// Writes DIR/report.html, DIR/explorer.html (all results in one page that computes on), and for every result
/// DIR/NAME/ with figures (PNG, PDF), their gnuplot scripts and data. `names` [count] become folder names.
/// WHIRL_MISSING_PROGRAM when gnuplot is not there: scripts and data are written all the same; or when weasyprint is
/// not there, and all but the PDF is written.
whirl_status whirl_report_write(const whirl_result *const *results, const char *const *names, size_t count,
                                const char *directory, const whirl_report_options *options);

/// Writes DIRECTORY/explorer.html alone: the template (whirl_report_options.explorer) with the results in the place of
/// its mark. The directory is there. WHIRL_BAD_INPUT with a sentence for a template that cannot be read or has no mark.
whirl_status whirl_explorer_write(const char *template_path, const whirl_result *const *results,
                                  const char *const *names, size_t count, const char *directory);

/// Writes what was found in lines of text, each ended by a line feed: every point of a short table, counts of verdicts
/// of a long one, what was located along branches and modes. WHIRL_NO_MEMORY where there is none to tell all of it.
whirl_status whirl_result_write_summary(const whirl_result *result, FILE *stream);

/// Its line where the steps of a table do not meet its end (the fact "sweep ends at"); `first` is its first value.
void whirl_result_write_end(const whirl_result *result, const char *table, const char *parameter, double first,
                            FILE *stream);

/// Its line on the phase that sections are taken by, where it is not the shaft's: "sections: once a turn of the force
/// at disc (31 Hz), which counts as a revolution here"; rate in rad/s.
void whirl_write_keyphasor(const char *keyphasor, double rate, FILE *stream);

/// Writes the points as whirl_result_write_json does, without what has a row for every revolution or node: sections,
/// curves of tori, nodes of orbits.
whirl_status whirl_result_write_json_summary(const whirl_result *result, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
