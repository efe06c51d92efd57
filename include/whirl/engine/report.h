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

/// Options of a report.
typedef struct whirl_report_options {
    const whirl_claims *claims; ///< NULL: none
    const char *gnuplot;        ///< gnuplot's program; NULL: "gnuplot" on the PATH
    /// Template of the explorer's page, built by `make explorer`; NULL: explorer.html is not written.
    const char *explorer;
    /// Units of figures and pages, "um, rpm, Hz, p-p" (docs/guide/04-studies.md), instead of those of the case; NULL:
    /// none. WHIRL_BAD_INPUT for a word that is not a unit.
    const char *units;
    bool lateral;   ///< also write DIR/lateral.html and lateral.pdf, a lateral analysis in the usual order of its parts
    bool torsional; ///< likewise DIR/torsional.html and torsional.pdf, a torsional analysis
    const char *weasyprint; ///< program that makes that PDF; NULL: "weasyprint" on the PATH
} whirl_report_options;

/// Returns true if a report would replace a page, or files in the folder of a result, and writes the path of the first
/// one, at most `size` bytes. Arguments as for whirl_report_write.
bool whirl_report_find(const char *const *names, size_t count, const char *directory,
                       const whirl_report_options *options, char *found, size_t size);

/// Writes DIR/report.html, DIR/explorer.html (all results in one page that can compute further), and for every result
/// DIR/NAME/ with figures (PNG, PDF), their gnuplot scripts and data. `names` [count] become folder names.
/// WHIRL_MISSING_PROGRAM if gnuplot is not installed (scripts and data are written), or if weasyprint is not (all but
/// the PDF is written).
whirl_status whirl_report_write(const whirl_result *const *results, const char *const *names, size_t count,
                                const char *directory, const whirl_report_options *options);

/// Writes DIRECTORY/explorer.html only: the template (whirl_report_options.explorer) with the results in place of its
/// mark. The directory must exist. WHIRL_BAD_INPUT with a sentence for a template that cannot be read or has no mark.
whirl_status whirl_explorer_write(const char *template_path, const whirl_result *const *results,
                                  const char *const *names, size_t count, const char *directory);

/// Writes a summary of a result in lines of text, each ended by a line feed: every point of a short table, counts of
/// verdicts of a long one, special points of branches and modes. WHIRL_NO_MEMORY if memory is exhausted before its end.
whirl_status whirl_result_write_summary(const whirl_result *result, FILE *stream);

/// Writes the summary's line for a table whose last value falls short of the requested end (the fact "sweep ends at"),
/// or nothing; `first` is the first value of the table.
void whirl_result_write_end(const whirl_result *result, const char *table, const char *parameter, double first,
                            FILE *stream);

/// Writes the summary's line for a keyphasor, or nothing for the shaft: "sections: once a turn of the force at disc (31
/// Hz), which counts as a revolution here"; rate in rad/s.
void whirl_write_keyphasor(const char *keyphasor, double rate, FILE *stream);

/// Writes the points as whirl_result_write_json does, without fields that have a row per revolution or node: sections,
/// curves of tori, nodes of orbits.
whirl_status whirl_result_write_json_summary(const whirl_result *result, FILE *stream);

/// Returns the table of the records of a data set; NULL if the result has none. Borrowed.
const whirl_table *whirl_result_records(const whirl_result *result);

/// Writes the table of the records of a data set as CSV (RFC 4180): row of the signals, from 0, record, machine, set,
/// label, severity, verdict, confidence, largest share in contact, speed (rad/s), angle at the first sample
/// (revolutions), seed, and the parameters that differ (SI). Missing numbers are empty.
void whirl_dataset_write_index(const whirl_result *result, FILE *stream);

/// Writes the data sheet of a data set as Markdown. `name`: that of the files, without their endings.
/// WHIRL_NO_MEMORY if memory is exhausted.
whirl_status whirl_dataset_write_sheet(const whirl_result *result, const char *name, FILE *stream);

#ifdef __cplusplus
}
#endif
#endif
