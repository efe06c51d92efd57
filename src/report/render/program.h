/// Programs that are run for reports, in other folders than this one.
#ifndef REPORT_PROGRAM_H
#define REPORT_PROGRAM_H

/// What is to be run for a program: a name for the PATH, or the whole path of what is named with a folder, which a
/// relative one would not lead to from elsewhere. NULL where that is not there, or without memory; freed by the caller.
char *program_found(const char *program);

#endif
