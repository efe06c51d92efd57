/// Writes the explorer's page in the units of a report.
#ifndef REPORT_EXPLORER_H
#define REPORT_EXPLORER_H

#include <stddef.h>

#include "whirl/engine/case.h"
#include "whirl/engine/result.h"
#include "whirl/status.h"

/// Like whirl_explorer_write; `units` override those of the case (whirl_result_shown_units); NULL: the case's. machines
/// [count]: cases of the results (machine_of).
whirl_status explorer_write(const char *template_path, const whirl_result *const *results,
                            const whirl_case *const *machines, const char *const *names, size_t count,
                            const char *directory, const char *units);

#endif
