/// Errors as values: every call that can fail returns a status with a sentence a person can act on.
#ifndef WHIRL_STATUS_H
#define WHIRL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum whirl_code {
    WHIRL_OK = 0,
    WHIRL_BAD_INPUT,         ///< the case, the options or the arguments are wrong; the caller can mend them
    WHIRL_NO_MEMORY,         ///< an allocation failed
    WHIRL_IO_ERROR,          ///< a file could not be read or written
    WHIRL_NUMERICAL_FAILURE, ///< a solver gave up for a reason that is not a diverging motion
    WHIRL_STOPPED,           ///< the caller asked for a stop
    WHIRL_MISSING_PROGRAM    ///< an outside program (gnuplot) is not installed
} whirl_code;

enum { WHIRL_MESSAGE_SIZE = 400 };

/// Outcome of a call. `message` is one English sentence without a final newline; empty when all is well.
/// Returned by value; owns nothing.
typedef struct whirl_status {
    whirl_code code;
    char message[WHIRL_MESSAGE_SIZE];
} whirl_status;

/// The status of success.
whirl_status whirl_ok(void);

/// A status with a printf-formatted sentence; a longer one is cut at WHIRL_MESSAGE_SIZE - 1 bytes.
whirl_status whirl_fail(whirl_code code, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// What a code means, in a few words ("bad input"). Static text.
const char *whirl_code_text(whirl_code code);

/// Puts '?' in the place of every character of a line that is no plain text: control characters, which terminals obey,
/// those that turn the direction of a line or end it, and bytes that are no UTF-8. For texts from files that anybody
/// may have written, before they are shown.
void whirl_make_plain(char *text);

#ifdef __cplusplus
}
#endif
#endif
