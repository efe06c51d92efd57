/// Progress of a run on standard error: a bar on a terminal, plain lines elsewhere.
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdbool.h>

#include "whirl/engine/study.h"

typedef struct progress_view {
    bool terminal;
    double seconds; ///< of the run, when it was last shown
    int round;      ///< of refinement, and
    whirl_stage stage;
    size_t points;  ///< of the stage: more than before where a map is refined further
    int last_tenth; ///< of the run, the round or these points that a plain line was written for
    bool drawn;     ///< a bar stands on the current line
} progress_view;

/// "12 s", "3:05 min", "2:10 h".
void duration_text(double seconds, char *text, size_t size);

/// A view that suits standard error.
progress_view progress_begin(void);

/// Shows how far the run is; `view` is a progress_view. As whirl_run_options.progress wants it.
void progress_show(void *view, const whirl_progress *progress);

/// Takes the bar away.
void progress_end(progress_view *view);

#endif
