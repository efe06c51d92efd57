// The functions of ranks.h for `whirl-mpi`, by MPI: processes that mpirun or srun have started.
#define _GNU_SOURCE // sched_getaffinity, on_exit; NOLINT(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
#include "ranks.h"

#include <mpi.h>
#include <pthread.h>
#include <sched.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "command.h"
#include "cores.h"

/// Outcome of all ranks together.
typedef struct outcome {
    int failure;  ///< largest exit status of a failed rank, 0 if none failed
    int reporter; ///< the first rank with this exit status
    int first;    ///< exit status of the first rank
} outcome;

/// State of this rank: a process has one MPI.
static struct {
    int count, number;
    int64_t words[RANKS_WORDS]; ///< used on the first rank
    pthread_mutex_t lock, asking;
    pthread_t answerer; ///< used on the first rank
    whirl_stop leaving;
    FILE *muted; ///< suppressed output of this rank, unless it is the first one
    char *text;
    size_t text_size;
    bool dismissed; ///< the first rank works alone
    bool over;      ///< all ranks have exchanged their outcomes, in `end`
    outcome end;
} ranks = {.count = 1, .lock = PTHREAD_MUTEX_INITIALIZER, .asking = PTHREAD_MUTEX_INITIALIZER};

/// Locks MPI: only one thread may call it at a time (MPI_THREAD_SERIALIZED).
static void lock(void) {
    pthread_mutex_lock(&ranks.lock);
}

static void unlock(void) {
    pthread_mutex_unlock(&ranks.lock);
}

int ranks_count(void) {
    return ranks.dismissed ? 1 : ranks.count;
}

void ranks_dismiss(void) {
    ranks.dismissed = true;
}

int ranks_number(void) {
    return ranks.number;
}

static void rest(long microseconds) {
    nanosleep(&(struct timespec){.tv_nsec = 1000 * microseconds}, NULL);
}

void ranks_rest(void) {
    rest(2000);
}

/// Waits for a request without keeping a core busy, as MPI_Wait would: other ranks may be computing on it.
static void await(MPI_Request *request, ranks_meanwhile meanwhile) {
    for (;;) {
        int done;
        lock();
        MPI_Test(request, &done, MPI_STATUS_IGNORE);
        unlock();
        if (done) return;
        if (meanwhile) meanwhile();
        ranks_rest();
    }
}

// ---------------------------------------------------------------- numbers that all ranks see

// The first rank stores them, and a thread of it answers requests of the others. One-sided communication needs no such
// thread if the network can access memory by itself. Elsewhere MPI emulates it by messages, too, and the emulation of
// Open MPI 4.1 fails at times.

enum { TAG_QUESTION = 1, TAG_ANSWER };

/// Request to change shared numbers, `count` of them from `word` on.
typedef struct question {
    int64_t word, count, is_raised;
    int64_t amounts[RANKS_MAX];
} question;

enum { QUESTION_SIZE = sizeof(question) / sizeof(int64_t) };

/// Changes shared numbers, on the first rank; returns their previous values.
static void change(const question *asked, int64_t before[RANKS_MAX]) {
    for (int64_t i = 0; i < asked->count; i++) {
        int64_t *word = &ranks.words[asked->word + i];
        before[i] = *word;
        if (!asked->is_raised) *word += asked->amounts[i];
        if (asked->is_raised && *word < asked->amounts[i]) *word = asked->amounts[i];
    }
}

