/// From a case to its result: code shared by `whirl run` and `whirl merge`.
#ifndef CLI_STUDY_H
#define CLI_STUDY_H

#include "study_arguments.h"

/// Reads the arguments of a command, computes the study of its case or takes its points from journals, and writes the
/// result. Returns the exit status.
int study_command(const struct argp *argp, int argc, char **argv, study_arguments *arguments);

#endif
