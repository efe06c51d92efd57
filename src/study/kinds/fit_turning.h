/// Machines of a fit along the value of an onset: a parameter, or the speed.
#ifndef STUDY_FIT_TURNING_H
#define STUDY_FIT_TURNING_H

#include "fit_place.h"

/// A study whose batch varies the value of the onset. If that is the speed, the batch's own parameter has no name.
typedef struct fit_turning {
    const whirl_study *base;
    double speed; ///< rad/s, constant speed of the machines if another parameter varies
    whirl_study study;
    whirl_batch batch;
} fit_turning;

/// Makes the study of a place. It borrows from the place. It holds pointers to *t, which must not be moved.
void fit_turning_make(fit_turning *t, const fit_place *p);

#endif
