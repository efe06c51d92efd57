#include "gnuplot.h"
#include "program.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "utf8.h"
#include "whirl/status.h"

extern char **environ; // no POSIX header declares it

enum { MAX_PROCESSES = 8, COMMAND_MISSING = 127, LOG_NAME_SIZE = 512 };

void gnuplot_string(FILE *script, const char *text) {
    fputc('\'', script);
    while (*text) {
        const size_t length = utf8_length_of_text(text);
        if (*text == '\'')
            fputs("\xE2\x80\x99", script);
        else if (length == 0)
            fputc('?', script);
        else if (!utf8_is_plain(text, length))
            fputc(' ', script);
        else
            fwrite(text, 1, length, script);
        text += length ? length : 1;
    }
    fputc('\'', script);
}

void gnuplot_comment(FILE *script, const char *text) {
    while (*text) {
        const size_t length = utf8_length_of_text(text);
        if (length == 0 || *text == '\\' || !utf8_is_plain(text, length))
            fputc(' ', script);
        else
            fwrite(text, 1, length, script);
        text += length ? length : 1;
    }
}

/// Program and environment of all jobs. Scripts are UTF-8, which gnuplot assumes only in a UTF-8 locale.
typedef struct launch {
    const char *program;
    char **environment; ///< environment of this process, with a UTF-8 locale
} launch;

static char **utf8_environment(void) {
    static char locale[] = "LC_ALL=C.UTF-8";
    size_t count = 0, kept = 0;
    while (environ[count]) count++;
    char **made = calloc(count + 2, sizeof *made);
    if (!made) return NULL;
    for (size_t i = 0; i < count; i++)
        if (strncmp(environ[i], "LC_ALL=", strlen("LC_ALL=")) != 0) made[kept++] = environ[i];
    made[kept] = locale;
    return made;
}

/// Replaces this process by gnuplot in the job's folder; uses only calls that are safe between fork and exec.
static _Noreturn void become_gnuplot(const launch *how, const gnuplot_job *job, const char *log) {
    if (chdir(job->folder) != 0) _exit(1);
    const int nothing = open("/dev/null", O_RDONLY);
    const int words = open(log, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
    if (nothing < 0 || words < 0) _exit(1);
    dup2(nothing, STDIN_FILENO);
    dup2(words, STDOUT_FILENO);
    dup2(words, STDERR_FILENO);
    char name[] = "gnuplot";
    char script[LOG_NAME_SIZE];
    strncpy(script, job->script, sizeof script - 1);
    script[sizeof script - 1] = '\0';
    char *const arguments[] = {name, script, NULL};
    environ = how->environment;
    execvp(how->program, arguments);
    _exit(errno == ENOENT || errno == EACCES ? COMMAND_MISSING : 1);
}

static void log_name(const gnuplot_job *job, char *log) {
    snprintf(log, LOG_NAME_SIZE, "%.500s.log", job->script);
}

static void remove_empty_log(const gnuplot_job *job) {
    char log[LOG_NAME_SIZE], path[4096 + LOG_NAME_SIZE];
    struct stat found;
    log_name(job, log);
    snprintf(path, sizeof path, "%.4000s/%s", job->folder, log);
    if (stat(path, &found) == 0 && found.st_size == 0) unlink(path);
}

/// Removes earlier outputs of gnuplot, which would write through links and keep the modes of existing files.
static void remove_earlier(const gnuplot_job *job) {
    static const char *const endings[] = {"png", "pdf", "gp.log"};
    char path[4096 + LOG_NAME_SIZE];
    const size_t length = strlen(job->script), stem = length > 3 ? length - 3 : 0; // without .gp
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        snprintf(path, sizeof path, "%.4000s/%.*s.%s", job->folder, (int)(stem < 480 ? stem : 480), job->script,
                 endings[i]);
        unlink(path);
    }
}

static pid_t gnuplot_start(const launch *how, const gnuplot_job *job) {
    char log[LOG_NAME_SIZE];
    log_name(job, log);
    remove_earlier(job);
    const pid_t child = fork();
    if (child == 0) become_gnuplot(how, job, log);
    return child;
}

/// Running child processes, each with the index of its job.
typedef struct crew {
    size_t count;
    pid_t child[MAX_PROCESSES];
    size_t job[MAX_PROCESSES];
} crew;

/// Waits for the oldest child, notes whether its job was drawn, and returns its exit status.
static int finish_oldest(crew *running, gnuplot_job *jobs) {
    int wait_status = 0;
    while (waitpid(running->child[0], &wait_status, 0) < 0)
        if (errno != EINTR) return 1;
    gnuplot_job *job = &jobs[running->job[0]];
    const int code = WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 1;
    job->drawn = code == 0;
    remove_empty_log(job);
    running->count--;
    memmove(running->child, running->child + 1, running->count * sizeof *running->child);
    memmove(running->job, running->job + 1, running->count * sizeof *running->job);
    return code;
}

static size_t process_count(void) {
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    return cores < 1 ? 1 : cores > MAX_PROCESSES ? MAX_PROCESSES : (size_t)cores;
}

static whirl_status run_all(const char *program, gnuplot_job *jobs, size_t count) {
    const launch how = {program, utf8_environment()};
    if (!how.environment) return whirl_fail(WHIRL_NO_MEMORY, "no memory to start gnuplot");
    const size_t most = process_count();
    crew running = {0};
    bool missing = false;
    // Start jobs while there are free processes, else wait for the oldest one.
    for (size_t next = 0; next < count || running.count > 0;) {
        if (next < count && running.count < most && !missing) {
            const pid_t child = gnuplot_start(&how, &jobs[next]);
            if (child > 0) {
                running.child[running.count] = child;
                running.job[running.count++] = next;
            }
            next++;
        } else if (running.count > 0) {
            missing |= finish_oldest(&running, jobs) == COMMAND_MISSING;
        } else {
            break;
        }
    }
    free(how.environment);
    // Report a missing program, or the first failed script.
    if (missing)
        return whirl_fail(WHIRL_MISSING_PROGRAM,
                          "%s is not installed, so no figure was drawn; the scripts and data are there "
                          "(apt-get install gnuplot-nox)",
                          program);
    for (size_t i = 0; i < count; i++)
        if (!jobs[i].drawn)
            return whirl_fail(WHIRL_IO_ERROR, "gnuplot failed on %.200s/%.100s (see the .log file next to it)",
                              jobs[i].folder, jobs[i].script);
    return whirl_ok();
}

whirl_status gnuplot_run(const char *program, gnuplot_job *jobs, size_t count) {
    for (size_t i = 0; i < count; i++) jobs[i].drawn = false;
    char *found = program_found(program ? program : "gnuplot");
    if (!found)
        return whirl_fail(WHIRL_MISSING_PROGRAM,
                          "%.300s is not there, so no figure was drawn; the scripts and data are", program);
    const whirl_status status = run_all(found, jobs, count);
    free(found);
    return status;
}
