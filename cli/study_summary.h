/// Description of a study before it is computed, for `whirl run` and `whirl check`.
#ifndef CLI_STUDY_SUMMARY_H
#define CLI_STUDY_SUMMARY_H

#include "whirl/engine/study.h"

/// Prints a line for each batch: points, revolutions, steps.
void summarize_study(const whirl_study *study);

#endif
