#include "command/study_shards.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "command/answer.h"
#include "command/output.h"

bool study_shards_check(const Options *options, Fault *fault) {
    const StudyRequest *asked = &options->study;
    const char *one = asked->shard.count ? "--shard" : asked->merge ? "--merge" : "--print-shards";
    bool any = asked->shard.count || asked->merge || asked->print_shards;
    if ((asked->shard.count > 0) + asked->merge + (asked->print_shards > 0) > 1)
        fault_add(fault, "clearance: --shard, --merge and --print-shards are three different steps; give one of them");
    else if (any && options->paper)
        fault_add(fault, "clearance: %s has no effect with --paper; leave it out", one);
    else if (any && options->types && !asked->axis_count && asked->runs < 2)
        fault_add(fault, "clearance: %s has no effect with --types without --vary; leave it out", one);
    else if (any && !options->out)
        fault_add(fault, "clearance: %s needs --out DIR, the directory that all shards share", one);
    else if (asked->no_run && !asked->merge)
        fault_add(fault, "clearance: --no-run has no effect without --merge; leave it out");
    else
        return true;
    return false;
}

void study_shards_name(const Options *options, char name[OUTPUT_NAME]) {
    StudyShard shard = options->study.shard;
    int digits = snprintf(name, OUTPUT_NAME, "%zu", shard.count);
    if (shard.count)
        snprintf(name, OUTPUT_NAME, "study-%0*zu-of-%zu.sqlite", digits, shard.number, shard.count);
    else
        snprintf(name, OUTPUT_NAME, "study.sqlite");
}

/* Merging ---------------------------------------------------------------------------------------------------------- */

/* The files of shards in a directory, by name. */
typedef struct ShardFiles {
    char **names; /* (count) */
    size_t count, capacity;
    size_t shards; /* N of study-I-of-N.sqlite, the largest; 0: no file */
} ShardFiles;

