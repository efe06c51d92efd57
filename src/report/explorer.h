// The explorer: a page that holds results and computes on; made from a template that is built apart (explorer/).
#ifndef REPORT_EXPLORER_H
#define REPORT_EXPLORER_H

#include <stddef.h>

#include "whirl/result.h"

/// Writes `directory`/explorer.html: the template with the results in the place of its mark. `names` [count] are those
/// of the report's folders. WHIRL_BAD_INPUT with a sentence for a template that cannot be read or has no mark.
whirl_status explorer_write(const char *template_path, const whirl_result *const *results, const char *const *names,
                            size_t count, const char *directory);

#endif
