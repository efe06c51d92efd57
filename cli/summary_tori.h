/// What `whirl run` and `whirl show` say of tori.
#ifndef CLI_SUMMARY_TORI_H
#define CLI_SUMMARY_TORI_H

#include "whirl/result.h"

/// Some lines for each branch of tori: where it begins, whether it is stable, its frequencies, where and why it ends.
void summarize_tori(const whirl_result *result, const whirl_table *table);

#endif
