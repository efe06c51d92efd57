#include "page.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "number_text.h"
#include "whirl/status.h"

enum { COMMENTS = 64, LAST_ITEM = 98 }; ///< column of comments; last column of items

void page_quantity(double number, const char *unit, char text[QUANTITY_SIZE]) {
    char digits[NUMBER_SIZE];
    snprintf(digits, sizeof digits, "%.15g", number);
    number_text(strtod(digits, NULL), digits);
    snprintf(text, QUANTITY_SIZE, "%s%s%s", digits, unit[0] ? " " : "", unit);
}

page_line page_open(FILE *out, int indent, const char *head) {
    fputs(head, out);
    return (page_line){.out = out, .column = (int)strlen(head), .indent = indent};
}

void page_item(page_line *line, const char *format, ...) {
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    const int length = (int)strlen(text);
    if (line->items++ > 0) line->column += fprintf(line->out, ",");
    if (line->items > 1 && line->column + length + 2 > LAST_ITEM) {
        fprintf(line->out, "\n%*s", line->indent, "");
        line->column = line->indent;
    } else if (line->items > 1) {
        line->column += fprintf(line->out, " ");
    }
    line->column += fprintf(line->out, "%s", text);
}

void page_number(page_line *line, const char *key, double number, const char *unit) {
    char text[QUANTITY_SIZE];
    page_quantity(number, unit, text);
    page_item(line, "%s: %s", key, text);
}

void page_close(page_line *line, const char *tail, const char *comment) {
    line->column += fprintf(line->out, "%s", tail);
    const int blanks = line->column < COMMENTS ? COMMENTS - line->column : 2;
    const int room = PAGE_WIDTH - line->column - blanks - 2;
    char text[PAGE_WIDTH] = "";
    if (comment && room > 0) {
        snprintf(text, sizeof text, "%.*s", room, comment);
        whirl_make_plain(text); // the cut may go through a letter
        fprintf(line->out, "%*s# %s", blanks, "", text);
    }
    fputc('\n', line->out);
}

void page_comment(FILE *out, const char *mark, const char *hang, const char *text) {
    const char *before = mark;
    while (*text) {
        const size_t room = PAGE_WIDTH - strlen(before);
        size_t length = strlen(text);
        if (length > room) {
            length = room;
            while (length > 0 && text[length] != ' ') length--;
            if (length == 0) length = strcspn(text, " "); // a word that is longer than a line
        }
        fprintf(out, "%s%.*s\n", before, (int)length, text);
        text += length;
        text += strspn(text, " ");
        before = hang;
    }
}
