/// Parses the arguments of a command by argp, after suggesting options for unknown ones, which argp does not do.
#include "command.h"
#include "guard.h"

#include <stdbool.h>
#include <string.h>

enum { MAX_OPTIONS = 32 };

/// Long options of a command, including those that argp adds.
typedef struct option_names {
    const char *names[MAX_OPTIONS];
    bool takes_argument[MAX_OPTIONS]; ///< the option takes its argument from the next word
    size_t count;
} option_names;

static void add_option(option_names *all, const char *name, bool takes_argument) {
    if (all->count == MAX_OPTIONS) return;
    all->takes_argument[all->count] = takes_argument;
    all->names[all->count++] = name;
}

static void collect(const struct argp *argp, option_names *all) {
    all->count = 0;
    for (const struct argp_option *one = argp->options; one && (one->name || one->key || one->doc); one++)
        if (one->name && !(one->flags & OPTION_DOC))
            add_option(all, one->name, one->arg && !(one->flags & OPTION_ARG_OPTIONAL));
    add_option(all, "help", false);
    add_option(all, "usage", false);
    add_option(all, "version", false);
}

/// Returns the index of the option that a word without its dashes names, by its whole name or its beginning; `count` if
/// there is none.
static size_t find_option(const option_names *all, const char *word, size_t length) {
    for (size_t i = 0; i < all->count; i++)
        if (strncmp(all->names[i], word, length) == 0) return i;
    return all->count;
}

/// Returns true if a word is a short option with its argument in the next word: "-o".
static bool takes_next(const struct argp *argp, const char *word) {
    for (const struct argp_option *one = argp->options; one && (one->name || one->key || one->doc); one++)
        if (one->arg && !(one->flags & OPTION_ARG_OPTIONAL) && word[1] == one->key && word[2] == '\0') return true;
    return false;
}

/// Reports an unknown option, suggests the nearest one, and returns false; returns true if no option is near.
static bool know_option(const option_names *all, const char *program, const char *word, size_t length) {
    char name[64];
    if (length >= sizeof name) return true;
    memcpy(name, word, length);
    name[length] = '\0';
    const char *nearest = whirl_nearest_name(name, all->names, all->count);
    if (!nearest) return true; // argp reports it
    complain_as(program, "there is no option '--%s', did you mean '--%s'?", name, nearest);
    return false;
}

static bool know_options(const struct argp *argp, int argc, char **argv, unsigned flags) {
    option_names all;
    collect(argp, &all);
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        if (argv[i][0] != '-' && (flags & ARGP_IN_ORDER)) return true; // the command reads the other arguments
        if (strncmp(argv[i], "--", 2) != 0) {
            i += argv[i][0] == '-' && takes_next(argp, argv[i]);
            continue;
        }
        const char *word = argv[i] + 2;
        const size_t length = strcspn(word, "="), index = find_option(&all, word, length);
        if (index == all.count && !know_option(&all, argv[0], word, length)) return false;
        i += index < all.count && all.takes_argument[index] && word[length] == '\0';
    }
    return true;
}

int read_arguments(const struct argp *argp, int argc, char **argv, unsigned flags, void *input) {
    guard_rest(); // argp may end the program itself
    if (!know_options(argp, argc, argv, flags)) return EXIT_BAD_INPUT;
    const error_t failed = argp_parse(argp, argc, argv, flags, NULL, input);
    guard_begin();
    if (failed) complain("the arguments cannot be read: %s", strerror(failed));
    return failed ? EXIT_FAILED : EXIT_DONE;
}
