/// Runs a test, measures what it costs, and fails it where that is more than it may cost:
///
///     budget SECONDS LOG NAME COMMAND...
///
/// Counted is processor time, of the command and of all that it starts and waits for, never the clock: a loaded machine
/// makes no test late. SECONDS is the most of it, 0 for any. LOG gets a line, "SECONDS CLOCK STATUS NAME". The exit
/// status is the command's, or 1 where its budget is overrun.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double seconds_of(struct timeval time) {
    return (double)time.tv_sec + 1e-6 * (double)time.tv_usec;
}

static double clock_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/// The exit status of a command as a shell tells it.
static int run(char **command) {
    int status;
    const pid_t child = fork();
    if (child == 0) {
        execvp(command[0], command);
        fprintf(stderr, "budget: %s: %s\n", command[0], strerror(errno));
        _exit(127);
    }
    if (child < 0) {
        fprintf(stderr, "budget: %s\n", strerror(errno));
        return 127;
    }
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return 127;
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int main(int count, char **arguments) {
    if (count < 5) {
        fprintf(stderr, "budget SECONDS LOG NAME COMMAND...\n");
        return 2;
    }
    const double most = strtod(arguments[1], NULL), begun = clock_now();
    const int status = run(arguments + 4);
    struct rusage used;
    getrusage(RUSAGE_CHILDREN, &used);
    const double spent = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
    FILE *log = fopen(arguments[2], "a");
    if (!log || fprintf(log, "%.2f %.2f %d %s\n", spent, clock_now() - begun, status, arguments[3]) < 0 ||
        fclose(log)) {
        fprintf(stderr, "budget: %s: %s\n", arguments[2], strerror(errno));
        return 1;
    }
    if (most > 0 && spent > most) {
        printf("budget: %s took %.1f s of processor time, and may take %g s: make it smaller, divide it, or say LONG "
               "where it "
               "is added (cmake/testing.cmake)\n",
               arguments[3], spent, most);
        return status ? status : 1;
    }
    return status;
}
