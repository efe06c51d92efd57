/// whirl: nonlinear dynamics of rotating machines. Includes the stable interface, to be read in this order:
///
///     status.h       how functions tell of errors
///     version.h      which version this is
///     handles.h      results and their tables
///     job.h          cases and their runs
///     user_system.h  systems of your own
///     signals.h      measured signals
///
/// Programs that use nothing else run with every later library of the same number (docs/abi.md). All else that the
/// library can do is in whirl/engine.h.
#ifndef WHIRL_H
#define WHIRL_H

#include "whirl/handles.h"
#include "whirl/job.h"
#include "whirl/signals.h"
#include "whirl/status.h"
#include "whirl/user_system.h"
#include "whirl/version.h"

#endif
