#include "html.h"

#include <stdarg.h>

#include "number_text.h"
#include "utf8.h"

static const char *entity(char letter) {
    switch (letter) {
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '&':
        return "&amp;";
    case '"':
        return "&quot;";
    case '\'':
        return "&#39;";
    default:
        return NULL;
    }
}

void html_text(FILE *stream, const char *text) {
    while (*text) {
        const size_t length = utf8_length_of_text(text);
        const char *replacement = length == 1 ? entity(*text) : NULL;
        const int plain = length > 0 && (utf8_is_plain(text, length) || *text == '\n' || *text == '\t');
        if (replacement)
            fputs(replacement, stream);
        else if (!plain)
            fputs("\xEF\xBF\xBD", stream);
        else
            fwrite(text, 1, length, stream);
        text += length ? length : 1;
    }
}

void html_printf(FILE *stream, const char *format, ...) {
    char text[4096];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    html_text(stream, text);
}

void html_table(FILE *stream, const char *label, const char *class) {
    fputs("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"", stream);
    html_text(stream, label);
    fprintf(stream, *class ? "\"><table class=\"%s\">\n" : "\"><table>%s\n", class);
}
