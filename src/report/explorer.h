// The explorer's page in units that a report asks for.
#ifndef REPORT_EXPLORER_H
#define REPORT_EXPLORER_H

#include "whirl/engine/report.h"

/// As whirl_explorer_write; `units` go before those of the case (whirl_result_shown_units), NULL: none are asked for.
whirl_status explorer_write(const char *template_path, const whirl_result *const *results, const char *const *names,
                            size_t count, const char *directory, const char *units);

#endif
