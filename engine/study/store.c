#include "study/store.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <sqlite3.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/stopwatch.h"
#include "base/digest.h"
#include "base/memory.h"
#include "base/text.h"

enum {
    FORMAT = 2,
    FORMAT_WITHOUT_NOTES = 1,
    APPLICATION = 0x436c6561, /* "Clea": the application id that SQLite keeps at byte 68 */
    PATIENCE = 2000,          /* ms, for another program that reads the file */
    LAST_PATIENCE = 60000,    /* ms, the same for the last commit */
    REASON = 200,             /* size of a reason, characters */
    WRITER_BYTE = 0x3fffffff, /* that a writer locks, just before those that SQLite locks */
};

/* Numbers are in this machine's byte order: a double is stored as in memory. A trial's digest covers its row. */
static const char tables[] =
    "CREATE TABLE study (id INTEGER PRIMARY KEY, digest INTEGER NOT NULL UNIQUE, trials INTEGER NOT NULL);"
    "CREATE TABLE trial (study INTEGER NOT NULL, trial INTEGER NOT NULL, observed BLOB NOT NULL, series BLOB NOT NULL,"
    " fault TEXT, digest INTEGER NOT NULL, note TEXT, PRIMARY KEY (study, trial)) WITHOUT ROWID;";

struct Store {
    sqlite3 *database;
    sqlite3_stmt *insert;
    char *path;
    uint64_t digest;     /* of the study */
    int64_t study;       /* its row */
    int writer;          /* file descriptor that holds the lock of the writer of a file with readers, or -1 */
    double committed;    /* s, clock time of the last commit */
    bool open;           /* a transaction is open */
    char reason[REASON]; /* reason of the first failed write, or "" */

