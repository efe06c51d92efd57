/// Errors as values: every call that can fail returns a status with one sentence that a person can act on.
///
/// Stable interface: docs/abi.md says for how long.
#ifndef WHIRL_STATUS_H
#define WHIRL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

/// Kinds of failure.
typedef enum whirl_code {
    WHIRL_OK = 0,            ///< all is well
    WHIRL_BAD_INPUT,         ///< the case, the options or the arguments are wrong; the caller can correct them
    WHIRL_NO_MEMORY,         ///< an allocation failed
    WHIRL_IO_ERROR,          ///< a file could not be read or written
    WHIRL_NUMERICAL_FAILURE, ///< a solver gave up (a diverging motion is a result, not a failure)
    WHIRL_STOPPED,           ///< the caller asked for a stop
    WHIRL_MISSING_PROGRAM    ///< an outside program (gnuplot) is not installed
} whirl_code;

/// Sizes of messages.
enum {
    WHIRL_MESSAGE_SIZE = 400,   ///< longest message in bytes, with its terminating zero
    WHIRL_MESSAGES_KEPT = 4096, ///< number of different messages that the process keeps
};

/// Outcome of a call, returned by value; owns nothing. `message` is one English sentence without a final newline, "" on
/// success, and never NULL in a status that the library returns. The library owns the text; callers do not free it. The
/// text is valid until WHIRL_MESSAGES_KEPT other messages have come after it, from any thread of the process (equal
/// sentences count once, from their latest use). Copy a message to keep it beyond further calls.
typedef struct whirl_status {
    whirl_code code;     ///< kind of failure, or WHIRL_OK
    const char *message; ///< one sentence, or ""
} whirl_status;

/// Returns the status of success.
whirl_status whirl_ok(void);

/// Returns a status with a printf-formatted sentence; one above WHIRL_MESSAGE_SIZE - 1 bytes is cut and ends with
/// "...".
whirl_status whirl_fail(whirl_code code, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// Returns the meaning of a code in a few words ("bad input"). Static text.
const char *whirl_code_text(whirl_code code);

/// Replaces every unsafe character of a line by '?': control characters, characters that change the direction of a line
/// or end it, and bytes that are not UTF-8. Use it before text of an untrusted file is shown.
void whirl_make_plain(char *text);

#ifdef __cplusplus
}
#endif
#endif
