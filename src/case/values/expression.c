#include "expression.h"
#include "quantity.h"

#include <ctype.h>
#include <math.h>
#include <muParserDLL.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "exhausted.h"
#include "problem.h"

/// Functions of muParser, all with radians; log is the natural logarithm, as ln.
static const char *const words[] = {"sin",   "cos",   "tan",   "asin", "acos",  "atan", "atan2", "sinh", "cosh", "tanh",
                                    "asinh", "acosh", "atanh", "log2", "log10", "log",  "ln",    "exp",  "sqrt", "sign",
                                    "rint",  "abs",   "min",   "max",  "sum",   "avg",  "pi",    "_pi",  "_e",   NULL};

const char *const *expression_words(void) {
    return words;
}

static bool has_word(const char *name, size_t length) {
    for (size_t i = 0; words[i]; i++)
        if (strlen(words[i]) == length && strncmp(words[i], name, length) == 0) return true;
    return false;
}

bool expression_has_word(const char *name) {
    return has_word(name, strlen(name));
}

/// State of the scanner at a place of the text: a comma may occur only inside the parentheses of a function.
typedef struct scanner {
    const char *text;
    size_t at, depth;
    bool calls[EXPRESSION_MAX_DEPTH + 1];
    bool after_name; ///< the last token was a name, so that a parenthesis is a call
} scanner;

