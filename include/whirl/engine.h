/// All of the library: the stable interface and the engine behind it, whose structs grow. A program that uses these
/// headers runs with libraries of the same minor version, and the dynamic linker refuses others (docs/abi.md).
///
///     case -> rotor -> integrate -> analyze -> study -> result -> report
#ifndef WHIRL_ENGINE_H
#define WHIRL_ENGINE_H

#include "whirl/engine/analyze.h"
#include "whirl/engine/branch.h"
#include "whirl/engine/case.h"
#include "whirl/engine/claims.h"
#include "whirl/engine/dataset.h"
#include "whirl/engine/descriptor.h"
#include "whirl/engine/ensemble.h"
#include "whirl/engine/fields.h"
#include "whirl/engine/figure.h"
#include "whirl/engine/fit.h"
#include "whirl/engine/integrate.h"
#include "whirl/engine/journal.h"
#include "whirl/engine/linear.h"
#include "whirl/engine/lyapunov.h"
#include "whirl/engine/orbit.h"
#include "whirl/engine/record.h"
#include "whirl/engine/report.h"
#include "whirl/engine/result.h"
#include "whirl/engine/rotor.h"
#include "whirl/engine/running.h"
#include "whirl/engine/sensitivity.h"
#include "whirl/engine/sensors.h"
#include "whirl/engine/spread.h"
#include "whirl/engine/stable_orbits.h"
#include "whirl/engine/stop.h"
#include "whirl/engine/study.h"
#include "whirl/engine/system.h"
#include "whirl/engine/tolerances.h"
#include "whirl/engine/torsion.h"
#include "whirl/engine/torus.h"
#include "whirl/engine/torus_branch.h"
#include "whirl/engine/verdict.h"
#include "whirl/engine/watched.h"
#include "whirl/whirl.h"

#endif