static int compare_names(const void *a, const void *b) {
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static int list_files(ShardFiles *files, const char *folder) {
    DIR *directory = opendir(folder);
    if (!directory)
        return errno;
    for (const struct dirent *entry; (entry = readdir(directory));) {
        StudyShard shard;
        char rest;
        /* copies, study-1-of-4 (2).sqlite, are files of shards, too */
        size_t length = strlen(entry->d_name);
        if (sscanf(entry->d_name, "study-%5zu-of-%6zu%c", &shard.number, &shard.count, &rest) != 3 || length < 7 ||
            strcmp(entry->d_name + length - 7, ".sqlite") != 0)
            continue;
        files->names = memory_reserve(files->names, &files->capacity, files->count + 1, sizeof *files->names);
        files->names[files->count++] = text_copy(entry->d_name);
        files->shards = shard.count > files->shards ? shard.count : files->shards;
    }
    closedir(directory);
    if (files->count)
        qsort(files->names, files->count, sizeof *files->names, compare_names);
    return 0;
}

static void clear_files(ShardFiles *files) {
    for (size_t f = 0; f < files->count; f++)
        memory_free(files->names[f]);
    memory_free(files->names);
}

enum { MISSING_NAMED = 20 /* shards that are named in one line */ };

/* Adds which shards lack how many runs. */
static void add_missing(Text *text, const Study *study, size_t shards) {
    size_t *missing = memory_zeroed(shards, sizeof *missing), incomplete = 0, named = 0;
    for (size_t t = 0; t < study->trial_count; t++)
        if (!study_nth(study, t)->done)
            missing[study_shard_of(study, shards, t) - 1]++;
    for (size_t s = 0; s < shards; s++) {
        incomplete += missing[s] > 0;
        if (missing[s] && named < MISSING_NAMED)
            text_format(text, "%s%zu (%zu run%s)", named++ ? ", " : "; missing: of the shards ", s + 1, missing[s],
                        missing[s] == 1 ? "" : "s");
    }
    if (incomplete > named)
        text_format(text, " and %zu more", incomplete - named);
    if (named)
        text_format(text, " of %zu", shards);
    memory_free(missing);
}

static void tell_merged(const Options *options, const Study *study, size_t shards) {
    size_t done = study_done(study);
    Text text = {0};
    text_format(&text, "%zu of %zu runs are there", done, study->trial_count);
    if (done < study->trial_count && shards)
        add_missing(&text, study, shards);
    if (!options->quiet)
        fprintf(stderr, "clearance: %s\n", text.text);
    memory_free(text.text);
}

/* Prints why a file is left out. */
static void tell_refused(Fault *why) {
    for (size_t i = 0; i < why->count; i++)
        fprintf(stderr, "clearance: not merged: %s\n", why->lines[i]);
    fault_clear(why);
}

int study_shards_merge(const Options *options, Study *study, Store *store, Fault *fault) {
    ShardFiles files = {.count = 0};
    int error = list_files(&files, options->out), code = 0;
    if (error)
        fault_add(fault, "%s cannot be read: %s", options->out, strerror(error));
    else if (!files.count && !study_done(study))
        fault_add(fault, "%s has no file study-I-of-N.sqlite to merge; study --print-shards N tells how to make them",
                  options->out);
    if (fault->total)
        code = EXIT_WRONG_INPUT;
    for (size_t f = 0; f < files.count && !code; f++) {
        char path[OUTPUT_PATH];
        Fault why = {0};
        snprintf(path, sizeof path, "%s/%s", options->out, files.names[f]);
        switch (store_merge(store, study, path, &why)) {
        case STORE_MERGED:
            break;
        case STORE_REFUSED:
            tell_refused(&why);
            break;
        case STORE_CONFLICT:
            code = EXIT_OUR_FAULT;
            *fault = why;
            break;
        case STORE_FULL:
            code = EXIT_WRONG_INPUT;
            *fault = why;
            break;
        }
    }
    if (!code)
        tell_merged(options, study, files.shards);
    clear_files(&files);
    return code;
}

/* A shard ---------------------------------------------------------------------------------------------------------- */

int study_shards_answer(const Options *options, const Study *study) {
    StudyShard shard = options->study.shard;
    size_t all = study_room(study), done = study_done(study);
    char name[OUTPUT_NAME];
    study_shards_name(options, name);
    if (options->json) {
        json_t *answer = json_pack("{s:s, s:s, s:I, s:I, s:I, s:I, s:s}", "kind", "shard", "file", options->files[0],
                                   "shard", (json_int_t)shard.number, "shards", (json_int_t)shard.count, "trials",
                                   (json_int_t)all, "done", (json_int_t)done, "store", name);
        answer_mark_interrupted(answer, done < all);
        answer_print(answer);
    } else {
        printf("shard %zu of %zu: %zu of %zu runs are done, in %s/%s\n", shard.number, shard.count, done, all,
               options->out, name);
    }
    return done == all ? EXIT_ANSWERED : EXIT_ANSWER_NO;
}

/* Scripts ---------------------------------------------------------------------------------------------------------- */

/* Adds a word as a shell reads it. */
static void add_word(Text *text, const char *word) {
    static const char plain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
    if (*word && !word[strspn(word, plain)]) {
        text_add(text, word);
        return;
    }
    text_add(text, "'");
    for (const char *at = word; *at; at++)
        text_format(text, *at == '\'' ? "'\\''" : "%c", *at);
    text_add(text, "'");
}

/* Adds the command line without --print-shards and without the options that each script sets itself. */
static void add_command(Text *text, const Options *options) {
    static const char *const own[] = {"--print-shards", "--jobs"};
    for (int i = 0; i < options->argument_count; i++) {
        const char *word = options->arguments[i];
        bool is_own = strcmp(word, "--quiet") == 0;
        for (size_t o = 0; o < sizeof own / sizeof *own; o++) {
            size_t length = strlen(own[o]);
            if (strcmp(word, own[o]) == 0)
                i++; /* and its value */
            is_own |= strncmp(word, own[o], length) == 0 && (word[length] == '=' || !word[length]);
        }
        if (is_own)
            continue;
        text_add(text, i ? " " : "");
        add_word(text, word);
    }
}

/* 1.96, the half width of a 95 % interval in standard deviations */
#define WIDE_95 1.959963984540054

/* Adds how well the asked number of runs tells a share, and how many a wanted width needs. */
static void add_widths(Text *text, const Study *study) {
    static const double shares[] = {0.5, 0.1}, widths[] = {0.05, 0.02, 0.01, 0.005, 0.002};
    double runs = (double)study->runs;
    text_format(text, "# %zu runs of each point tell a share with 95 %% confidence to within", study->runs);
    for (size_t s = 0; s < sizeof shares / sizeof *shares; s++)
        text_format(text, "%s +-%.2g %% (a share of %.0f %%)", s ? "," : "",
                    100 * WIDE_95 * sqrt(shares[s] * (1 - shares[s]) / runs), 100 * shares[s]);
    text_add(text, ".\n# Runs that a width needs:");
    for (size_t w = 0; w < sizeof widths / sizeof *widths; w++)
        text_format(text, "%s +-%g %%: %.0f or %.0f", w ? "," : "", 100 * widths[w],
                    ceil(WIDE_95 * WIDE_95 * 0.25 / (widths[w] * widths[w])),
                    ceil(WIDE_95 * WIDE_95 * 0.09 / (widths[w] * widths[w])));
    text_add(
        text,
        ".\n# A difference between two files with the same seeds usually needs fewer: chance is common to both.\n");
}

int study_shards_print(const Options *options, const Study *study) {
    size_t shards = (size_t)options->study.print_shards;
    Text command = {0}, merge = {0}, text = {0};
    add_command(&command, options);
    text_format(&merge, "%s --merge", command.text);
    text_format(
        &text,
        "#!/bin/sh\n"
        "#SBATCH --array=1-%zu\n"
        "#SBATCH --cpus-per-task=2 --time=04:00:00 --requeue --open-mode=append --signal=B:TERM@60\n"
        "# %zu runs in %zu shards of at most %zu. Give each shard ten minutes or more; 4 to 20 shards per processor "
        "even out the rest.\n",
        shards, study_size(study), shards, (study_size(study) + shards - 1) / shards);
    if (study->runs > 1)
        add_widths(&text, study);
    text_add(&text,
             "#\n# With Slurm, save this as shards.sh, submit it, and merge when all have ended; shards that are "
             "missing then are run again with --array=3,17:\n"
             "# J=$(sbatch --parsable shards.sh); sbatch --dependency=afterany:$J --wrap ");
    add_word(&text, merge.text);
    text_format(&text,
                "\n# With GNU parallel, here or on other machines (--sshlogin 2/pc1,2/pc2,: --workdir .):\n"
                "# parallel -q --joblog log --retries 3 %s --shard {}/%zu --jobs 1 --quiet ::: $(seq %zu); %s\n"
                "exec %s --shard $SLURM_ARRAY_TASK_ID/%zu --jobs $SLURM_CPUS_PER_TASK --quiet\n",
                command.text, shards, shards, merge.text, command.text, shards);
    output_text(&text);
    memory_free(command.text);
    memory_free(merge.text);
    memory_free(text.text);
    return EXIT_ANSWERED;
}
