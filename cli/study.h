/// From a case to its result: what `whirl run` and `whirl merge` have in common.
#ifndef CLI_STUDY_H
#define CLI_STUDY_H

#include "study_arguments.h"

/// Reads the arguments of a command, then computes the study of its case, or takes what journals have of it, and writes
/// the result; gives the exit status.
int study_command(const struct argp *argp, int argc, char **argv, study_arguments *arguments);

#endif
