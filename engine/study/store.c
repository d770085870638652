#include "study/store.h"

#include <math.h>
#include <sqlite3.h>
#include <stdio.h>
#include <string.h>

#include "base/stopwatch.h"
#include "base/digest.h"
#include "base/memory.h"
#include "base/text.h"

enum {
    FORMAT = 1,
    APPLICATION = 0x436c6561, /* "Clea": the application id that SQLite keeps at byte 68 */
    PATIENCE = 2000,          /* ms, for another program that reads the file */
    REASON = 200,             /* size of a reason, characters */
};

/* Numbers are in this machine's byte order: a double is stored as in memory. A trial's digest covers its row. */
static const char tables[] =
    "CREATE TABLE study (id INTEGER PRIMARY KEY, digest INTEGER NOT NULL UNIQUE, trials INTEGER NOT NULL);"
    "CREATE TABLE trial (study INTEGER NOT NULL, trial INTEGER NOT NULL, observed BLOB NOT NULL, series BLOB NOT NULL,"
    " fault TEXT, digest INTEGER NOT NULL, PRIMARY KEY (study, trial)) WITHOUT ROWID;";

struct Store {
    sqlite3 *database;
    sqlite3_stmt *insert;
    char *path;
    int64_t study;
    double committed;    /* s, clock time of the last commit */
    bool open;           /* a transaction is open */
    char reason[REASON]; /* reason of the first failed write, or "" */
};

static bool run_statement(Store *store, const char *statement) {
    return sqlite3_exec(store->database, statement, NULL, NULL, NULL) == SQLITE_OK;
}

/* Returns the number that a statement yields, or -1. */
static int64_t ask(Store *store, const char *statement) {
    sqlite3_stmt *prepared = NULL;
    int64_t number = -1;
    if (sqlite3_prepare_v2(store->database, statement, -1, &prepared, NULL) == SQLITE_OK &&
        sqlite3_step(prepared) == SQLITE_ROW)
        number = sqlite3_column_int64(prepared, 0);
    sqlite3_finalize(prepared);
    return number;
}

/* Adds the reason why the database is unusable. */
static void add_database_fault(const Store *store, Fault *fault) {
    int code = sqlite3_errcode(store->database);
    const char *path = store->path;
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
        fault_add(fault, "%s is in use by another program: wait until it has ended, or choose another --out", path);
    else if (code == SQLITE_NOTADB)
        fault_add(fault, "%s is not a study database; move it or choose another --out", path);
    else if (code == SQLITE_CANTOPEN || code == SQLITE_READONLY || code == SQLITE_PERM || code == SQLITE_FULL ||
             code == SQLITE_IOERR)
        fault_add(fault, "%s cannot be written: %s", path, sqlite3_errmsg(store->database));
    else
        fault_add(fault, "%s is damaged (%s); move it or choose another --out", path, sqlite3_errmsg(store->database));
}

/* Creates the tables in a file without tables. */
static bool prepare_tables(Store *store, Fault *fault) {
    int64_t known = ask(store, "SELECT count(*) FROM sqlite_master");
    if (known < 0) {
        add_database_fault(store, fault);
        return false;
    }
    char statement[100];
    if (!known) {
        snprintf(statement, sizeof statement, "PRAGMA application_id = %d; PRAGMA user_version = %d", APPLICATION,
                 FORMAT);
        if (run_statement(store, statement) && run_statement(store, tables))
            return true;
        add_database_fault(store, fault);
        return false;
    }
    if (ask(store, "PRAGMA application_id") != APPLICATION) {
        fault_add(fault, "%s is another program's database; move it or choose another --out", store->path);
        return false;
    }
    int64_t version = ask(store, "PRAGMA user_version");
    if (version != FORMAT)
        fault_add(fault, "%s has format %lld, must be %d; move it or choose another --out", store->path,
                  (long long)version, FORMAT);
    return version == FORMAT;
}

/* Reading -------------------------------------------------------------------------------------------------------- */

