#include "terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { MIN_COLUMNS = 40, USUAL_COLUMNS = 80, MAX_COLUMNS = 1000 };

bool is_terminal(int descriptor) {
    return isatty(descriptor) == 1;
}

bool has_colours(int descriptor) {
    const char *const none = getenv("NO_COLOR"), *const kind = getenv("TERM");
    return is_terminal(descriptor) && !(none && *none) && kind && strcmp(kind, "dumb") != 0;
}

int terminal_columns(int descriptor) {
    struct winsize size = {0};
    const char *const stated = getenv("COLUMNS");
    long columns = stated ? strtol(stated, NULL, 10) : 0;
    if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) columns = size.ws_col;
    if (columns <= 0 || columns > MAX_COLUMNS) columns = USUAL_COLUMNS;
    return columns < MIN_COLUMNS ? MIN_COLUMNS : (int)columns;
}

int text_columns(const char *text) {
    int columns = 0;
    for (; *text; text++) columns += ((unsigned char)*text & 0xC0u) != 0x80u;
    return columns;
}

void print_wrapped(const char *text, int at, int indent, int width) {
    bool first = true;
    while (*(text += strspn(text, " "))) {
        char word[256];
        const size_t length = strcspn(text, " ");
        snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : sizeof word - 1), text);
        const int columns = text_columns(word);
        if (!first && at + 1 + columns > width) {
            printf("\n%*s", indent, "");
            at = indent;
        } else if (!first) {
            putchar(' ');
            at++;
        }
        fputs(word, stdout);
        at += columns;
        text += strlen(word);
        first = false;
    }
}
