/// Trial of a study: finds out without a run whether a run would refuse the study.
#ifndef WHIRL_STUDY_TRY_H
#define WHIRL_STUDY_TRY_H

#include "whirl/engine/study.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Returns WHIRL_BAD_INPUT, with the sentence of whirl_study_run, if a run would refuse the study. Tries the run up to
/// its first point, the first point of a study at rest (for machines of up to 300 states), and the beginnings of the
/// branches of a parameter. Makes the film tables of these points. When *stop becomes true, the rest is not tried and
/// counts as accepted. WHIRL_NO_MEMORY.
whirl_status whirl_study_try(const whirl_study *study, const whirl_stop *stop);

#ifdef __cplusplus
}
#endif
#endif
