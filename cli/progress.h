/// Progress of a run on standard error: a bar on a terminal, plain lines elsewhere.
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdbool.h>

#include "whirl/engine/study.h"

typedef struct progress_view {
    bool terminal;
    double seconds; ///< time in the run of the last update
    int round;      ///< round of refinement
    whirl_stage stage;
    size_t points;  ///< points of the stage; grows while a map is refined
    int last_tenth; ///< tenth of the run, the round or these points for which a plain line was written
    bool drawn;     ///< a bar is on the current line
} progress_view;

/// "12 s", "3:05 min", "2:10 h".
void duration_text(double seconds, char *text, size_t size);

/// A view that suits standard error.
progress_view progress_begin(void);

/// Shows how far the run is; `view` is a progress_view. As whirl_run_options.progress wants it.
void progress_show(void *view, const whirl_progress *progress);

/// Removes the bar.
void progress_end(progress_view *view);

#endif
