/// Text in HTML. Everything that comes from a case, a result or a claim goes through here.
#ifndef REPORT_HTML_H
#define REPORT_HTML_H

#include "whirl/engine/shown.h"

#include <stdio.h>

/// Writes text that may hold anything: markup and quotes escaped, control characters and bytes that are not UTF-8
/// replaced by U+FFFD. Fit for element content and for attributes in double quotes.
void html_text(FILE *stream, const char *text);

/// Formats as printf and writes the text by html_text; texts are cut at 4095 bytes.
void html_printf(FILE *stream, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// Begins a table of a class ("" for none) that scrolls by itself if it is wider than the page: a named region that the
/// keyboard can reach. End it with </table></div>.
void html_table(FILE *stream, const char *label, const char *class);

#endif
