/// Programs that are run for reports, in other folders than this one.
#ifndef REPORT_PROGRAM_H
#define REPORT_PROGRAM_H

/// Returns the name to execute for a program: a bare name for the PATH, or an absolute path, since a relative one would
/// not work from another folder. NULL if the file does not exist, or without memory. Freed by the caller.
char *program_found(const char *program);

#endif
