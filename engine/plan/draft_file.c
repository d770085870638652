#include "plan/draft_file.h"

#include <errno.h>
#include <string.h>

#include "base/file_write.h"
#include "base/json.h"
#include "base/text.h"
#include "plan/draft_change.h"
#include "plan/plan_tables.h"

static void keep_file(Draft *draft, const char *path, char *bytes, size_t byte_count) {
    char *kept = text_copy(path); /* `path` may be the draft's own */
    memory_free(draft->path);
    memory_free(draft->saved);
    memory_free(draft->bytes);
    draft->path = kept;
    draft->saved = text_copy(draft_text(draft));
    draft->bytes = bytes;
    draft->byte_count = byte_count;
}

Draft *draft_file_read(const char *path, const char *const *settings, size_t setting_count, Fault *fault) {
    Plan plan = {0};
    size_t byte_count = 0;
    char *bytes = text_read_file(path, JSON_LARGEST_FILE, &byte_count);
    if (!bytes) {
        fault_add(fault, "%s:1:1: cannot be read: %s", path, text_read_reason(errno));
        return NULL;
    }
    if (!plan_read_text(&plan, path, bytes, settings, setting_count, fault)) {
        memory_free(bytes);
        return NULL;
    }
    Draft *draft = draft_of_plan(&plan);
    if (setting_count) { /* the file's bytes do not describe the house */
        memory_free(bytes);
        bytes = NULL;
    }
    keep_file(draft, path, bytes, byte_count);
    return draft;
}

Draft *draft_file_of_text(const char *path, const char *text, const char *const *settings, size_t setting_count,
                          Fault *fault) {
    Plan plan = {0};
    return plan_read_text(&plan, path, text, settings, setting_count, fault) ? draft_of_plan(&plan) : NULL;
}

const char *draft_file_path(const Draft *draft) {
    return draft->path;
}

bool draft_file_is_changed(Draft *draft) {
    return !draft->saved || strcmp(draft->saved, draft_text(draft)) != 0;
}

bool draft_file_save(Draft *draft, const char *path, Fault *fault) {
    draft_cancel(draft);
    bool as_read = draft->bytes && !draft_file_is_changed(draft);
    const char *bytes = as_read ? draft->bytes : draft_text(draft);
    size_t count = as_read ? draft->byte_count : strlen(bytes);
    int error = file_write_bytes(path, bytes, count);
    if (error) {
        fault_add(fault, "%s cannot be written: %s", path, file_write_reason(error));
        return false;
    }
    char *kept = as_read ? draft->bytes : NULL;
    if (as_read)
        draft->bytes = NULL;
    keep_file(draft, path, kept, count);
    return true;
}

void draft_file_reset(Draft *draft, const char *name) {
    json_t *house = draft->saved ? json_loads(draft->saved, 0, NULL) : NULL;
    if (!house)
        return;
    draft_begin(draft, name);
    for (int l = 0; l < DRAFT_LISTS; l++) {
        while (draft_count(draft, (DraftList)l))
            draft_change_element(draft, (DraftList)l, draft_count(draft, (DraftList)l) - 1, NULL);
        const json_t *list = json_object_get(house, plan_tables_lists[l].key);
        for (size_t i = 0; i < json_array_size(list); i++)
            draft_change_make(draft, (DraftList)l, i, NULL, NULL, json_incref(json_array_get(list, i)));
        json_object_del(house, plan_tables_lists[l].key);
    }
    static const char *const members[] = {"name", "note", "run", "overrides", "background"};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        json_t *value = json_object_get(house, members[i]);
        if (value || draft_house(draft, members[i]))
            draft_set_house(draft, members[i], json_incref(value));
    }
    json_decref(house);
    Fault none = {0};
    draft_end(draft, &none);
    fault_clear(&none);
}
