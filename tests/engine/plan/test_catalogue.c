/* Tests the catalogue: every shipped piece has a size and a source, and can be read. */

#include "plan/catalogue.h"

#include <stdio.h>
#include <string.h>

#include "check.h"
#include "scratch.h"

TEST(every_shipped_piece_says_how_large_it_is_and_where_that_comes_from) {
    Catalogue catalogue = {0};
    Fault fault = {0};
    CHECK(catalogue_read_folder(&catalogue, scratch_source("assets/furniture"), &fault));
    for (size_t i = 0; i < fault.count; i++)
        printf("%s\n", fault.lines[i]);
    CHECK(catalogue.count >= 40);
    for (size_t i = 0; i < catalogue.count; i++) {
        const CatalogueItem *item = &catalogue.items[i];
        bool sourced =
            strncmp(item->provenance, "literature: ", 12) == 0 || strncmp(item->provenance, "assumed", 7) == 0;
        CHECK(*item->name && *item->group && sourced);
        CHECK(item->size.x >= 0.3 && item->size.x <= 2.5 && item->size.y >= 0.2 && item->size.y <= 2.5);
        CHECK(item->height > 0 && item->height < 2.5);
        CHECK(item->topples == TOPPLE_NO || item->height > item->size.y); /* low pieces do not fall */
        for (size_t k = 0; k < i; k++)
            CHECK(strcmp(catalogue.items[k].name, item->name) != 0 ||
                  strcmp(catalogue.items[k].group, item->group) != 0);
    }
    catalogue_free(&catalogue);
    fault_clear(&fault);
}

static void check_fault(const char *text, const char *expected) {
    char path[SCRATCH_PATH];
    Catalogue catalogue = {0};
    Fault fault = {0};
    scratch_write(path, text);
    CHECK(!catalogue_read(&catalogue, path, &fault));
    CHECK(catalogue.count == 0 && fault.count > 0);
    if (fault.count && !strstr(fault.lines[0], expected))
        CHECK_TEXT(fault.lines[0], expected);
    catalogue_free(&catalogue);
    fault_clear(&fault);
    remove(path);
}

TEST(a_bad_catalogue_is_refused_with_the_place) {
    check_fault("[]", ":1:1: a furniture file must be an object");
    check_fault("{'format': 'clearance-furniture', 'version': 1, 'name': 'X'}",
                ":1:1: a furniture file has no \"items\"");
    check_fault("{'format': 'clearance-furniture', 'version': 1, 'name': 'X', 'items': [{'name': 'a', 'size': [1, 1], "
                "'height': 1, 'provenance': 'seen somewhere'}]}",
                "provenance must begin with literature: or assumed");
    check_fault("{'format': 'clearance-furniture', 'version': 1, 'name': 'X', 'items': [{'name': 'a', 'size': [0, 1], "
                "'height': 1, 'provenance': 'assumed'}]}",
                "must be at least 0.01 m");
    check_fault("{'format': 'clearance-furniture', 'version': 1, 'name': 'X', 'items': [{'name': 'a', 'size': [1, 1], "
                "'height': 1, 'tall': 2, 'provenance': 'assumed'}]}",
                "tall");
}

TEST(a_folder_that_is_not_there_is_said) {
    Catalogue catalogue = {0};
    Fault fault = {0};
    CHECK(!catalogue_read_folder(&catalogue, "/nowhere/at-all", &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "/nowhere/at-all"));
    catalogue_free(&catalogue);
    fault_clear(&fault);
}
