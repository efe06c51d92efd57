/// What several starts a point have come to rest on, for a terminal.
#ifndef CLI_SUMMARY_STARTS_H
#define CLI_SUMMARY_STARTS_H

#include "whirl/result.h"

/// Of a table of a view (whirl_result_by_attractor): attractors with their shares, where several exist side by side,
/// and what the starts may have missed. Nothing for other tables. WHIRL_NO_MEMORY.
whirl_status summarize_starts(const whirl_result *view, const whirl_table *table);

/// "attractor 2, 25 % +- 11 %" of a point of such a table, after `before`; nothing for other tables.
void summarize_share(const whirl_table *table, size_t point, const char *before);

#endif