static uint64_t row_digest(const Trial *trial, size_t observables, int64_t index) {
    uint64_t digest = digest_bytes(DIGEST_START, trial->observed, observables * sizeof *trial->observed);
    digest = digest_bytes(digest, trial->series, trial->series_count * sizeof *trial->series);
    return digest_mix(digest_text(digest, trial->fault ? trial->fault : ""), (double)index);
}

/* Reads a row into its trial. Returns false if the row is not as it was written, or its trial was read before, since a
 * damaged file can have a row twice. */
static bool take_row(sqlite3_stmt *row, Study *study) {
    int64_t index = sqlite3_column_int64(row, 0);
    size_t observables = study->experiment->observable_count;
    if (index < 0 || index >= (int64_t)study->trial_count || study->trials[index].done ||
        (size_t)sqlite3_column_bytes(row, 1) != observables * sizeof(double) ||
        (size_t)sqlite3_column_bytes(row, 2) % sizeof(double))
        return false;
    Trial *trial = &study->trials[index];
    if (observables)
        memcpy(trial->observed, sqlite3_column_blob(row, 1), observables * sizeof(double));
    trial->series_count = (size_t)sqlite3_column_bytes(row, 2) / sizeof(double);
    if (trial->series_count) {
        trial->series = memory_zeroed(trial->series_count, sizeof(double));
        memcpy(trial->series, sqlite3_column_blob(row, 2), trial->series_count * sizeof(double));
    }
    const char *text = (const char *)sqlite3_column_text(row, 3);
    trial->fault = text ? text_copy(text) : NULL;
    trial->done = (uint64_t)sqlite3_column_int64(row, 4) == row_digest(trial, observables, index);
    return trial->done;
}

/* Clears the trials after a failed reading. */
static void forget_trials(Study *study) {
    for (size_t t = 0; t < study->trial_count; t++) {
        Trial *trial = &study->trials[t];
        trial_clear(trial);
        trial->done = false;
        for (size_t o = 0; o < study->experiment->observable_count; o++)
            trial->observed[o] = (double)NAN;
    }
}

static bool read_trials(Store *store, Study *study, StoreFound *found, Fault *fault) {
    sqlite3_stmt *select = NULL;
    int code = sqlite3_prepare_v2(
        store->database, "SELECT trial, observed, series, fault, digest FROM trial WHERE study = ?", -1, &select, NULL);
    bool sound = true;
    sqlite3_bind_int64(select, 1, store->study);
    while (code == SQLITE_OK && sound && sqlite3_step(select) == SQLITE_ROW) {
        sound = take_row(select, study);
        found->done++;
    }
    if (code == SQLITE_OK && !sound)
        fault_add(fault, "%s is damaged (a row was changed); move it or choose another --out", store->path);
    sqlite3_reset(select);
    if (sound && sqlite3_errcode(store->database) != SQLITE_OK) {
        add_database_fault(store, fault);
        sound = false;
    }
    sqlite3_finalize(select);
    if (!sound)
        forget_trials(study);
    return sound;
}

/* Finds the row of this study, adding one if needed. */
static bool find_study(Store *store, const Study *study, uint64_t digest, StoreFound *found, Fault *fault) {
    char statement[160];
    snprintf(statement, sizeof statement, "SELECT count(*) FROM study WHERE digest <> %lld", (long long)digest);
    int64_t others = ask(store, statement);
    snprintf(statement, sizeof statement, "INSERT OR IGNORE INTO study (digest, trials) VALUES (%lld, %zu)",
             (long long)digest, study->trial_count);
    bool good = others >= 0 && run_statement(store, statement);
    snprintf(statement, sizeof statement, "SELECT id FROM study WHERE digest = %lld", (long long)digest);
    store->study = good ? ask(store, statement) : -1;
    if (store->study < 0)
        add_database_fault(store, fault);
    found->others = others > 0 ? (size_t)others : 0;
    return store->study >= 0;
}

