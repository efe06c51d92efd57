/// whirl: nonlinear dynamics of rotating machines. Includes the stable interface, to be read in this order:
///
///     status.h       how functions report errors
///     version.h      the version of the library
///     handles.h      results and their tables
///     job.h          cases and their runs
///     user_system.h  systems of your own
///     signals.h      measured signals
///
/// Programs that include only these headers run with every later library of the same ABI number (docs/abi.md). The rest
/// of the library is in whirl/engine.h.
#ifndef WHIRL_H
#define WHIRL_H

#include "whirl/handles.h"
#include "whirl/job.h"
#include "whirl/signals.h"
#include "whirl/status.h"
#include "whirl/user_system.h"
#include "whirl/version.h"

#endif
