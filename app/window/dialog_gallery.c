#include "window/dialog_gallery.h"

#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "laboratory/import_file.h"
#include "window/autosave.h"
#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/notice.h"
#include "window/opening.h"

/* Design points. */
#define EDGE 24.0
#define ITEM_WIDTH 268.0
#define PICTURE_HEIGHT 150.0
#define PICTURE_PART 0.3 /* of the page, at most: a card is seen whole, whatever the size of the text */
#define EDGE_PART 0.033  /* of the page, at most */
#define TEXT_HEIGHT 78.0
#define GAP 12.0
#define TRY_HEIGHT 26.0

enum { LESSON_COLUMNS = 3, CROWD_PEOPLE = 30, FIND_MOST = 64 };

/* The gallery ------------------------------------------------------------------------------------------------------ */

/* Uploads the pictures that are new; all of them if `anew`, when some have come or the theme has changed. */
static void fill_pictures(Window *window, const GalleryItem *items, size_t count, bool anew) {
    for (size_t i = 0; i < count && i < GALLERY_MOST; i++)
        if (items[i].pixels && (anew || !window->pictures[i].name))
            paint_gl_screen_fill(window->screen, &window->pictures[i], items[i].pixels, GALLERY_WIDTH, GALLERY_HEIGHT,
                                 4 * GALLERY_WIDTH, 0, 0, GALLERY_WIDTH, GALLERY_HEIGHT);
}

void dialog_gallery_clear(Window *window) {
    for (size_t i = 0; i < GALLERY_MOST; i++)
        if (window->pictures[i].name)
            paint_gl_screen_release(window->screen, &window->pictures[i]);
}

static double picture_height(const Window *window) {
    return fmin(PICTURE_HEIGHT, PICTURE_PART * window->frame.page.y);
}

/* Returns the page without an edge of some steps, which is smaller if the text is large. */
static Box inner_page(const Window *window, double steps) {
    Vec2 page = window->frame.page;
    return box_expand((Box){{0, 0}, page}, -steps * fmin(EDGE, EDGE_PART * page.y));
}

/* Shows a card with picture, name and line; true if it was chosen. */
static bool show_item(Window *window, const GalleryItem *item, size_t index) {
    UiCard card = {.id = item->path,
                   .name = item->name,
                   .text = item->fault ? item->fault : item->line,
                   .picture = index < GALLERY_MOST && window->pictures[index].name ? &window->pictures[index] : NULL,
                   .picture_height = picture_height(window),
                   .text_height = TEXT_HEIGHT};
    return ui_card(window->ui, &card);
}

/* The groups of the start page, in their order. */
typedef enum Group { GROUP_LESSONS, GROUP_HOUSES, GROUP_CROWDS, GROUP_BEAMS, GROUP_CRANKS, GROUPS } Group;

static const char *const group_names[GROUPS] = {[GROUP_LESSONS] = "Lessons",
                                                [GROUP_HOUSES] = "Houses",
                                                [GROUP_CROWDS] = "Crowds",
                                                [GROUP_BEAMS] = "Beams",
                                                [GROUP_CRANKS] = "Cranks"};

/* The first things to try, by the keys 1, 2 and 3. */
static const struct {
    const char *file, *name, *line;
} tries[] = {{"ube-techno-house", "1  Watch four people leave", "Space plays it"},
             {"flat-0.910-module", "2  Set somebody free", "a door is too narrow: Suggest a fix"},
             {"bedroom-after-earthquake", "3  After the earthquake", "two pieces lie on the way"}};

enum { TRIES = sizeof tries / sizeof *tries };

static const char corner[] = "corner-";

static const char *file_name(const GalleryItem *item) {
    const char *slash = strrchr(item->path, '/');
    return slash ? slash + 1 : item->path;
}

static bool is_corner(const GalleryItem *item) {
    return strncmp(file_name(item), corner, sizeof corner - 1) == 0;
}

static bool is_try(const GalleryItem *item, size_t index) {
    size_t length = strlen(tries[index].file);
    return !item->lesson && strncmp(file_name(item), tries[index].file, length) == 0 &&
           strcmp(file_name(item) + length, ".json") == 0;
}

static Group group_of(const GalleryItem *item) {
    if (item->lesson)
        return GROUP_LESSONS;
    if (item->laboratory > 0)
        return item->laboratory == 1 ? GROUP_BEAMS : GROUP_CRANKS;
    return item->people >= CROWD_PEOPLE ? GROUP_CROWDS : GROUP_HOUSES;
}