static bool open_database(Store *store, Study *study, uint64_t digest, StoreFound *found, Fault *fault) {
    if (sqlite3_open(store->path, &store->database) != SQLITE_OK) {
        add_database_fault(store, fault);
        return false;
    }
    sqlite3_extended_result_codes(store->database, 0);
    sqlite3_busy_timeout(store->database, PATIENCE);
    /* one program at a time, so that another cannot change the file meanwhile */
    if (!run_statement(store, "PRAGMA locking_mode = EXCLUSIVE; BEGIN IMMEDIATE")) {
        add_database_fault(store, fault);
        return false;
    }
    store->open = true;
    if (!prepare_tables(store, fault) || !find_study(store, study, digest, found, fault) ||
        !read_trials(store, study, found, fault))
        return false;
    static const char insert[] = "INSERT OR REPLACE INTO trial VALUES (?, ?, ?, ?, ?, ?)";
    if (sqlite3_prepare_v2(store->database, insert, -1, &store->insert, NULL) != SQLITE_OK) {
        add_database_fault(store, fault);
        return false;
    }
    return true;
}

static void free_store(Store *store) {
    sqlite3_finalize(store->insert);
    if (store->open)
        run_statement(store, "ROLLBACK");
    sqlite3_close(store->database);
    memory_free(store->path);
    memory_free(store);
}

Store *store_open(const char *path, Study *study, uint64_t digest, StoreFound *found, Fault *fault) {
    Store *store = memory_zeroed(1, sizeof *store);
    store->path = text_copy(path);
    *found = (StoreFound){0};
    if (!open_database(store, study, digest, found, fault)) {
        free_store(store);
        return NULL;
    }
    store->committed = stopwatch_now();
    return store;
}

/* Writing -------------------------------------------------------------------------------------------------------- */

/* Records the first failure; the study itself continues. */
static void note_failure(Store *store) {
    if (!*store->reason)
        snprintf(store->reason, sizeof store->reason, "%s", sqlite3_errmsg(store->database));
}

static bool write_trial(Store *store, const Study *study, size_t index) {
    const Trial *trial = &study->trials[index];
    size_t observables = study->experiment->observable_count;
    sqlite3_stmt *insert = store->insert;
    sqlite3_bind_int64(insert, 1, store->study);
    sqlite3_bind_int64(insert, 2, (int64_t)index);
    sqlite3_bind_blob64(insert, 3, trial->observed, observables * sizeof(double), SQLITE_STATIC);
    sqlite3_bind_blob64(insert, 4, trial->series_count ? (const void *)trial->series : "",
                        trial->series_count * sizeof(double), SQLITE_STATIC);
    sqlite3_bind_text(insert, 5, trial->fault, -1, SQLITE_STATIC);
    sqlite3_bind_int64(insert, 6, (int64_t)row_digest(trial, observables, (int64_t)index));
    bool good = sqlite3_step(insert) == SQLITE_DONE;
    return sqlite3_reset(insert) == SQLITE_OK && good;
}

static bool commit(Store *store) {
    store->open = false;
    return run_statement(store, "COMMIT");
}

void store_write(void *keeper, const Study *study, const size_t *done, size_t count) {
    Store *store = keeper;
    if (*store->reason)
        return;
    if (!store->open && !(store->open = run_statement(store, "BEGIN IMMEDIATE"))) {
        note_failure(store);
        return;
    }
    for (size_t i = 0; i < count; i++)
        if (!write_trial(store, study, done[i])) {
            note_failure(store);
            return;
        }
    double now = stopwatch_now();
    if (now - store->committed < 1)
        return;
    if (!commit(store))
        note_failure(store);
    store->committed = now;
}

void store_forget(Store *store) {
    char statement[120];
    snprintf(statement, sizeof statement, "DELETE FROM trial WHERE study = %lld; DELETE FROM study WHERE id = %lld",
             (long long)store->study, (long long)store->study);
    if (!run_statement(store, statement))
        note_failure(store);
}

bool store_close(Store *store, Fault *fault) {
    if (store->open && !*store->reason && !commit(store))
        note_failure(store);
    bool good = !*store->reason;
    if (!good)
        fault_add(fault, "%s cannot be written: %s; earlier results are kept", store->path, store->reason);
    free_store(store);
    return good;
}
