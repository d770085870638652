#include "plan/catalogue.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/json.h"
#include "base/text.h"

static const Parameter item_rows[] = {
    {.name = "name",
     .kind = PARAMETER_TEXT,
     .offset = offsetof(CatalogueItem, name),
     .unit = "",
     .needed = true,
     .meaning = "displayed name"},
    {.name = "size",
     .kind = PARAMETER_POINT,
     .offset = offsetof(CatalogueItem, size),
     .unit = "m",
     .needed = true,
     .meaning = "width and depth of the footprint"},
    {.name = "height",
     .kind = PARAMETER_NUMBER,
     .offset = offsetof(CatalogueItem, height),
     .unit = "m",
     .low = 0,
     .high = 100,
     .needed = true,
     .meaning = "height"},
    {.name = "topples",
     .kind = PARAMETER_CHOICE,
     .offset = offsetof(CatalogueItem, topples),
     .unit = "",
     .fallback = TOPPLE_NO,
     .choices = "front|back|left|right|no",
     .meaning = "the face it falls to; its back stands against the wall",
     .provenance = "assumed"},
    {.name = "probability",
     .kind = PARAMETER_NUMBER,
     .offset = offsetof(CatalogueItem, probability),
     .unit = "1",
     .low = 0,
     .high = 1,
     .fallback = 0.5,
     .meaning = "probability of toppling in a shake",
     .provenance = "assumed"},
    {.name = "provenance",
     .kind = PARAMETER_TEXT,
     .offset = offsetof(CatalogueItem, provenance),
     .unit = "",
     .needed = true,
     .meaning = "where the sizes come from: literature: SOURCE, or assumed"},
};

static const ParameterTable item_table = {"piece", item_rows, sizeof item_rows / sizeof *item_rows};

static const double LEAST_SIZE = 0.01; /* m, as for a plan's furniture */

static bool is_sourced(const char *provenance) {
    return strncmp(provenance, "literature: ", 12) == 0 || strncmp(provenance, "assumed", 7) == 0;
}

static void read_item(Catalogue *catalogue, const char *group, const JsonNode *node, Fault *fault) {
    CatalogueItem item = {.group = group};
    JsonNode provenance = json_member(node, "provenance"), size = json_member(node, "size");
    if (!parameters_read(&item_table, &item, node, &catalogue->arena, fault))
        return;
    if (!is_sourced(item.provenance))
        json_fault(&provenance, fault, "provenance must begin with literature: or assumed");
    if (!(item.size.x >= LEAST_SIZE && item.size.y >= LEAST_SIZE))
        json_fault(&size, fault, "size is (%g, %g), must be at least %g m in both directions", item.size.x, item.size.y,
                   LEAST_SIZE);
    catalogue->items =
        memory_reserve(catalogue->items, &catalogue->capacity, catalogue->count + 1, sizeof *catalogue->items);
    catalogue->items[catalogue->count++] = item;
}

static void read_items(Catalogue *catalogue, const JsonNode *root, Fault *fault) {
    static const char *const keys[] = {"format", "version", "name", "note", "items", NULL};
    json_check_keys(root, keys, fault);
    const char *group = json_read_text(root, "name", &catalogue->arena, fault);
    json_read_text(root, "note", &catalogue->arena, fault);
    JsonNode items = json_member(root, "items");
    if (!json_is_array(items.value)) {
        json_fault(items.value ? &items : root, fault, "a furniture file has no \"items\", must be a list [ ... ]");
        return;
    }
    for (size_t i = 0; i < json_array_size(items.value); i++) {
        JsonNode item = json_element(&items, i);
        read_item(catalogue, group, &item, fault);
    }
}

bool catalogue_read(Catalogue *catalogue, const char *path, Fault *fault) {
    size_t before = fault->total, count = catalogue->count;
    JsonFile file = {0};
    if (!json_read(&file, path, fault))
        return false;
    JsonNode root = json_root(&file);
    if (json_check_header(&root, "furniture file", "clearance-furniture", fault))
        read_items(catalogue, &root, fault);
    json_free(&file);
    if (fault->total == before)
        return true;
    catalogue->count = count;
    return false;
}

static int is_json(const struct dirent *entry) {
    size_t length = strlen(entry->d_name);
    return length > 5 && strcmp(entry->d_name + length - 5, ".json") == 0;
}

bool catalogue_read_folder(Catalogue *catalogue, const char *folder, Fault *fault) {
    size_t before = fault->total;
    struct dirent **entries;
    int count = scandir(folder, &entries, is_json, alphasort);
    if (count < 0)
        fault_add(fault, "%s:1:1: cannot be read: %s", folder, strerror(errno));
    for (int i = 0; i < count; i++) {
        Text path = {0};
        text_format(&path, "%s/%s", folder, entries[i]->d_name);
        catalogue_read(catalogue, path.text, fault);
        memory_free(path.text);
        free(entries[i]);
    }
    if (count >= 0)
        free(entries);
    return fault->total == before;
}

void catalogue_free(Catalogue *catalogue) {
    memory_free(catalogue->items);
    arena_clear(&catalogue->arena);
    *catalogue = (Catalogue){0};
}
