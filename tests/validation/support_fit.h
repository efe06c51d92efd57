/// Fits whose tables are files of a folder that the test makes.
#ifndef SUPPORT_FIT_H
#define SUPPORT_FIT_H

#include "whirl/engine/result.h"

/// Makes the folder, and removes it with its files: functions of a group of tests. Return 0 if that was possible.
int fit_make_folder(void **unused);
int fit_remove_folder(void **unused);

/// Writes the path of a file of the folder.
void fit_path(const char *name, char path[256]);

/// Runs a case whose tables are in the folder. The result is freed by whirl_result_free.
whirl_result *fit_of_text(const char *text, int threads);

#endif
