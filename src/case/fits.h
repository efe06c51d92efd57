/// What stands in time for tables over the frequency of whirl: rational functions, said with their errors, and whether
/// they leave the machine as stable as its tables do.
#ifndef CASE_FITS_H
#define CASE_FITS_H

#include "content.h"

/// Adds a fact to the result, "fit 1", ..., for every such function of the machine with these parameters [count], where
/// it is not there yet. `doubt` is what to warn of: modes that functions and tables take for stable and for unstable,
/// "" where there are none. Machines without such tables, and what cannot be built, are left out: WHIRL_NO_MEMORY
/// alone.
whirl_status case_tell_fits(const case_content *content, const whirl_given *given, size_t count, whirl_result *result,
                            char doubt[WHIRL_MESSAGE_SIZE]);

#endif
