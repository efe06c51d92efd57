/// Errors as values: every call that can fail returns a status with a sentence a person can act on.
///
/// Stable interface: docs/abi.md says for how long.
#ifndef WHIRL_STATUS_H
#define WHIRL_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

/// What kind of failure a call ended with.
typedef enum whirl_code {
    WHIRL_OK = 0,            ///< all is well
    WHIRL_BAD_INPUT,         ///< the case, the options or the arguments are wrong; the caller can mend them
    WHIRL_NO_MEMORY,         ///< an allocation failed
    WHIRL_IO_ERROR,          ///< a file could not be read or written
    WHIRL_NUMERICAL_FAILURE, ///< a solver gave up for a reason that is not a diverging motion
    WHIRL_STOPPED,           ///< the caller asked for a stop
    WHIRL_MISSING_PROGRAM    ///< an outside program (gnuplot) is not installed
} whirl_code;

/// Sizes of messages.
enum {
    WHIRL_MESSAGE_SIZE = 400,   ///< bytes of a message at most, with the zero byte at its end
    WHIRL_MESSAGES_KEPT = 4096, ///< how many different messages of the process last
};

/// Outcome of a call, returned by value; owns nothing. `message` is one English sentence without a final newline, ""
/// when all is well, and never NULL in what the library returns. The text lies in the library and is not freed. It
/// stays until calls of the process, on any thread, have failed in WHIRL_MESSAGES_KEPT other ways (equal sentences
/// count once, from their latest use): whoever keeps a message beyond further calls copies it.
typedef struct whirl_status {
    whirl_code code;     ///< what kind of failure, or WHIRL_OK
    const char *message; ///< one sentence, or ""
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