static bool is_name_start(char c) {
    return isalpha((unsigned char)c) || c == '_';
}
static bool is_name_part(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

static bool refuse_character(const scanner *s, char why[WHY_SIZE], const char *advice) {
    char shown[SHOWN_SIZE];
    snprintf(why, WHY_SIZE, "is no expression at '%s'%s", text_shown(s->text + s->at, shown), advice);
    return false;
}

static bool scan_number(scanner *s, char why[WHY_SIZE]) {
    const char *end;
    double value;
    if (!quantity_number(s->text + s->at, &value, &end) || is_name_part(*end) || *end == '.')
        return refuse_character(s, why, ", expected a number");
    if (!isfinite(value)) return refuse_character(s, why, ", too large for a number");
    s->at = (size_t)(end - s->text);
    s->after_name = false;
    return true;
}

static bool scan_name(scanner *s, expression_name_fn known, void *context, char why[WHY_SIZE]) {
    const char *name = s->text + s->at;
    size_t length = 1;
    while (is_name_part(name[length])) length++;
    why[0] = '\0';
    if (!has_word(name, length) && !known(context, name, length)) return false;
    s->at += length;
    s->after_name = true;
    return true;
}

/// Returns true at a '=' that assigns; == <= >= != compare.
static bool is_assignment(const scanner *s) {
    const char before = s->at > 0 ? s->text[s->at - 1] : ' ';
    return s->text[s->at] == '=' && s->text[s->at + 1] != '=' && (before == '\0' || !strchr("=<>!", before));
}

static bool scan_sign(scanner *s, char why[WHY_SIZE]) {
    const char c = s->text[s->at];
    if (c == '(') {
        if (s->depth == EXPRESSION_MAX_DEPTH) {
            snprintf(why, WHY_SIZE, "is nested deeper than %d parentheses", EXPRESSION_MAX_DEPTH);
            return false;
        }
        s->calls[++s->depth] = s->after_name;
    } else if (c == ')') {
        if (s->depth-- == 0) return refuse_character(s, why, ", expected as many '(' as ')'");
    } else if (c == ',' && !s->calls[s->depth]) {
        return refuse_character(s, why, ", expected one number (decimals have a point)");
    } else if (is_assignment(s)) {
        return refuse_character(s, why, ", expected no assignment (== compares)");
    } else if (!strchr(" +-*/^,<>=!&|?:", c)) {
        return refuse_character(s, why, "");
    }
    s->at++;
    s->after_name = s->after_name && c == ' ';
    return true;
}

bool expression_check(const char *text, expression_name_fn known, void *context, char why[WHY_SIZE]) {
    // Refuse an empty text, and one that is too long.
    scanner s = {.text = text};
    const size_t length = strlen(text);
    if (strspn(text, " ") == length) {
        snprintf(why, WHY_SIZE, "is an empty expression, expected '= ' and a formula");
        return false;
    }
    if (length > EXPRESSION_MAX_LENGTH) {
        snprintf(why, WHY_SIZE, "is an expression of %zu characters, expected at most %d", length,
                 EXPRESSION_MAX_LENGTH);
        return false;
    }
    // Scan the tokens (numbers, names, signs); the function for each checks that it is allowed there.
    while (s.at < length) {
        const char c = text[s.at];
        bool good;
        if (isdigit((unsigned char)c) || c == '.')
            good = scan_number(&s, why);
        else if (is_name_start(c))
            good = scan_name(&s, known, context, why);
        else
            good = scan_sign(&s, why);
        if (!good) return false;
    }
    // Parentheses have to be closed.
    if (s.depth == 0) return true;
    snprintf(why, WHY_SIZE, "is no expression: a ')' is missing");
    return false;
}

struct expression_evaluator {
    muParserHandle_t parser;
};

/// Error handler of muParser. It does nothing, since errors are asked for later. Without a handler the C interface of
/// muParser writes errors to standard output.
static void remember_only(muParserHandle_t parser) {
    (void)parser;
}

expression_evaluator *evaluator_new(const char *const *names, double *values, size_t count) {
    expression_evaluator *made = calloc(1, sizeof *made);
    if (!made) return NULL;
    made->parser = mupCreate(muBASETYPE_FLOAT);
    if (!made->parser) {
        free(made);
        return NULL;
    }
    mupSetErrorHandler(made->parser, remember_only);
    mupDefineConst(made->parser, "pi", 3.14159265358979323846);
    for (size_t i = 0; i < count; i++)
        if (names[i]) mupDefineVar(made->parser, names[i], &values[i]);
    if (!mupError(made->parser)) return made;
    evaluator_free(made);
    return NULL;
}

void evaluator_free(expression_evaluator *evaluator) {
    if (!evaluator) return;
    mupRelease(evaluator->parser);
    free(evaluator);
}

/// Describes an error by its position: muParser's own message is in a buffer shared by all threads.
static void describe_error(muParserHandle_t parser, const char *text, char why[WHY_SIZE]) {
    char shown[SHOWN_SIZE];
    enum { TOO_MANY_ARGUMENTS = 14, TOO_FEW_ARGUMENTS = 15 }; // EErrorCodes of muParserDef.h, which is C++
    const int position = mupGetErrorPos(parser), code = mupGetErrorCode(parser);
    if (code == TOO_MANY_ARGUMENTS || code == TOO_FEW_ARGUMENTS)
        snprintf(why, WHY_SIZE, "is = %s, where a function has too %s arguments", text_shown(text, shown),
                 code == TOO_MANY_ARGUMENTS ? "many" : "few");
    else if (position < 0 || (size_t)position >= strlen(text))
        snprintf(why, WHY_SIZE, "is no expression: it ends too early, or an argument is missing");
    else
        snprintf(why, WHY_SIZE, "is no expression at '%s'", text_shown(text + position, shown));
}

bool evaluator_take(expression_evaluator *evaluator, const char *text, char why[WHY_SIZE]) {
    const int before = exhausted_watch();
    int count = 0;
    mupErrorReset(evaluator->parser);
    mupSetExpr(evaluator->parser, text);
    if (!mupError(evaluator->parser)) mupEvalMulti(evaluator->parser, &count);
    const bool done = !mupError(evaluator->parser) && count == 1;
    if (exhausted(before))
        snprintf(why, WHY_SIZE, "%s", problem_no_memory);
    else if (!done)
        describe_error(evaluator->parser, text, why);
    return done;
}

double evaluator_again(expression_evaluator *evaluator) {
    const double value = mupEval(evaluator->parser);
    return mupError(evaluator->parser) ? (double)NAN : value;
}

static bool evaluate(expression_evaluator *evaluator, const char *text, double *value, char why[WHY_SIZE]) {
    muParserHandle_t parser = evaluator->parser;
    int count = 0;
    mupErrorReset(parser);
    mupSetExpr(parser, text);
    const double *values = mupError(parser) ? NULL : mupEvalMulti(parser, &count);
    if (mupError(parser) || !values || count != 1) {
        describe_error(parser, text, why);
        return false;
    }
    *value = values[0];
    if (isfinite(*value)) return true;
    char shown[SHOWN_SIZE];
    snprintf(why, WHY_SIZE, "= %s is %s, expected a finite number", text_shown(text, shown),
             isnan(*value) ? "not a number" : "infinite");
    return false;
}

bool evaluator_value(expression_evaluator *evaluator, const char *text, double *value, char why[WHY_SIZE]) {
    const int before = exhausted_watch();
    const bool done = evaluate(evaluator, text, value, why);
    // muParser's interface in C calls every exception but its own an internal error.
    if (!exhausted(before)) return done;
    snprintf(why, WHY_SIZE, "%s", problem_no_memory);
    return false;
}
