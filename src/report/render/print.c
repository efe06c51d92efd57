#include <errno.h>
#include <fcntl.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "print.h"
#include "program.h"

enum { COMMAND_MISSING = 127, NAME_SIZE = 64 };

/// Replaces this process by the program in the folder; uses only calls that are safe between fork and exec.
static _Noreturn void become(const char *program, const char *folder, char *page, char *pdf) {
    char name[] = "weasyprint", quiet[] = "--quiet";
    char *const arguments[] = {name, quiet, page, pdf, NULL};
    const int nothing = open("/dev/null", O_RDWR);
    if (chdir(folder) != 0 || nothing < 0) _exit(1);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++) dup2(nothing, stream);
    execvp(program, arguments);
    _exit(errno == ENOENT || errno == EACCES ? COMMAND_MISSING : 1);
}

whirl_status document_print(const char *program, const char *folder, const char *page, const char *pdf) {
    // Prepare the names of both files, and remove an earlier PDF.
    char from[NAME_SIZE], to[NAME_SIZE], path[4096 + NAME_SIZE];
    int outcome = 0;
    if (!program) program = "weasyprint";
    snprintf(from, sizeof from, "%.60s", page);
    snprintf(to, sizeof to, "%.60s", pdf);
    snprintf(path, sizeof path, "%.4000s/%s", folder, to);
    unlink(path); // otherwise a link of this name would be followed
    // Run the program, and wait for it.
    char *found = program_found(program);
    const pid_t child = found ? fork() : -1;
    if (child == 0) become(found, folder, from, to);
    while (child > 0 && waitpid(child, &outcome, 0) < 0 && errno == EINTR) continue;
    const int code = !found ? COMMAND_MISSING : child > 0 && WIFEXITED(outcome) ? WEXITSTATUS(outcome) : 1;
    // Say what failed.
    whirl_status status = whirl_ok();
    if (code == COMMAND_MISSING)
        status =
            whirl_fail(WHIRL_MISSING_PROGRAM,
                       "'%.100s', which makes the PDF, is not there: %.200s is written, and a browser prints it (on "
                       "Debian: apt-get install weasyprint)",
                       program, page);
    else if (code != 0 || access(path, F_OK) != 0)
        status = whirl_fail(WHIRL_IO_ERROR, "'%.100s' failed to make %.200s", program, path);
    free(found);
    return status;
}
