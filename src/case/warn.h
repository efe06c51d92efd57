/// What a case may say and likely does not mean.
#ifndef CASE_WARN_H
#define CASE_WARN_H

#include "content.h"

/// Adds a fact to the result for every warning (whirl_result_warning): values that the law of an element is not for, at
/// the ends of what the study varies, ranges without extent, and what stands in time for tables (fits.h).
whirl_status case_warn(const case_content *content, whirl_result *result);

#endif