/* True if the name of an item, or of its file, contains what is typed. */
static bool matches(const Window *window, const GalleryItem *item) {
    return !*window->field || strcasestr(item->name, window->field) || strcasestr(file_name(item), window->field);
}

/* Notes the card that is shown next, for tests. */
static void note(Window *window, const char *name) {
    if (window->shown_count < GALLERY_MOST)
        window->shown[window->shown_count++] = name;
}

/* Shows the cards that are tried first; returns the path of the chosen one, or NULL. */
static const char *show_tries(Window *window, const GalleryItem *items, size_t count, int columns) {
    const char *chosen = NULL;
    int in_row = columns < TRIES - 1 ? 1 : TRIES;
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Try this");
    note(window, "# Try this");
    for (size_t t = 0; t < TRIES; t++) {
        if (t % (size_t)in_row == 0)
            ui_row(window->ui, in_row);
        for (size_t i = 0; i < count; i++) {
            if (!is_try(&items[i], t))
                continue;
            note(window, tries[t].name);
            UiCard card = {.id = tries[t].file,
                           .name = tries[t].name,
                           .text = tries[t].line,
                           .picture = i < GALLERY_MOST && window->pictures[i].name ? &window->pictures[i] : NULL,
                           .picture_height = picture_height(window),
                           .text_height = TRY_HEIGHT,
                           .whole = true};
            if (ui_card(window->ui, &card))
                chosen = items[i].path;
        }
    }
    ui_row(window->ui, 1);
    return chosen;
}

/* Offers to go on with the house that is being edited; true if that was chosen. */
static bool show_continue(Window *window) {
    const Tab *tab = autosave_tab(window);
    size_t edits = tab_edit_count(tab);
    if (!edits)
        return false;
    const char *name = text_in_arena(&window->arena, "Continue: %s", tab_title(tab, &window->arena));
    note(window, name);
    return ui_list_row(
        window->ui, &(UiRow){.id = "continue",
                             .shape = ROW_PLAIN,
                             .cells = {name, edits == 1 ? "1 edit" : text_in_arena(&window->arena, "%zu edits", edits)},
                             .help = "Continue: Go back to the house that you were editing",
                             .usable = true});
}

/* Returns when a file was changed last, or NULL. */
static const char *changed_when(Window *window, const char *path) {
    struct stat status;
    return stat(path, &status) == 0 ? dialog_pane_when(window, (int64_t)status.st_mtime) : NULL;
}

/* Shows lessons as lines: they have questions, which no picture tells. */
static bool show_lesson(Window *window, const GalleryItem *item) {
    return ui_list_row(
        window->ui,
        &(UiRow){.id = item->path, .shape = ROW_PLAIN, .cells = {item->name}, .help = item->about, .usable = true});
}

/* Shows the choice of the one corner that has a card. */
static void show_corners(Window *window, const GalleryItem *items, size_t count) {
    enum { MOST = 12 };
    const char *widths[MOST];
    size_t corners = 0;
    for (size_t i = 0; i < count && corners < MOST; i++)
        if (is_corner(&items[i]) && !items[i].lesson) {
            const char *name = file_name(&items[i]) + sizeof corner - 1;
            widths[corners++] = text_in_arena(&window->arena, "%.*s m into %.*s m", (int)strcspn(name, "-"), name,
                                              (int)strcspn(strchr(name, '-') ? strchr(name, '-') + 1 : "", "j") - 1,
                                              strchr(name, '-') ? strchr(name, '-') + 1 : "");
        }
    if (corners > 1 && window->corner >= corners)
        window->corner = 0;
    if (corners > 1)
        ui_choice(window->ui, "corner", "Corner", "Corner: Choose the widths of the corner that has a card", widths,
                  corners, &window->corner);
}

/* Shows a group of items that match what is typed; returns the path of the chosen one, or NULL. */
static const char *show_group(Window *window, const GalleryItem *items, size_t count, Group group, int columns) {
    const char *chosen = NULL;
    bool rows = group == GROUP_LESSONS && !window->lessons_only, all = *window->field || window->lessons_only;
    size_t shown = 0, corners = 0, in_row = (size_t)(rows && columns >= LESSON_COLUMNS ? LESSON_COLUMNS : columns);
    for (size_t i = 0; i < count; i++) {
        bool nth = !is_corner(&items[i]) || corners++ == window->corner || all;
        if (group_of(&items[i]) != group || !nth || !matches(window, &items[i]))
            continue;
        if (!shown) {
            ui_line(window->ui, UI_HEADING, ROLE_TEXT, group_names[group]);
            note(window, text_in_arena(&window->arena, "# %s", group_names[group]));
        }
        if (shown++ % in_row == 0)
            ui_row(window->ui, (int)in_row);
        note(window, items[i].name);
        if (rows ? show_lesson(window, &items[i]) : show_item(window, &items[i], i))
            chosen = items[i].path;
    }
    ui_row(window->ui, 1);
    if (group == GROUP_HOUSES && corners && !all)
        show_corners(window, items, count);
    return chosen;
}