    char **merged; /* (merged_count) paths of the merged files */
    size_t merged_count, merged_capacity;
    uint32_t *origins; /* (trials) which of them a trial is from, from 1; 0: from this file; NULL: nothing was merged */
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

/* Checks that a file with tables is one of a store. */
static bool check_format(Store *store, Fault *fault) {
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

/* Returns the number of tables, or -1 after an error. */
static int64_t count_tables(Store *store, Fault *fault) {
    int64_t known = ask(store, "SELECT count(*) FROM sqlite_master");
    if (known < 0)
        add_database_fault(store, fault);
    return known;
}

/* Gives a file of an earlier version the column that it lacks. */
static bool add_notes(Store *store) {
    char statement[100];
    bool lacks =
        ask(store, "PRAGMA application_id") == APPLICATION && ask(store, "PRAGMA user_version") == FORMAT_WITHOUT_NOTES;
    snprintf(statement, sizeof statement, "ALTER TABLE trial ADD COLUMN note TEXT; PRAGMA user_version = %d", FORMAT);
    return !lacks || run_statement(store, statement);
}

/* Creates the tables in a file without tables. */
static bool prepare_tables(Store *store, Fault *fault) {
    int64_t known = count_tables(store, fault);
    if (known > 0 && !add_notes(store)) {
        add_database_fault(store, fault);
        return false;
    }
    if (known)
        return known > 0 && check_format(store, fault);
    char statement[100];
    snprintf(statement, sizeof statement, "PRAGMA application_id = %d; PRAGMA user_version = %d", APPLICATION, FORMAT);
    if (run_statement(store, statement) && run_statement(store, tables))
        return true;
    add_database_fault(store, fault);
    return false;
}

/* Reading -------------------------------------------------------------------------------------------------------- */

/* Series are counted in numbers, not in bytes. */
static uint64_t row_digest(const void *observed, size_t observables, const void *series, size_t series_count,
                           const char *reason, const char *note, int64_t index) {
    uint64_t digest = digest_bytes(DIGEST_START, observed, observables * sizeof(double));
    digest = digest_bytes(digest, series, series_count * sizeof(double));
    digest = digest_text(digest, reason ? reason : "");
    return digest_mix(note ? digest_text(digest, note) : digest, (double)index);
}

static uint64_t trial_digest(const Trial *trial, size_t observables, size_t index) {
    return row_digest(trial->observed, observables, trial->series, trial->series_count, trial->fault, trial->note,
                      (int64_t)index);
}

static const char rows[] = "SELECT trial, observed, series, fault, digest, note FROM trial WHERE study = ?";

static const char *text_at(sqlite3_stmt *row, int column) {
    return (const char *)sqlite3_column_text(row, column);
}

/* Returns the trial of a row, or SIZE_MAX if the row is not as it was written. */
static size_t check_row(sqlite3_stmt *row, const Study *study) {
    int64_t index = sqlite3_column_int64(row, 0);
    size_t observables = study->experiment->observable_count, bytes = (size_t)sqlite3_column_bytes(row, 2);
    if (index < 0 || index >= (int64_t)study->trial_count ||
        (size_t)sqlite3_column_bytes(row, 1) != observables * sizeof(double) || bytes % sizeof(double))
        return SIZE_MAX;
    uint64_t digest = row_digest(sqlite3_column_blob(row, 1), observables, sqlite3_column_blob(row, 2),
                                 bytes / sizeof(double), text_at(row, 3), text_at(row, 5), index);
    return (uint64_t)sqlite3_column_int64(row, 4) == digest ? (size_t)index : SIZE_MAX;
}

/* Reads a sound row into its trial. False: there is no room for it. */
static bool take_row(sqlite3_stmt *row, Study *study, size_t index, double *observed) {
    if (study->experiment->observable_count)
        memcpy(observed, sqlite3_column_blob(row, 1), study->experiment->observable_count * sizeof(double));
    Trial result = {.observed = observed, .series_count = (size_t)sqlite3_column_bytes(row, 2) / sizeof(double)};
    if (result.series_count) {
        result.series = memory_zeroed(result.series_count, sizeof(double));
        memcpy(result.series, sqlite3_column_blob(row, 2), result.series_count * sizeof(double));
    }
    const char *fault = text_at(row, 3), *note = text_at(row, 5);
    result.fault = fault ? text_copy(fault) : NULL;
    result.note = note ? text_copy(note) : NULL;
    return study_take(study, index, &result);
}

static double *observed_room(const Study *study) {
    return memory_zeroed(study->experiment->observable_count, sizeof(double));
}

void store_add_full(const Study *study, Fault *fault) {
    fault_add(fault, "%s has no room for the results of %zu runs; set TMPDIR to a directory with more room",
              study->folder, study_room(study));
}

static bool read_trials(Store *store, Study *study, StoreFound *found, Fault *fault) {
    sqlite3_stmt *select = NULL;
    int code = sqlite3_prepare_v2(store->database, rows, -1, &select, NULL);
    bool sound = true;
    sqlite3_bind_int64(select, 1, store->study);
    double *observed = observed_room(study);
    while (code == SQLITE_OK && sound && !study->full && sqlite3_step(select) == SQLITE_ROW) {
        size_t index = check_row(select, study);
        if (index < SIZE_MAX && !study_has(study, index)) /* the file was one of another shard */
            continue;
        sound = index < SIZE_MAX && !study_nth(study, index)->done; /* a damaged file can have a row twice */
        if (sound)
            take_row(select, study, index, observed);
        found->done++;
    }
    memory_free(observed);
    if (code == SQLITE_OK && !sound)
        fault_add(fault, "%s is damaged (a row was changed); move it or choose another --out", store->path);
    sqlite3_reset(select);
    if (sound && sqlite3_errcode(store->database) != SQLITE_OK) {
        add_database_fault(store, fault);
        sound = false;
    }
    sqlite3_finalize(select);
    if (sound && study->full)
        store_add_full(study, fault);
    sound &= !study->full;
    if (!sound)
        study_forget(study);
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

/* Makes this program the only one that writes a file with readers. SQLite would let another one in between two
 * commits. */
static bool become_writer(Store *store, Fault *fault) {
    store->writer = open(store->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (store->writer < 0) {
        fault_add(fault, "%s cannot be written: %s", store->path, strerror(errno));
        return false;
    }
    struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = WRITER_BYTE, .l_len = 1};
    if (fcntl(store->writer, F_OFD_SETLK, &lock) == 0 || (errno != EAGAIN && errno != EACCES))
        return true; /* there are file systems without locks */
    fault_add(fault, "%s is in use by another program: wait until it has ended, or choose another --out", store->path);
    return false;
}

static bool open_database(Store *store, StoreUse use, Study *study, uint64_t digest, StoreFound *found, Fault *fault) {
    if (use == STORE_WITH_READERS && !become_writer(store, fault))
        return false;
    if (sqlite3_open(store->path, &store->database) != SQLITE_OK) {
        add_database_fault(store, fault);
        return false;
    }
    sqlite3_extended_result_codes(store->database, 0);
    sqlite3_busy_timeout(store->database, PATIENCE);
    if (use == STORE_ALONE)
        run_statement(store, "PRAGMA locking_mode = EXCLUSIVE");
    if (!run_statement(store, "BEGIN IMMEDIATE")) {
        add_database_fault(store, fault);
        return false;
    }
    store->open = true;
    if (!prepare_tables(store, fault) || !find_study(store, study, digest, found, fault) ||
        !read_trials(store, study, found, fault))
        return false;
    static const char insert[] = "INSERT OR REPLACE INTO trial VALUES (?, ?, ?, ?, ?, ?, ?)";
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
    if (store->writer >= 0)
        close(store->writer); /* after SQLite, whose own locks end with the first descriptor that is closed */
    for (size_t m = 0; m < store->merged_count; m++)
        memory_free(store->merged[m]);
    memory_free(store->merged);
    memory_free(store->origins);
    memory_free(store->path);
    memory_free(store);
}

Store *store_open(const char *path, StoreUse use, Study *study, uint64_t digest, StoreFound *found, Fault *fault) {
    Store *store = memory_zeroed(1, sizeof *store);
    store->path = text_copy(path);
    store->writer = -1;
    store->digest = digest;
    *found = (StoreFound){0};
    if (!open_database(store, use, study, digest, found, fault)) {
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
    const Trial *trial = study_nth(study, index);
    size_t observables = study->experiment->observable_count;
    sqlite3_stmt *insert = store->insert;
    sqlite3_bind_int64(insert, 1, store->study);
    sqlite3_bind_int64(insert, 2, (int64_t)index);
    sqlite3_bind_blob64(insert, 3, trial->observed, observables * sizeof(double), SQLITE_STATIC);
    sqlite3_bind_blob64(insert, 4, trial->series_count ? (const void *)trial->series : "",
                        trial->series_count * sizeof(double), SQLITE_STATIC);
    sqlite3_bind_text(insert, 5, trial->fault, -1, SQLITE_STATIC);
    sqlite3_bind_int64(insert, 6, (int64_t)trial_digest(trial, observables, index));
    sqlite3_bind_text(insert, 7, trial->note, -1, SQLITE_STATIC);
    bool good = sqlite3_step(insert) == SQLITE_DONE;
    return sqlite3_reset(insert) == SQLITE_OK && good;
}

/* Commits, unless others read the file for longer than we wait: then the transaction stays open for a later commit. */
static bool commit(Store *store) {
    bool good = run_statement(store, "COMMIT");
    store->open = !good && sqlite3_errcode(store->database) == SQLITE_BUSY;
    return good || store->open;
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
    sqlite3_busy_timeout(store->database, LAST_PATIENCE);
    if (store->open && !*store->reason && (!commit(store) || store->open))
        note_failure(store);
    bool good = !*store->reason;
    if (!good)
        fault_add(fault, "%s cannot be written: %s; earlier results are kept", store->path, store->reason);
    free_store(store);
    return good;
}

void store_abandon(Store *store) {
    free_store(store);
}

/* Merging -------------------------------------------------------------------------------------------------------- */

/* Adds why the file of a shard cannot be read: the system knows it better than SQLite. */
static void add_unreadable(const Store *other, Fault *fault) {
    struct stat status;
    int file = open(other->path, O_RDONLY | O_CLOEXEC), error = file < 0 ? errno : 0;
    if (file >= 0 && fstat(file, &status) == 0 && S_ISDIR(status.st_mode))
        error = EISDIR;
    if (file >= 0)
        close(file);
    fault_add(fault, "%s cannot be read: %s", other->path, error ? strerror(error) : sqlite3_errmsg(other->database));
}

/* Opens a file of a shard to read this study, which it must have, in one transaction. */
static bool open_other(Store *other, const char *path, uint64_t digest, Fault *fault) {
    *other = (Store){.path = text_copy(path), .writer = -1};
    /* a file whose program was killed within a commit is first put back to the commit before, by SQLite */
    if (sqlite3_open_v2(path, &other->database, SQLITE_OPEN_READWRITE, NULL) != SQLITE_OK) {
        add_unreadable(other, fault);
        return false;
    }
    sqlite3_busy_timeout(other->database, LAST_PATIENCE);
    other->open = run_statement(other, "PRAGMA query_only = 1; BEGIN");
    int64_t known = other->open ? count_tables(other, fault) : -1;
    if (!other->open)
        add_database_fault(other, fault);
    if (known == 0)
        fault_add(fault, "%s is empty", path);
    if (known <= 0 || !check_format(other, fault))
        return false;
    char statement[100];
    snprintf(statement, sizeof statement, "SELECT id FROM study WHERE digest = %lld", (long long)digest);
    other->study = ask(other, statement);
    if (other->study < 0)
        fault_add(fault,
                  "%s is of another study: its file, settings, range or program differ; give all shards the same "
                  "command, and install the same clearance on all machines",
                  path);
    return other->study >= 0;
}

static void close_other(Store *other) {
    if (other->open)
        run_statement(other, "ROLLBACK");
    sqlite3_close(other->database);
    memory_free(other->path);
}

/* Adds which two results a trial has. */
static void tell_conflict(const Store *store, const Study *study, size_t index, sqlite3_stmt *row, const char *path,
                          Fault *fault) {
    const Experiment *experiment = study->experiment;
    const Trial *trial = study_nth(study, index);
    size_t origin = store->origins[index];
    Text text = {0};
    text_format(&text, "run %zu (pass %s, seed %llu", index + 1,
                study_pass_name(study->passes[study_pass_of(study, index)]), (unsigned long long)trial->seed);
    for (size_t n = 0; n < study->name_count; n++)
        text_format(&text, ", %s %.9g", study->names[n], trial->at[n]);
    text_add(&text, ") has two results");
    for (size_t o = 0; o < experiment->observable_count; o++) {
        double other;
        memcpy(&other, (const char *)sqlite3_column_blob(row, 1) + o * sizeof other, sizeof other);
        if (memcmp(&other, &trial->observed[o], sizeof other) == 0)
            continue;
        text_format(&text, ": %s is %.17g in %s, %.17g in %s", experiment->observables[o].name, trial->observed[o],
                    origin ? store->merged[origin - 1] : store->path, other, path);
        break;
    }
    fault_add(fault, "%s; a machine computes wrongly, or a file was changed: remove the wrong file and merge again",
              text.text);
    memory_free(text.text);
}

/* Goes through the rows of the other file: first only to see that all are sound, then to take them. */
static StoreMerge read_other(Store *store, Study *study, Store *other, bool take, Fault *fault) {
    size_t observables = study->experiment->observable_count;
    sqlite3_stmt *select = NULL;
    StoreMerge end = STORE_MERGED;
    int code = sqlite3_prepare_v2(other->database, rows, -1, &select, NULL);
    sqlite3_bind_int64(select, 1, other->study);
    bool good = code == SQLITE_OK, sound = true;
    double *observed = observed_room(study);
    while (good && sound && !study->full && sqlite3_step(select) == SQLITE_ROW) {
        size_t index = check_row(select, study);
        sound = index < SIZE_MAX;
        if (!take || !sound)
            continue;
        const Trial *trial = study_nth(study, index);
        if (!trial->done) {
            if (!take_row(select, study, index, observed))
                break;
            store->origins[index] = (uint32_t)store->merged_count;
            if (!*store->reason && !write_trial(store, study, index))
                note_failure(store);
        } else if (trial_digest(trial, observables, index) != (uint64_t)sqlite3_column_int64(select, 4)) {
            tell_conflict(store, study, index, select, other->path, fault);
            end = STORE_CONFLICT;
        }
    }
    if (good)
        sqlite3_reset(select);
    if (good && !sound)
        fault_add(fault, "%s is damaged (a row was changed)", other->path);
    else if (sqlite3_errcode(other->database) != SQLITE_OK) {
        add_database_fault(other, fault);
        sound = false;
    }
    sqlite3_finalize(select);
    memory_free(observed);
    if (good && sound && study->full)
        store_add_full(study, fault);
    return !good || !sound ? STORE_REFUSED : study->full ? STORE_FULL : end;
}

StoreMerge store_merge(Store *store, Study *study, const char *path, Fault *fault) {
    Store other;
    StoreMerge end = STORE_REFUSED;
    if (open_other(&other, path, store->digest, fault)) {
        if (!store->origins)
            store->origins = memory_zeroed(study->trial_count, sizeof *store->origins);
        store->merged =
            memory_reserve(store->merged, &store->merged_capacity, store->merged_count + 1, sizeof *store->merged);
        store->merged[store->merged_count++] = text_copy(path);
        end = read_other(store, study, &other, false, fault);
        if (end == STORE_MERGED)
            end = read_other(store, study, &other, true, fault);
    }
    close_other(&other);
    return end;
}
