/// whirl: nonlinear dynamics of rotating machines. Includes everything.
///
/// Headers that say "Stable interface" serve programs that were compiled with the headers of another version. All
/// others have structs that grow: a program that uses them runs with libraries of the same minor version, and the
/// dynamic linker refuses others (docs/abi.md).
///
///     case -> rotor -> integrate -> analyze -> study -> result -> report
#ifndef WHIRL_H
#define WHIRL_H

#include "whirl/analyze.h"
#include "whirl/balance.h"
#include "whirl/bearing.h"
#include "whirl/bearing_table.h"
#include "whirl/case.h"
#include "whirl/claims.h"
#include "whirl/descriptor.h"
#include "whirl/ensemble.h"
#include "whirl/figure.h"
#include "whirl/handles.h"
#include "whirl/import.h"
#include "whirl/integrate.h"
#include "whirl/job.h"
#include "whirl/journal.h"
#include "whirl/linear.h"
#include "whirl/model.h"
#include "whirl/orbit.h"
#include "whirl/report.h"
#include "whirl/result.h"
#include "whirl/rotor.h"
#include "whirl/sensitivity.h"
#include "whirl/shown.h"
#include "whirl/signals.h"
#include "whirl/status.h"
#include "whirl/study.h"
#include "whirl/system.h"
#include "whirl/torus.h"
#include "whirl/user_system.h"
#include "whirl/verify.h"
#include "whirl/version.h"
#include "whirl/watched.h"

#endif
