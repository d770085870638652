#include "lesson/language.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ENGLISH "en"
#define LANGUAGE_PATTERN "^[a-z]{2,3}$"

enum { LONGEST = 3 /* letters of a language */ };

/* Members with texts for people to read, or lists of them. */
static bool has_texts(const char *key) {
    static const char *const keys[] = {"title",   "level", "text",   "ask",       "model",   "done",
                                       "caption", "why",   "learn",  "options",   "wrong",   "hints",
                                       "head",    "rows",  "before", "questions", "mistakes"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(keys[i], key) == 0)
            return true;
    return false;
}

static size_t count_letters(const char *name) {
    return strspn(name, "abcdefghijklmnopqrstuvwxyz");
}

static bool is_language(const char *name) {
    size_t length = count_letters(name);
    return length >= 2 && length <= LONGEST && !name[length];
}

const char *language_wanted(void) {
    static const char *const names[] = {"LC_ALL", "LC_MESSAGES", "LANG"};
    static _Thread_local char language[LONGEST + 1];
    const char *locale = NULL;
    for (size_t i = 0; i < sizeof names / sizeof *names && !(locale && *locale); i++)
        locale = getenv(names[i]);
    size_t length = locale ? count_letters(locale) : 0;
    snprintf(language, sizeof language, "%.*s", (int)length, length ? locale : "");
    return length <= LONGEST && is_language(language) ? language : ENGLISH;
}

/* Returns the text of the wanted language, or the English one; new. */
static json_t *choose_text(const JsonNode *node, const char *language, Fault *fault) {
    const char *key;
    json_t *value, *chosen = json_object_get(node->value, language);
    json_object_foreach(node->value, key, value) {
        JsonNode text = json_member(node, key);
        if (!is_language(key))
            json_fault(&text, fault, "\"%.40s\" is not a language, must be 2 or 3 small letters, as \"ja\"", key);
        else if (!json_is_string(value))
            json_fault(&text, fault, "must be a text");
    }
    json_t *english = json_object_get(node->value, ENGLISH);
    if (!english)
        json_fault(node, fault, "a text in languages needs \"" ENGLISH "\"");
    chosen = chosen ? chosen : english;
    return json_is_string(chosen) ? json_copy(chosen) : json_string("");
}

/* Copies a value; `texts`: objects in it are texts in languages. */
static json_t *copy(const JsonNode *node, bool texts, const char *language, Fault *fault) {
    if (json_is_array(node->value)) {
        json_t *list = json_array();
        for (size_t i = 0; i < json_array_size(node->value); i++) {
            JsonNode element = json_element(node, i);
            json_array_append_new(list, copy(&element, texts, language, fault));
        }
        return list;
    }
    if (!json_is_object(node->value))
        return json_copy(node->value);
    if (texts)
        return choose_text(node, language, fault);
    json_t *object = json_object(), *value;
    const char *key;
    json_object_foreach(node->value, key, value) {
        JsonNode member = json_member(node, key);
        json_object_set_new(object, key, copy(&member, has_texts(key), language, fault));
    }
    return object;
}

json_t *language_choose(const JsonNode *root, const char *language, Fault *fault) {
    return copy(root, false, language, fault);
}

static void extend_texts(json_t *schema) {
    json_t *items = json_object_get(schema, "items");
    if (items) {
        extend_texts(items);
        return;
    }
    json_t *languages =
        json_pack("{s:[s,s], s:[s], s:{s:s}, s:{s:s}}", "type", "string", "object", "required", ENGLISH,
                  "propertyNames", "pattern", LANGUAGE_PATTERN, "additionalProperties", "type", "string");
    json_object_update(schema, languages);
    json_decref(languages);
}

void language_extend_schema(json_t *schema) {
    const char *key;
    json_t *member, *items = json_object_get(schema, "items");
    if (items)
        language_extend_schema(items);
    json_object_foreach(json_object_get(schema, "properties"), key, member) {
        if (has_texts(key))
            extend_texts(member);
        else
            language_extend_schema(member);
    }
}
