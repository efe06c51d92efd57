/// Shows the progress of a run on standard error: a bar on a terminal, plain lines elsewhere.
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdbool.h>

#include "whirl/engine/study.h"

typedef struct progress_view {
    bool terminal;
    double seconds; ///< time of the last update since the run began
    int round;      ///< round of refinement or of starts from neighbours
    whirl_stage stage;
    size_t points;  ///< points of the stage; grows while a map is refined
    int last_tenth; ///< tenth of the run, the round or these points for which a plain line was written
    bool drawn;     ///< a bar is on the current line
} progress_view;

/// Writes a duration: "12 s", "3:05 min", "2:10 h".
void duration_text(double seconds, char *text, size_t size);

/// Begins to show progress: returns an empty view, a bar if standard error is a terminal.
progress_view progress_begin(void);

/// Shows how far the run is, as whirl_run_options.progress; `view` is a progress_view.
void progress_show(void *view, const whirl_progress *progress);

/// Removes the bar.
void progress_end(progress_view *view);

#endif
