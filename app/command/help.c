/* `clearance help`: topics are the text files of the folder help of the assets; the first line of each is its title. */
#include "command/output.h"
#include "options/help.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "command/command.h"
#include "laboratory/shipped.h"

enum {
    TOPICS_MOST = 40,
    TOPIC_LARGEST = 1 << 20 /* bytes */,
    TITLE_COLUMN = 16,
    PART_LEAST = 3 /* letters of a name */
};

#define ENDING ".txt"
#define OPTIONS_TOPIC "options" /* which is made from the table of options */

typedef struct Topics {
    const char *names[TOPICS_MOST + VERBS]; /* (count) sorted; after them the verbs */
    size_t count;
    Arena arena;
} Topics;

static int is_topic(const struct dirent *entry) {
    size_t length = strlen(entry->d_name), ending = strlen(ENDING);
    return *entry->d_name != '.' && length > ending && strcmp(entry->d_name + length - ending, ENDING) == 0;
}

static int by_name(const void *a, const void *b) {
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static void find_topics(Topics *topics) {
    struct dirent **entries = NULL;
    int count = scandir(shipped_places()->help, &entries, is_topic, NULL);
    topics->names[topics->count++] = OPTIONS_TOPIC;
    for (int i = 0; i < count; i++) {
        if (topics->count < TOPICS_MOST)
            topics->names[topics->count++] = text_in_arena(
                &topics->arena, "%.*s", (int)(strlen(entries[i]->d_name) - strlen(ENDING)), entries[i]->d_name);
        free(entries[i]);
    }
    free(entries);
    qsort(topics->names, topics->count, sizeof *topics->names, by_name);
    for (size_t v = 0; v < VERBS; v++)
        topics->names[topics->count + v] = verb_rows[v].name;
}

/* The text of a topic; NULL if there is none. memory_free it. */
static char *read_topic(const char *name) {
    if (strcmp(name, OPTIONS_TOPIC) == 0) {
        Text text = {0};
        help_add_options(&text);
        return text.text;
    }
    Text path = {0};
    size_t size;
    text_format(&path, "%s/%s" ENDING, shipped_places()->help, name);
    char *text = text_read_file(path.text, TOPIC_LARGEST, &size);
    memory_free(path.text);
    return text;
}

static void list_topics(const Topics *topics) {
    Text text = {0};
    if (shipped_places()->missing)
        fprintf(stderr, "%s\n", shipped_places()->missing);
    text_add(&text, "Topics, to be read with `clearance help TOPIC`:\n\n");
    for (size_t t = 0; t < topics->count; t++) {
        char *topic = read_topic(topics->names[t]);
        const char *title = topic ? strchr(topic, ':') : NULL;
        if (title) {
            topic[strcspn(topic, "\n")] = '\0';
            text_format(&text, "  %-*s", TITLE_COLUMN - 2, topics->names[t]);
            help_add_wrapped(&text, title + 2, TITLE_COLUMN);
        }
        memory_free(topic);
    }
    text_add(&text, "\n`clearance help VERB` prints the help of a verb, `clearance --help` the verbs.\n");
    output_text(&text);
    memory_free(text.text);
}

/* The words of the command line as one name: "house file" is house-file. */
static const char *name_of(const Options *options, Topics *topics) {
    Text name = {0};
    for (size_t f = 0; f < options->file_count; f++)
        text_format(&name, "%s%s", f ? "-" : "", options->files[f]);
    const char *kept = text_in_arena(&topics->arena, "%s", name.text);
    memory_free(name.text);
    return kept;
}

/* Returns the topic, or else the verb, one of whose words is spelt almost so, or NULL: "huose" is near house-file. */
static const char *nearest_by_word(Topics *topics, const char *name) {
    for (size_t t = 0; t < topics->count + VERBS; t++)
        for (const char *at = topics->names[t]; *at;) {
            size_t length = strcspn(at, "-");
            const char *word = memcpy(arena_allocate(&topics->arena, length + 1), at, length);
            if (text_nearest(name, &word, 1))
                return topics->names[t];
            at += length + (at[length] == '-');
        }
    return NULL;
}

/* Adds the topics and verbs of whose name this is a part, separated by commas; returns how many. */
static size_t add_containing(Text *list, const Topics *topics, const char *name) {
    size_t count = 0;
    for (size_t t = 0; t < topics->count + VERBS; t++)
        if (strcasestr(topics->names[t], name))
            text_format(list, "%s%s", count++ ? ", " : "", topics->names[t]);
    return count;
}

static int complain(Topics *topics, const char *name) {
    Text containing = {0};
    size_t count = strlen(name) < PART_LEAST ? 0 : add_containing(&containing, topics, name);
    const char *nearest = count == 1 ? containing.text : NULL;
    if (!count)
        nearest = text_nearest(name, topics->names, topics->count + VERBS);
    if (!count && !nearest)
        nearest = nearest_by_word(topics, name);
    if (nearest)
        fprintf(stderr, "clearance: there is no topic \"%s\", did you mean %s?\n", name, nearest);
    else if (count)
        fprintf(stderr, "clearance: there is no topic \"%s\", did you mean one of %s?\n", name, containing.text);
    else
        fprintf(stderr, "clearance: there is no topic \"%s\", `clearance help` lists the topics\n", name);
    memory_free(containing.text);
    return EXIT_WRONG_INPUT;
}

static int print_topic(Topics *topics, const char *name) {
    const Verb *verb = verb_find(name);
    bool known = text_is_among(name, topics->names, topics->count);
    if (!known && !verb)
        return complain(topics, name);
    Text text = {0};
    if (!known)
        help_add_verb(&text, (VerbId)(verb - verb_rows));
    char *topic = known ? read_topic(name) : text.text;
    if (!topic) {
        fprintf(stderr, "clearance: %s/%s" ENDING " cannot be read\n", shipped_places()->help, name);
        return EXIT_OUR_FAULT;
    }
    fputs(topic, stdout);
    memory_free(topic);
    return EXIT_ANSWERED;
}

int command_help(const Options *options) {
    Topics topics = {.count = 0};
    int code = EXIT_ANSWERED;
    find_topics(&topics);
    if (options->file_count)
        code = print_topic(&topics, name_of(options, &topics));
    else
        list_topics(&topics);
    arena_clear(&topics.arena);
    return code;
}
