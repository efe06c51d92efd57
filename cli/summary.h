/// What `whirl run` and `whirl check` say at the end.
#ifndef CLI_SUMMARY_H
#define CLI_SUMMARY_H

#include "whirl/result.h"
#include "whirl/study.h"

/// What was found, on standard output: every point of a short table, counts of verdicts of a long one. WHIRL_NO_MEMORY
/// where there is none to tell all of it.
whirl_status summarize_result(const whirl_result *result);

/// One line where the steps of the sweep do not meet its end (the fact "sweep ends at"); `first` is its first value.
void summarize_end(const whirl_result *result, const char *parameter, double first);

/// One line a batch: points, revolutions, steps.
void summarize_study(const whirl_study *study);

#endif
