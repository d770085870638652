#include "platform/folder.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "desk.h"

TEST(names_are_in_natural_order) {
    CHECK(folder_compare("a2", "a10") < 0);
    CHECK(folder_compare("a10", "a2") > 0);
    CHECK(folder_compare("corner-0.90", "corner-1.20") < 0);
    CHECK(folder_compare("A", "b") < 0);
    CHECK(folder_compare("B", "a") > 0);
    CHECK(folder_compare("a", "a") == 0);
    CHECK(folder_compare("a", "A") != 0);
    CHECK(folder_compare("a", "ab") < 0);
    CHECK(folder_compare("a007b", "a7c") < 0);
    CHECK(folder_compare("a99999999999999999999999", "a100000000000000000000000") < 0);
}

TEST(a_folder_lists_what_is_above_then_folders_then_files) {
    desk_make();
    desk_write("in/h10.json", "{\n  \"format\": \"clearance-house\", \"version\": 1}");
    desk_write("in/h2.JSON", "{\"format\":\"clearance-beam\"}");
    desk_write("in/other.json", "[]");
    desk_write("in/empty.json", "");
    desk_write("in/.hidden.json", "{}");
    desk_write("in/notes.txt", "\"clearance-house\"");
    desk_write("in/zoo/x", "");
    desk_write("in/Big/x", "");
    CHECK(symlink("nowhere", desk_path("in/dangling.json")) == 0);
    Folder folder = {.count = 0};
    Fault fault = {0};
    CHECK(folder_read(&folder, "in/../in/", NULL, &fault));
    CHECK_TEXT(folder.path, desk_path("in"));
    static const char *const names[] = {"..", "Big", "zoo", "empty.json", "h2.JSON", "h10.json", "other.json"};
    static const FolderKind kinds[] = {FOLDER_ABOVE, FOLDER_FOLDER, FOLDER_FOLDER, FOLDER_FILE,
                                       FOLDER_FILE,  FOLDER_FILE,   FOLDER_FILE};
    static const char *const formats[] = {"", "", "", "", "beam", "house", ""};
    CHECK(folder.count == sizeof names / sizeof *names);
    for (size_t i = 0; i < folder.count && i < sizeof names / sizeof *names; i++) {
        CHECK_TEXT(folder.entries[i].name, names[i]);
        CHECK(folder.entries[i].kind == kinds[i]);
        CHECK_TEXT(folder.entries[i].format ? folder.entries[i].format : "", formats[i]);
    }
    CHECK_TEXT(folder.entries[1].path, desk_path("in/Big"));
    char *home = strdup(desk_path("in")); /* the home folder is its parent */
    *strrchr(home, '/') = 0;
    CHECK_TEXT(folder.entries[0].path, home);
    free(home);
    folder_clear(&folder);
    desk_remove();
}

TEST(the_root_has_nothing_above) {
    Folder folder = {.count = 0};
    Fault fault = {0};
    CHECK(folder_read(&folder, "/", NULL, &fault));
    CHECK(folder.count && folder.entries[0].kind == FOLDER_FOLDER);
    CHECK(folder.count && folder.entries[0].path[0] == '/' && folder.entries[0].path[1] != '/');
    folder_clear(&folder);
}

TEST(a_folder_that_is_not_there_is_a_fault_and_nothing_is_lost) {
    desk_make();
    desk_write("a.json", "{}");
    Folder folder = {.count = 0};
    Fault fault = {0};
    CHECK(folder_read(&folder, "", NULL, &fault) && folder.count == 2);
    CHECK(!folder_read(&folder, "nowhere", NULL, &fault) && folder.count == 2);
    CHECK(!folder_read(&folder, "a.json", NULL, &fault) && folder.count == 2);
    CHECK_TEXT(fault.count ? fault.lines[0] : "", "nowhere cannot be opened: No such file or directory");
    fault_clear(&fault);
    folder_clear(&folder);
    desk_remove();
}
