// Film tables of the process: who holds them, and how threads make them together.
#include "pad_tables.h"
#include "pad_table.h"
#include "pad_table_file.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "clock.h"
#include "exhausted.h"
#include "first_error.h"
#include "lock.h"
#include "whirl/internal/film_tables.h"

enum { MAX_TABLES = WHIRL_MAX_FILM_TABLES };

/// A table that is being made. It is guarded, except for the table itself: each thread fills in the values of its own
/// t.
typedef struct making {
    pad_table *table;
    pad_film film;
    bool open;      ///< threads may join: no file was found, and values at nodes remain to be computed
    int next;       ///< first t that no thread has taken
    int done;       ///< number of finished t
    size_t workers; ///< threads that work on the table
    first_error error;
} making;

/// State of a table.
typedef struct slot {
    pad_table_key key;
    size_t holders;
    making *making; ///< NULL: it is not being made
    uint64_t left;  ///< time of its last release, by `clock`
    bool known;     ///< the table was in memory, and `checksum` is that of its coefficients
    uint64_t checksum;
} slot;

static lock guard = LOCK_OPEN;
static slot slots[MAX_TABLES];
static size_t slot_count, idle_count;
static uint64_t clock_of_tables;
static _Atomic(pad_table *) tables[MAX_TABLES];
static pad_table absent; ///< zeros
static _Thread_local whirl_film_tables *watched;

// ---------------------------------------------------------------- numbers

static bool same(const pad_table_key *one, const pad_table_key *other) {
    return one->arc == other->arc && one->ratio == other->ratio && one->law == other->law &&
           one->turbulence == other->turbulence && one->reynolds == other->reynolds && one->lead == other->lead;
}

whirl_status pad_table_number(const pad_table_key *key, double *number) {
    size_t i = 0;
    lock_take(&guard);
    while (i < slot_count && !same(&slots[i].key, key)) i++;
    if (i == slot_count && i < MAX_TABLES) slots[slot_count++].key = *key;
    lock_leave(&guard);
    if (i < MAX_TABLES && watched) watched->bits[i / 64] |= (uint64_t)1 << i % 64;
    *number = (double)i;
    return i < MAX_TABLES
               ? whirl_ok()
               : whirl_fail(WHIRL_BAD_INPUT,
                            "there are more than %d different pads, by arc, length over diameter and Reynolds number",
                            MAX_TABLES);
}

pad_table_key pad_table_key_of(double number) {
    lock_take(&guard);
    const pad_table_key key = slots[(size_t)number].key;
    lock_leave(&guard);
    return key;
}

const pad_table *pad_table_of(double number) {
    const pad_table *table = atomic_load_explicit(&tables[(size_t)number], memory_order_acquire);
    return table ? table : &absent;
}

// ---------------------------------------------------------------- sets

void whirl_film_tables_watch(whirl_film_tables *tables_of_thread) {
    watched = tables_of_thread;
}

static bool set_has(const whirl_film_tables *set, size_t i) {
    return set->bits[i / 64] >> i % 64 & 1;
}

size_t whirl_film_tables_count(const whirl_film_tables *set) {
    size_t count = 0;
    for (size_t i = 0; i < MAX_TABLES; i++) count += set_has(set, i);
    return count;
}

size_t whirl_film_tables_missing(const whirl_film_tables *set) {
    size_t missing = 0;
    lock_take(&guard);
    for (size_t i = 0; i < slot_count; i++)
        missing += set_has(set, i) && !atomic_load(&tables[i]) && !pad_table_file_is_there(&slots[i].key);
    lock_leave(&guard);
    return missing;
}

static int compare_checksums(const void *one, const void *other) {
    const uint64_t a = *(const uint64_t *)one, b = *(const uint64_t *)other;
    return a < b ? -1 : a > b;
}

void whirl_film_tables_text(const whirl_film_tables *set, char text[WHIRL_FILM_TABLES_TEXT]) {
    uint64_t sums[MAX_TABLES] = {0}, all = 0;
    size_t count = 0, different = 0;
    lock_take(&guard);
    for (size_t i = 0; i < slot_count; i++)
        if (set_has(set, i) && slots[i].known) sums[count++] = slots[i].checksum;
    lock_leave(&guard);
    // Sort the checksums, so that the text does not depend on the order in which a process uses its tables.
    qsort(sums, count, sizeof *sums, compare_checksums);
    for (size_t i = 0; i < count; i++) {
        if (i > 0 && sums[i] == sums[i - 1]) continue; // pads that differ only by their pivots share a file
        all = different++ == 0 ? sums[i] : (all ^ sums[i]) * 1099511628211u;
    }
    text[0] = '\0';
    if (different > 0)
        snprintf(text, WHIRL_FILM_TABLES_TEXT, "%zu, checksum %016llx", different, (unsigned long long)all);
}

// ---------------------------------------------------------------- memory

/// Frees the table that has been unused for longest. Requires the guard.
static bool free_oldest(void) {
    size_t oldest = slot_count;
    for (size_t i = 0; i < slot_count; i++)
        if (slots[i].holders == 0 && atomic_load(&tables[i]) &&
            (oldest == slot_count || slots[i].left < slots[oldest].left))
            oldest = i;
    if (oldest == slot_count) return false;
    free(atomic_exchange(&tables[oldest], NULL));
    idle_count--;
    return true;
}

