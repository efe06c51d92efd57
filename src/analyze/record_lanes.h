/// Recording many motions side by side.
#ifndef ANALYZE_RECORD_LANES_H
#define ANALYZE_RECORD_LANES_H

#include "whirl/analyze.h"

/// whirl_record_motions for systems that whirl_ensemble_takes, in an ensemble of at least `lanes` lanes (0: as many as are
/// fast). The options are sound.
whirl_status record_in_lanes(const whirl_system *system, const whirl_integrate_options *integrate,
                             const whirl_record_options *options, const whirl_task_source *source, size_t lanes,
                             const whirl_monitor *monitor);

#endif
