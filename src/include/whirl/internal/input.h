/// Input files: their first bytes, from which programs recognise their kind.
#ifndef WHIRL_INPUT_H
#define WHIRL_INPUT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Reads the first bytes of a regular file, at most size - 1, adds a terminating zero, and returns their number. 0 if
/// there is no file, or something else (a folder, a pipe, a device), without waiting for it.
size_t whirl_input_head(const char *path, char *head, size_t size);

#ifdef __cplusplus
}
#endif
#endif
