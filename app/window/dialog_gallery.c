#include "window/dialog_gallery.h"

#include <math.h>
#include <string.h>

#include "laboratory/import_file.h"
#include "window/dialog_pane.h"
#include "window/files.h"
#include "window/notice.h"

/* Design points. */
#define EDGE 24.0
#define ITEM_WIDTH 268.0
#define PICTURE_HEIGHT 150.0
#define TEXT_HEIGHT 78.0
#define GAP 12.0
#define HEAD 44.0

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

/* Shows a card with picture, name and line; true if it was chosen. */
static bool show_item(Window *window, const GalleryItem *item, size_t index) {
    UiCard card = {.id = item->path,
                   .name = item->name,
                   .text = item->fault ? item->fault : item->line,
                   .picture = index < GALLERY_MOST && window->pictures[index].name ? &window->pictures[index] : NULL,
                   .picture_height = PICTURE_HEIGHT,
                   .text_height = TEXT_HEIGHT};
    return ui_card(window->ui, &card);
}

/* Shows the lessons, or everything else, as cards; returns the path of the chosen one, or NULL. */
static const char *show_group(Window *window, const GalleryItem *items, size_t count, bool lessons, int columns) {
    ui_line(window->ui, UI_HEADING, ROLE_TEXT,
            lessons ? "Lessons: predict, watch, change, explain; Escape closes" : "Houses, beams and cranks");
    size_t shown = 0;
    for (size_t i = 0; i < count; i++) {
        if (items[i].lesson != lessons)
            continue;
        if (shown++ % (size_t)columns == 0)
            ui_row(window->ui, columns);
        if (show_item(window, &items[i], i))
            return items[i].path;
    }
    return NULL;
}

void dialog_gallery_show(Window *window) {
    size_t count;
    bool news = gallery_update(window->gallery);
    window->dirty |= news;
    const GalleryItem *items = gallery_items(window->gallery, &count);
    fill_pictures(window, items, count, news);
    Box box = box_expand((Box){{0, 0}, window->frame.page}, -EDGE);
    dialog_pane_begin(window, box);
    int columns = (int)fmax(1, floor(box_width(box) / (ITEM_WIDTH + GAP)));
    const char *chosen = show_group(window, items, count, true, columns);
    if (!chosen && !window->lessons_only)
        chosen = show_group(window, items, count, false, columns);
    ui_pane_end(window->ui);
    if (!chosen)
        return;
    dialog_pane_close(window);
    files_leave(window, LEAVE_OPEN, chosen);
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

void dialog_gallery_show_open(Window *window) {
    Box box = box_expand((Box){{0, 0}, window->frame.page}, -3 * EDGE);
    dialog_pane_begin(window, box);
    ui_line(window->ui, UI_HEADING, ROLE_TEXT, "Open a house, a beam, a crank or a lesson");
    ui_line(window->ui, UI_BODY, ROLE_DIM_TEXT, window->folder.path);
    if (ui_field(window->ui, "path", "or type its path", "Path: Type a path; Return opens it", window->field,
                 sizeof window->field)) {
        const char *path = text_in_arena(&window->arena, "%s", window->field);
        dialog_pane_close(window);
        files_leave(window, LEAVE_OPEN, path);
    }
    for (size_t i = 0; i < window->folder.count; i++) {
        const FolderEntry *entry = &window->folder.entries[i];
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