/// Returns a table of zeros. Frees other tables if memory is short. Requires the guard.
static pad_table *take_memory(void) {
    const int before = exhausted_watch();
    pad_table *table = pad_table_empty();
    while (!table && free_oldest()) table = pad_table_empty();
    errno = table ? before : ENOMEM;
    return table;
}

// ---------------------------------------------------------------- making

static making *begin_making(const pad_table_key *key) {
    making *own = calloc(1, sizeof *own);
    pad_table *table = own ? take_memory() : NULL;
    if (!table) {
        free(own);
        return NULL;
    }
    own->table = table;
    own->film = pad_table_film(key);
    return own;
}

/// Computes the values for one t after the other, until no t is left to begin. Requires the guard, and releases it
/// meanwhile.
static void fill_together(making *with, const whirl_stop *stop) {
    pad_workspace *work = NULL;
    whirl_status status = pad_workspace_new(with->film.around, with->film.along, &work);
    while (with->next < PAD_T_NODES && status.code == WHIRL_OK && with->error.code == WHIRL_OK &&
           !whirl_stop_is_set(stop)) {
        const int t = with->next++;
        lock_leave(&guard);
        status = pad_table_fill(with->table, &with->film, work, t);
        lock_take(&guard);
        with->done++;
    }
    first_error_note(&with->error, &status);
    pad_workspace_free(work);
}

/// Searches the table's file. Requires the guard, and releases it meanwhile.
static void look_for_file(making *with, const pad_table_key *key, bool *found) {
    lock_leave(&guard);
    const whirl_status status = pad_table_file_read(key, with->table, found);
    lock_take(&guard);
    if (status.code == WHIRL_NO_MEMORY) first_error_note(&with->error, &status);
    with->open = !*found;
}

static bool is_finite(const pad_table *table) {
    size_t i = 0;
    while (i < PAD_COEFFICIENTS && isfinite(table->coefficients[i])) i++;
    return i == PAD_COEFFICIENTS;
}

/// Finishes a table from its values at nodes. For films that cannot be solved it contains NaN.
static void pad_tables_finish(making *with, const pad_table_key *key) {
    const bool failed = with->error.code != WHIRL_OK, from_file = with->next == 0;
    for (size_t i = 0; failed && i < PAD_COEFFICIENTS; i++) with->table->coefficients[i] = NAN;
    if (!failed && !from_file) pad_table_splines(with->table);
    if (!failed && !from_file && is_finite(with->table)) pad_table_file_write(key, with->table);
    pad_table_rows(with->table);
    pad_table_lean(with->table, key->lead);
}

/// Ends a thread's work on a table. The last thread finishes or discards the table. Requires the guard, and releases it
/// meanwhile.
static whirl_status end_making(size_t i, bool found) {
    making *with = slots[i].making;
    const bool done = found || with->done == PAD_T_NODES, failed = with->error.code != WHIRL_OK;
    const whirl_status status = with->error.code == WHIRL_NO_MEMORY ? first_error_status(&with->error) : whirl_ok();
    // Only the last thread continues.
    if (--with->workers > 0) return status;
    if (status.code != WHIRL_OK || !(done || failed)) {
        slots[i].making = NULL;
        free(with->table);
        free(with);
        return status;
    }
    // Interpolate outside the guard, since this takes a while.
    with->open = false;
    lock_leave(&guard);
    pad_tables_finish(with, &slots[i].key);
    const uint64_t checksum = pad_table_checksum(with->table);
    lock_take(&guard);
    // Publish the table.
    slots[i].known = true;
    slots[i].checksum = checksum;
    slots[i].making = NULL;
    atomic_store_explicit(&tables[i], with->table, memory_order_release);
    free(with);
    return status;
}

/// Makes a table, or helps other threads to make it. Requires the guard, and releases it meanwhile.
static whirl_status tables_make(size_t i, const whirl_stop *stop) {
    making *with = slots[i].making;
    bool found = false;
    if (!with) {
        with = slots[i].making = begin_making(&slots[i].key);
        if (!with) return whirl_fail(WHIRL_NO_MEMORY, "no memory for the table of a pad's film");
        with->workers = 1;
        look_for_file(with, &slots[i].key, &found);
    } else if (with->open && with->next < PAD_T_NODES) {
        with->workers++;
    } else { // another thread is finishing it
        lock_leave(&guard);
        clock_rest();
        lock_take(&guard);
        return whirl_ok();
    }
    if (!found) fill_together(with, stop);
    return end_making(i, found);
}

whirl_status pad_table_hold(double number, const whirl_stop *stop) {
    const size_t i = (size_t)number;
    whirl_status status = whirl_ok();
    lock_take(&guard);
    idle_count -= slots[i].holders == 0 && atomic_load(&tables[i]);
    slots[i].holders++;
    while (!atomic_load(&tables[i]) && status.code == WHIRL_OK) {
        status = whirl_stop_is_set(stop) ? whirl_fail(WHIRL_STOPPED, "stopped while tables of films were made")
                                         : tables_make(i, stop);
    }
    lock_leave(&guard);
    if (status.code != WHIRL_OK) pad_table_release(number);
    return status;
}

void pad_table_release(double number) {
    const size_t i = (size_t)number;
    lock_take(&guard);
    slots[i].left = ++clock_of_tables;
    if (--slots[i].holders == 0 && atomic_load(&tables[i])) idle_count++;
    while (idle_count > MAX_IDLE_PAD_TABLES && free_oldest()) continue;
    lock_leave(&guard);
}
