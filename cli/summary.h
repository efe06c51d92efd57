/// What `whirl run` and `whirl check` say of a study before it is computed.
#ifndef CLI_SUMMARY_H
#define CLI_SUMMARY_H

#include "whirl/engine/study.h"

/// One line a batch: points, revolutions, steps.
void summarize_study(const whirl_study *study);

#endif