/// Answers a waiting question. Returns false if there was none.
static bool answer_one(void) {
    MPI_Status from;
    int waiting;
    MPI_Iprobe(MPI_ANY_SOURCE, TAG_QUESTION, MPI_COMM_WORLD, &waiting, &from);
    if (!waiting) return false;
    question asked;
    int64_t before[RANKS_MAX] = {0};
    MPI_Recv(&asked, QUESTION_SIZE, MPI_INT64_T, from.MPI_SOURCE, TAG_QUESTION, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    change(&asked, before);
    MPI_Send(before, RANKS_MAX, MPI_INT64_T, from.MPI_SOURCE, TAG_ANSWER, MPI_COMM_WORLD);
    return true;
}

/// Thread of the first rank that answers questions while its other threads compute. Without questions it polls less
/// often.
static void *answer(void *unused) {
    const long shortest = 100, longest = 2000; // microseconds
    for (long pause = shortest; !ranks.leaving; rest(pause)) {
        pause = 2 * pause < longest ? 2 * pause : longest;
        lock();
        while (answer_one()) pause = shortest;
        unlock();
    }
    return unused;
}

/// Asks the first rank and waits for the answer; a rank asks one question at a time.
static void ask(const question *asked, int64_t before[RANKS_MAX]) {
    MPI_Request requests[2];
    pthread_mutex_lock(&ranks.asking);
    lock();
    MPI_Irecv(before, RANKS_MAX, MPI_INT64_T, 0, TAG_ANSWER, MPI_COMM_WORLD, &requests[0]);
    MPI_Isend(asked, QUESTION_SIZE, MPI_INT64_T, 0, TAG_QUESTION, MPI_COMM_WORLD, &requests[1]);
    for (int done = 0; !done;) {
        MPI_Testall(2, requests, &done, MPI_STATUSES_IGNORE);
        unlock();
        if (!done) rest(100);
        lock();
    }
    unlock();
    pthread_mutex_unlock(&ranks.asking);
}

static void change_for_all(const question *asked, int64_t before[RANKS_MAX]) {
    if (ranks.number > 0) {
        ask(asked, before);
        return;
    }
    lock();
    change(asked, before);
    unlock();
}

int64_t ranks_add(size_t word, int64_t amount) {
    const question asked = {.word = (int64_t)word, .count = 1, .amounts = {amount}};
    int64_t before[RANKS_MAX];
    change_for_all(&asked, before);
    return before[0];
}

void ranks_add_all(size_t word, size_t count, int64_t *amounts) {
    question asked = {.word = (int64_t)word, .count = (int64_t)count};
    int64_t before[RANKS_MAX];
    for (size_t i = 0; i < count; i++) asked.amounts[i] = amounts[i];
    change_for_all(&asked, before);
    for (size_t i = 0; i < count; i++) amounts[i] += before[i];
}

void ranks_raise(size_t word, int64_t value) {
    const question asked = {.word = (int64_t)word, .count = 1, .is_raised = true, .amounts = {value}};
    int64_t before[RANKS_MAX];
    change_for_all(&asked, before);
}

// ---------------------------------------------------------------- outcomes and data of all ranks

static bool is_failure(int status) {
    return status != EXIT_DONE && status != EXIT_UNFINISHED;
}

static int agree(int status, ranks_meanwhile meanwhile) {
    // MPI_MAXLOC takes pairs of a number and a rank, and gives the largest number with the lowest rank that has it.
    const int own[2][2] = {{is_failure(status) ? status : 0, ranks.number},
                           {ranks.number == 0 ? status : 0, ranks.number}};
    int worst[2][2];
    if (ranks.count == 1) return status;
    if (!ranks.over) {
        MPI_Request request;
        lock();
        MPI_Iallreduce(own, worst, 2, MPI_2INT, MPI_MAXLOC, MPI_COMM_WORLD, &request);
        unlock();
        await(&request, meanwhile);
        ranks.end = (outcome){worst[0][0], worst[0][1], worst[1][0]};
        ranks.over = ranks.end.failure != 0;
    }
    return ranks.end.failure ? ranks.end.failure : ranks.end.first;
}

int ranks_agree(int status) {
    return ranks.dismissed ? status : agree(status, NULL);
}

void ranks_share(void *bytes, size_t size) {
    enum { PIECE = 1 << 30 }; // MPI counts with whole numbers of 32 bits
    for (size_t at = 0; at < size && ranks.count > 1; at += PIECE) {
        MPI_Request request;
        const size_t left = size - at;
        lock();
        MPI_Ibcast((char *)bytes + at, (int)(left < PIECE ? left : PIECE), MPI_BYTE, 0, MPI_COMM_WORLD, &request);
        unlock();
        await(&request, NULL);
    }
}

/// Returns the number of threads of this rank: its part of the cores that it may use. 4 ranks that share 16 cores have
/// 4 each, whether ranks are bound to cores or not.
static int part_of_cores(void) {
    cpu_set_t own, *all = NULL;
    MPI_Comm neighbours;
    int count = 0;
    double part = 0.0;
    CPU_ZERO(&own);
    if (sched_getaffinity(0, sizeof own, &own) != 0) return 1;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &neighbours);
    MPI_Comm_size(neighbours, &count);
    all = calloc((size_t)count, sizeof *all);
    if (all) {
        MPI_Allgather(&own, sizeof own, MPI_BYTE, all, sizeof own, MPI_BYTE, neighbours);
        for (int core = 0; core < CPU_SETSIZE; core++) {
            int users = 0;
            for (int i = 0; i < count; i++) users += CPU_ISSET(core, &all[i]) != 0;
            part += CPU_ISSET(core, &own) ? 1.0 / users : 0.0;
        }
    }
    free(all);
    MPI_Comm_free(&neighbours);
    return part < 1.0 ? 1 : (int)(part + 1e-9);
}

