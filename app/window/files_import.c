#include "window/files_import.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "laboratory/import_file.h"
#include "window/act.h"

bool files_import_knows(const char *path) {
    return import_file_knows(path);
}

/* Line by line into the log; the line that is seen tells how much there is. */
static void tell(Window *window, const char *path, const ImportFile *import) {
    for (size_t i = 0; i < import->told.count; i++)
        act_say(window, "%s: %s", path, import->told.lines[i]);
    const char *left = import->left.text;
    act_say(window, "a new house, from %s%s%s%s", import->format, left ? "; left out: " : "", left ? left : "",
            import->told.count ? " (F7 tells all)" : "");
}

/* A house is opened from a file: until it is saved that is where it would be recovered from, too. */
static bool open_text(Window *window, const char *path, const ImportFile *import) {
    RecoveryAbout about = {.name = import->name, .edits = 1, .when = (int64_t)time(NULL)};
    int error = recovery_write(window->recovery, import->text, &about);
    if (error) {
        act_say(window, "%s cannot be imported: %s: %s", path, recovery_path(window->recovery), strerror(error));
        return false;
    }
    if (!act_open_copy(window, recovery_path(window->recovery), NULL, " [Imported]"))
        return false;
    window->watch.waits = true;
    return true;
}

bool files_import_open(Window *window, const char *path) {
    ImportFile import = {.text = NULL};
    Fault fault = {0};
    bool read = window->recovery && import_file_read(&import, path, &fault);
    if (!window->recovery)
        act_say(window, "%s cannot be imported: there is no folder to keep it in", path);
    act_complain(window, &fault, NAN);
    read = read && open_text(window, path, &import);
    if (read)
        tell(window, path, &import);
    import_file_clear(&import);
    return read;
}
