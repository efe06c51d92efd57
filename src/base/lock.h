/// A lock for data that all threads of a process share.
#ifndef BASE_LOCK_H
#define BASE_LOCK_H

#include <pthread.h>

typedef pthread_mutex_t lock;

/// Initial value of a static lock.
#define LOCK_OPEN PTHREAD_MUTEX_INITIALIZER

static inline void lock_take(lock *taken) {
    pthread_mutex_lock(taken);
}

static inline void lock_leave(lock *left) {
    pthread_mutex_unlock(left);
}

#endif