static int default_threads;

int ranks_threads(void) {
    return default_threads;
}

static int find_threads(void) {
    const char *wanted = getenv("OMP_NUM_THREADS");
    const long count = wanted ? strtol(wanted, NULL, 10) : 0;
    const int part = ranks.count > 1 ? part_of_cores() : available_cores();
    return count >= 1 && count <= 1024 ? (int)count : part;
}

// ---------------------------------------------------------------- beginning and ending

static void hold_back_output(void) {
    FILE *nowhere = fopen("/dev/null", "w");
    ranks.muted = open_memstream(&ranks.text, &ranks.text_size);
    // Only the C library's streams are redirected: reports of sanitizers appear.
    if (nowhere) stdout = nowhere;
    if (ranks.muted) stderr = ranks.muted;
}

/// Prints the suppressed output of the rank that failed; the first rank prints everything else.
static void ranks_print(void) {
    if (!ranks.muted) return;
    fflush(ranks.muted);
    if (ranks.end.failure && ranks.end.reporter == ranks.number && ranks.text)
        dprintf(2, "%.*s", (int)ranks.text_size, ranks.text);
}

/// Ends the answering thread once no rank asks any more.
static void end_answers(void) {
    MPI_Request request;
    lock();
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    unlock();
    await(&request, NULL);
    ranks.leaving = true;
    if (ranks.number == 0) pthread_join(ranks.answerer, NULL);
}

int ranks_end(int status, ranks_meanwhile meanwhile) {
    static bool ended;
    if (ended) return status;
    ended = true;
    fflush(stdout);
    const int common = agree(status, meanwhile);
    ranks_print();
    if (ranks.count > 1) end_answers();
    MPI_Finalize();
    return common;
}

/// Called at exit, since argp ends the program itself.
static void end_by_exit(int status, void *unused) {
    (void)unused;
    (void)ranks_end(status, NULL);
}

void ranks_begin(int *argc, char ***argv) {
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(argc, argv, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks.count);
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks.number);
    default_threads = find_threads();
    on_exit(end_by_exit, NULL);
    if (ranks.count == 1) return;
    if (provided < MPI_THREAD_SERIALIZED) {
        if (ranks.number == 0) complain("this MPI does not let threads call it in turn (MPI_THREAD_SERIALIZED)");
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILED);
    }
    if (ranks.number > 0) {
        hold_back_output();
    } else if (pthread_create(&ranks.answerer, NULL, answer, NULL) != 0) {
        complain("no memory for a thread");
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILED);
    }
}
