#include "laboratory/edit/tool_items.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

#include "laboratory/shipped.h"
#include "result/names.h"

#define USUAL_PROFILE "manual-chair" /* profile that is placed by default */

static int is_json(const struct dirent *entry) {
    size_t length = strlen(entry->d_name);
    return length > 5 && strcmp(entry->d_name + length - 5, ".json") == 0;
}

static bool is_stocked(const Editor *edit, const char *name) {
    for (size_t p = 0; p < edit->profile_count; p++)
        if (strcmp(edit->profiles[p], name) == 0)
            return true;
    return false;
}

/* Adds the profiles of a folder whose names are new. */
static void stock_folder(Editor *edit, const char *folder, size_t *capacity) {
    struct dirent **entries;
    int count = scandir(folder, &entries, is_json, alphasort);
    for (int i = 0; i < count; i++) {
        Text name = {0};
        text_format(&name, "%.*s", (int)strlen(entries[i]->d_name) - 5, entries[i]->d_name);
        free(entries[i]);
        if (is_stocked(edit, name.text)) {
            memory_free(name.text);
            continue;
        }
        if (strcmp(name.text, USUAL_PROFILE) == 0)
            edit->chosen_rows[TOOL_PERSON] = edit->profile_count;
        edit->profiles = memory_reserve(edit->profiles, capacity, edit->profile_count + 1, sizeof *edit->profiles);
        edit->profiles[edit->profile_count++] = name.text;
    }
    if (count >= 0)
        free(entries);
}

static void stock_profiles(Editor *edit) {
    size_t capacity = 0;
    for (const char *at = edit->options.profiles; *at;) {
        size_t length = strcspn(at, "\n");
        Text folder = {0};
        text_format(&folder, "%.*s", (int)length, at);
        stock_folder(edit, folder.text, &capacity);
        memory_free(folder.text);
        at += length + (at[length] == '\n');
    }
}

void edit_tool_items_stock(Editor *edit) {
    if (edit->stocked)
        return;
    edit->stocked = true;
    Fault none = {0}; /* the unit tests report errors in shipped files */
    catalogue_read_folder(&edit->catalogue, shipped_places()->furniture, &none);
    fault_clear(&none);
    stock_profiles(edit);
}

void edit_tool_items_clear(Editor *edit) {
    for (size_t i = 0; i < edit->profile_count; i++)
        memory_free(edit->profiles[i]);
    memory_free(edit->profiles);
    memory_free(edit->item_rows);
    arena_clear(&edit->item_texts);
    catalogue_free(&edit->catalogue);
}

static void add(Editor *edit, size_t *count, CatalogueRow item) {
    edit->item_rows = memory_reserve(edit->item_rows, &edit->row_capacity, *count + 1, sizeof *edit->item_rows);
    edit->item_rows[(*count)++] = item;
}

static void list_furniture(Editor *edit, size_t *count) {
    add(edit, count, (CatalogueRow){.name = "free rectangle", .group = "", .detail = "drawn from corner to corner"});
    for (size_t i = 0; i < edit->catalogue.count; i++) {
        const CatalogueItem *item = &edit->catalogue.items[i];
        add(edit, count,
            (CatalogueRow){.name = item->name,
                           .group = item->group,
                           .detail = text_in_arena(&edit->item_texts, "%.2f x %.2f m, %.2f m high (%s)", item->size.x,
                                                   item->size.y, item->height, item->provenance),
                           .size = item->size});
    }
}

const CatalogueRow *edit_tool_items_list(Editor *edit, size_t *count) {
    *count = 0;
    edit_tool_items_stock(edit);
    arena_clear(&edit->item_texts);
    if (edit->tool == TOOL_FURNITURE) {
        list_furniture(edit, count);
    } else if (edit->tool == TOOL_PERSON) {
        for (size_t i = 0; i < edit->profile_count; i++)
            add(edit, count, (CatalogueRow){.name = names_profile(edit->profiles[i]), .group = "", .detail = ""});
    } else if (edit->tool == TOOL_DOOR) {
        add(edit, count, (CatalogueRow){.name = "hinged", .group = "", .detail = "a leaf that swings"});
        add(edit, count, (CatalogueRow){.name = "opening", .group = "", .detail = "without a leaf"});
        add(edit, count, (CatalogueRow){.name = "sliding", .group = "", .detail = "a leaf that slides along the wall"});
    }
    if (edit->tool == TOOL_MEASURE) {
        add(edit, count, (CatalogueRow){.name = "measure", .group = "", .detail = "a distance, and what fits through"});
        add(edit, count,
            (CatalogueRow){.name = "set the scale",
                           .group = "",
                           .detail = "of the whole house: two points, then their real distance"});
    }
    if (edit->tool == TOOL_IMAGE) {
        add(edit, count, (CatalogueRow){.name = "scale", .group = "", .detail = "two points and their real distance"});
        add(edit, count,
            (CatalogueRow){
                .name = "level", .group = "", .detail = "two points that are level, or one above the other"});
    }
    return edit->item_rows;
}
