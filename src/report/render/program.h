/// Finds programs that are run in another folder.
#ifndef REPORT_PROGRAM_H
#define REPORT_PROGRAM_H

/// Returns the name to execute for a program: a bare name for the PATH, or an absolute path, since a relative one would
/// not work from another folder. NULL if the file does not exist, or without memory. The caller frees the name.
char *program_found(const char *program);

#endif