/* Shows the files that were opened last; returns the path of the chosen one, or NULL. */
static const char *show_own(Window *window) {
    const char *paths[SETTINGS_RECENT_MOST], *chosen = NULL;
    size_t count = settings_recent(&window->settings, paths), shown = 0;
    for (size_t i = 0; i < count; i++) {
        const char *slash = strrchr(paths[i], '/'), *name = slash ? slash + 1 : paths[i];
        if (*window->field && !strcasestr(name, window->field))
            continue;
        if (!shown++) {
            ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Your files");
            note(window, "# Your files");
        }
        if (ui_list_row(window->ui,
                        &(UiRow){.id = text_in_arena(&window->arena, "own %s", paths[i]),
                                 .shape = ROW_PLAIN,
                                 .cells = {text_in_arena(&window->arena, "%s", name), changed_when(window, paths[i])},
                                 .help = text_in_arena(&window->arena, "%s", paths[i]),
                                 .usable = true}))
            chosen = text_in_arena(&window->arena, "%s", paths[i]);
    }
    return chosen;
}

static void open_item(Window *window, const char *path) {
    const char *kept = text_in_arena(&window->arena, "%s", path);
    dialog_pane_close(window);
    files_leave(window, LEAVE_OPEN, kept);
}

/* Closes the start page over the house that is being edited. */
static void go_on(Window *window) {
    dialog_pane_close(window);
    opening_tab(window, (size_t)(autosave_tab(window) - window->tabs));
}

void dialog_gallery_show(Window *window) {
    size_t count;
    bool news = gallery_update(window->gallery), finds = *window->field;
    window->dirty |= news;
    const GalleryItem *items = gallery_items(window->gallery, &count);
    fill_pictures(window, items, count, news);
    Box box = inner_page(window, 1);
    dialog_pane_begin(window, box);
    window->shown_count = 0;
    int columns = (int)fmax(1, floor(box_width(box) / (ITEM_WIDTH + GAP)));
    const char *chosen = NULL;
    ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT,
            finds                  ? text_in_arena(&window->arena, "Find: %s|", window->field)
            : window->lessons_only ? "Predict, watch, change, explain. Type to find, Return opens, Escape closes."
                                   : "1 2 3 try. Type to find, arrows choose, Return opens, Escape closes.");
    bool goes_on = !finds && !window->lessons_only && show_continue(window);
    if (!finds && !window->lessons_only)
        chosen = show_tries(window, items, count, columns);
    for (int g = 0; g < (window->lessons_only ? GROUP_LESSONS + 1 : GROUPS); g++) {
        const char *one = show_group(window, items, count, (Group)g, columns);
        chosen = chosen ? chosen : one;
    }
    const char *own = window->lessons_only ? NULL : show_own(window);
    if (!window->shown_count)
        ui_text(window->ui, UI_BODY, ROLE_TEXT, "Nothing has this in its name.");
    ui_pane_end(window->ui);
    if (goes_on)
        go_on(window);
    else if (chosen || own)
        open_item(window, chosen ? chosen : own);
}

bool dialog_gallery_type(Window *window, const char *text) {
    size_t used = strlen(window->field), count;
    const GalleryItem *items = gallery_items(window->gallery, &count);
    window->dirty = true;
    if (!used && !window->lessons_only && *text >= '1' && *text < '1' + TRIES) {
        for (size_t i = 0; i < count; i++)
            if (is_try(&items[i], (size_t)(*text - '1'))) {
                open_item(window, items[i].path);
                return true;
            }
    }
    if ((unsigned char)*text < ' ' || (!used && *text == ' ') || used + strlen(text) >= FIND_MOST)
        return false;
    memcpy(window->field + used, text, strlen(text) + 1);
    return true;
}

/* Takes back the last character that was typed, or all; false: nothing is typed. */
static bool erase(Window *window, bool all) {
    size_t used = strlen(window->field);
    if (!used)
        return false;
    do
        used--;
    while (used && (all || (window->field[used] & 0xC0) == 0x80));
    window->field[used] = 0;
    window->dirty = true;
    return true;
}

