/// What a file is, by its first bytes.
#ifndef WHIRL_INPUT_H
#define WHIRL_INPUT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Reads the first bytes of a plain file, at most size - 1, with a zero byte behind them; gives how many. 0 where there
/// is none or something else (a folder, a pipe, a device), on which it does not wait.
size_t whirl_input_head(const char *path, char *head, size_t size);

#ifdef __cplusplus
}
#endif
#endif