bool dialog_gallery_key(Window *window, const SdlWindowEvent *event) {
    if (window->dialog != DIALOG_GALLERY || event->mods & (SDL_WINDOW_EVENT_CONTROL | SDL_WINDOW_EVENT_ALT))
        return false;
    bool escapes = event->key == sdl_window_key("Escape");
    if (escapes || event->key == sdl_window_key("Backspace"))
        return erase(window, escapes);
    return event->key == sdl_window_key("Space") && *window->field; /* a character of the name */
}

/* Folders ---------------------------------------------------------------------------------------------------------- */

static const char *kind_label(const FolderEntry *entry) {
    size_t laboratory = entry->format ? laboratory_find(entry->format) : laboratories_count;
    if (entry->kind == FOLDER_FILE && import_file_knows(entry->name))
        return "plan to import";
    if (entry->kind == FOLDER_FILE && entry->format && strcmp(entry->format, "lesson") == 0)
        return "lesson";
    if (entry->kind == FOLDER_FILE)
        return laboratory < laboratories_count ? entry->format : "other";
    return entry->kind == FOLDER_ABOVE ? "folder above" : "folder";
}

/* Enters a folder, or opens a file. */
static void choose(Window *window, const FolderEntry *entry) {
    Fault fault = {0};
    const char *path = text_in_arena(&window->arena, "%s", entry->path);
    if (entry->kind == FOLDER_ABOVE || entry->kind == FOLDER_FOLDER) {
        folder_read(&window->folder, path, import_file_knows, &fault);
        notice_fault(window, &fault, NAN);
        return;
    }
    window->settings.state.folder = settings_store(&window->settings, window->folder.path);
    dialog_pane_close(window);
    files_leave(window, LEAVE_OPEN, path);
}

/* True if the typed text is a path, or the name of a file that is there. */
static bool is_path(const Window *window) {
    return strchr(window->field, '/') || access(window->field, R_OK) == 0;
}

bool dialog_gallery_lists(const Window *window, const FolderEntry *entry) {
    return !*window->field || is_path(window) || strcasestr(entry->name, window->field);
}

/* Returns the first entry that is listed; NULL: none, or nothing is typed. */
static const FolderEntry *first_entry(const Window *window) {
    for (size_t i = 0; *window->field && i < window->folder.count; i++)
        if (dialog_gallery_lists(window, &window->folder.entries[i]))
            return &window->folder.entries[i];
    return NULL;
}

/* Opens the typed file, or enters the typed folder. A path that leads nowhere is told at once, before anybody is asked
 * whether to save. */
static void open_typed(Window *window) {
    struct stat status;
    if (stat(window->field, &status) == 0 && S_ISDIR(status.st_mode)) {
        FolderEntry entry = {.kind = FOLDER_FOLDER, .path = window->field};
        choose(window, &entry);
        *window->field = 0;
        return;
    }
    window->refusal = text_read_refusal(window->field);
    snprintf(window->refused, sizeof window->refused, "%s", window->field);
    if (!window->refusal)
        open_item(window, window->field);
}

void dialog_gallery_show_open(Window *window) {
    Box box = inner_page(window, 3);
    dialog_pane_begin(window, box);
    ui_text(window->ui, UI_HEADING, ROLE_TEXT, "Open or import");
    ui_text(
        window->ui, UI_BODY, ROLE_TEXT,
        "Houses, beams, cranks and lessons (.json) open; plans (.dxf, .wkt, .sh3d, Vadere's .scenario) are imported.");
    ui_text(window->ui, UI_BODY, ROLE_DIM_TEXT, window->folder.path);
    bool typed = ui_field(window->ui, "path", "name or path",
                          "Path: Type a part of a name or a path; Return opens the first one that is listed",
                          window->field, sizeof window->field);
    const FolderEntry *first = first_entry(window);
    if (typed && first && !is_path(window)) {
        choose(window, first);
        *window->field = 0;
    } else if (typed) {
        open_typed(window);
    }
    if (window->refusal && strcmp(window->refused, window->field) == 0)
        ui_text(window->ui, UI_BODY, ROLE_ERROR,
                text_in_arena(&window->arena, "\u26a0 %s cannot be opened: %s", window->refused,
                              text_read_reason(window->refusal)));
    for (size_t i = 0; window->dialog == DIALOG_OPEN && i < window->folder.count; i++) {
        const FolderEntry *entry = &window->folder.entries[i];
        if (!dialog_gallery_lists(window, entry))
            continue;
        UiRow row = {.id = text_in_arena(&window->arena, "entry %zu", i),
                     .shape = ROW_PLAIN,
                     .cells = {entry->name, kind_label(entry)},
                     .usable = true};
        if (ui_list_row(window->ui, &row)) {
            choose(window, entry);
            break;
        }
    }
    ui_pane_end(window->ui);
}
