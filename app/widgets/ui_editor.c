#include "widgets/ui_editor.h"

#include <string.h>

#include "base/text.h"
#include "widgets/ui_number.h"
#include "widgets/ui_stop.h"

enum { LONGEST = 4096 /* bytes of one line; further input is ignored */ };

#define PADDING 7.0
#define CARET 2.0

/* Text ------------------------------------------------------------------------------------------------------------- */

static size_t before(const char *text, size_t at) {
    while (at > 0 && ((unsigned char)text[--at] & 0xC0) == 0x80)
        continue;
    return at;
}

static size_t behind(const char *text, size_t at) {
    if (text[at])
        at++;
    while (((unsigned char)text[at] & 0xC0) == 0x80)
        at++;
    return at;
}

static bool is_blank(char c) {
    return c == ' ';
}

static size_t word_before(const char *text, size_t at) {
    while (at > 0 && is_blank(text[at - 1]))
        at--;
    while (at > 0 && !is_blank(text[at - 1]))
        at--;
    return at;
}

static size_t word_behind(const char *text, size_t at) {
    while (text[at] && !is_blank(text[at]))
        at++;
    while (text[at] && is_blank(text[at]))
        at++;
    return at;
}

static void set_text(char **target, size_t *capacity, const char *text) {
    size_t bytes = strlen(text) + 1;
    *target = memory_reserve(*target, capacity, bytes, 1);
    memcpy(*target, text, bytes);
}

void ui_editor_open(Ui *ui, UiId id, const char *text) {
    UiEditor *editor = &ui->editor;
    editor->id = id;
    editor->wrong = false;
    set_text(&editor->text, &editor->capacity, text);
    set_text(&editor->original, &editor->original_capacity, text);
    editor->size = editor->caret = strlen(text);
    editor->anchor = 0;
    editor->scroll = 0;
}

void ui_editor_clear(Ui *ui) {
    memory_free(ui->editor.text);
    memory_free(ui->editor.original);
    ui->editor = (UiEditor){0};
}

static void tell(Ui *ui, UiEnd end, const char *text) {
    ui->typed = memory_reserve(ui->typed, &ui->typed_capacity, ui->typed_count + 1, sizeof *ui->typed);
    ui->typed[ui->typed_count++] = (UiTyped){ui->editor.id, end, arena_text(&ui->typed_texts, text)};
}

UiDraft *ui_editor_draft(const Ui *ui, UiId id) {
    for (size_t i = 0; id && i < ui->draft_count; i++)
        if (ui->drafts[i].id == id)
            return &ui->drafts[i];
    return NULL;
}

void ui_editor_drop_draft(Ui *ui, UiId id) {
    UiDraft *draft = ui_editor_draft(ui, id);
    if (!draft)
        return;
    memory_free(draft->text);
    *draft = ui->drafts[--ui->draft_count];
}

static void store_draft(Ui *ui, UiId id, const char *text) {
    ui_editor_drop_draft(ui, id);
    ui->drafts = memory_reserve(ui->drafts, &ui->draft_capacity, ui->draft_count + 1, sizeof *ui->drafts);
    UiDraft *draft = &ui->drafts[ui->draft_count++];
    *draft = (UiDraft){id, text_copy(text)};
}

/* A number that was opened but not changed keeps its hidden digits. */
static void close_number(Ui *ui, const UiStop *stop, UiEnd end) {
    UiEditor *editor = &ui->editor;
    bool changed = strcmp(editor->text, editor->original) != 0 || ui_editor_draft(ui, editor->id);
    char reason[UI_REASON];
    double value;
    bool wrong = end != UI_END_ESCAPED && changed && ui_number_is_wrong(stop->number, editor->text, &value, reason);
    if (wrong && end == UI_END_ENTERED) {
        editor->wrong = true;
        return;
    }
    if (wrong)
        store_draft(ui, editor->id, editor->text);
    else
        ui_editor_drop_draft(ui, editor->id);
    if (!wrong && changed && end != UI_END_ESCAPED)
        tell(ui, end, editor->text);
    editor->id = 0;
}

void ui_editor_close(Ui *ui, UiEnd end) {
    const UiStop *stop = ui_stop_find(ui, ui->editor.id);
    if (stop && stop->number) {
        close_number(ui, stop, end);
        return;
    }
    tell(ui, end, end == UI_END_ESCAPED ? ui->editor.original : ui->editor.text);
    ui->editor.id = 0;
}

const UiTyped *ui_editor_ended(const Ui *ui, UiId id) {
    for (size_t i = ui->typed_count; i-- > 0;)
        if (ui->typed[i].id == id)
            return &ui->typed[i];
    return NULL;
}

/* Editing ---------------------------------------------------------------------------------------------------------- */

static size_t selected_from(const UiEditor *editor) {
    return editor->caret < editor->anchor ? editor->caret : editor->anchor;
}

static size_t selected_to(const UiEditor *editor) {
    return editor->caret < editor->anchor ? editor->anchor : editor->caret;
}

static void remove_part(UiEditor *editor, size_t from, size_t to) {
    memmove(editor->text + from, editor->text + to, editor->size - to + 1);
    editor->size -= to - from;
    editor->caret = editor->anchor = from;
}

/* Returns the bytes of the next code of UTF-8; 0: invalid. */
static size_t code_bytes(const char *text) {
    unsigned char first = (unsigned char)*text;
    size_t bytes = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    for (size_t i = 1; i < bytes; i++)
        if (((unsigned char)text[i] & 0xC0) != 0x80)
            return 0;
    return bytes;
}

/* Inserts text; control characters such as newline become spaces; invalid UTF-8 is dropped. */
static void insert(UiEditor *editor, const char *text) {
    remove_part(editor, selected_from(editor), selected_to(editor));
    while (*text) {
        size_t bytes = code_bytes(text);
        if (!bytes || editor->size + bytes > LONGEST) {
            text++;
            continue;
        }
        editor->text = memory_reserve(editor->text, &editor->capacity, editor->size + bytes + 1, 1);
        memmove(editor->text + editor->caret + bytes, editor->text + editor->caret, editor->size - editor->caret + 1);
        memcpy(editor->text + editor->caret, text, bytes);
        if ((unsigned char)*text < ' ' || *text == 0x7F)
            editor->text[editor->caret] = ' ';
        editor->size += bytes;
        editor->caret += bytes;
        text += bytes;
    }
    editor->anchor = editor->caret;
}

void ui_type(Ui *ui, const char *text) {
    ui_state_stir(ui);
    if (ui->editor.id)
        insert(&ui->editor, text);
}

bool ui_types(const Ui *ui) {
    return ui->editor.id != 0;
}

static void move(UiEditor *editor, size_t to, bool shift) {
    editor->caret = to;
    if (!shift)
        editor->anchor = to;
}

static void copy(Ui *ui) {
    UiEditor *editor = &ui->editor;
    size_t from = selected_from(editor), to = selected_to(editor);
    if (from == to || !ui->clipboard.set)
        return;
    char kept = editor->text[to];
    editor->text[to] = 0;
    ui->clipboard.set(ui->clipboard.context, editor->text + from);
    editor->text[to] = kept;
}

static void erase(UiEditor *editor, UiKey key, bool control) {
    size_t from = selected_from(editor), to = selected_to(editor);
    const char *text = editor->text;
    if (from == to && key == UI_KEY_BACKSPACE)
        from = control ? word_before(text, to) : before(text, to);
    else if (from == to)
        to = control ? word_behind(text, from) : behind(text, from);
    remove_part(editor, from, to);
}

static void move_by_key(UiEditor *editor, UiKey key, bool shift, bool control) {
    const char *text = editor->text;
    bool selects = editor->caret != editor->anchor && !shift && !control;
    if (key == UI_KEY_HOME || key == UI_KEY_END)
        move(editor, key == UI_KEY_HOME ? 0 : editor->size, shift);
    else if (key == UI_KEY_LEFT)
        move(editor,
             selects   ? selected_from(editor)
             : control ? word_before(text, editor->caret)
                       : before(text, editor->caret),
             shift);
    else
        move(editor,
             selects   ? selected_to(editor)
             : control ? word_behind(text, editor->caret)
                       : behind(text, editor->caret),
             shift);
}

void ui_editor_key(Ui *ui, UiKey key, bool shift, bool control) {
    UiEditor *editor = &ui->editor;
    const char *pasted;
    switch (key) {
    case UI_KEY_LEFT:
    case UI_KEY_RIGHT:
    case UI_KEY_HOME:
    case UI_KEY_END:
        move_by_key(editor, key, shift, control);
        break;
    case UI_KEY_BACKSPACE:
    case UI_KEY_DELETE:
        erase(editor, key, control);
        break;
    case UI_KEY_SELECT_ALL:
        editor->anchor = 0;
        editor->caret = editor->size;
        break;
    case UI_KEY_CUT:
    case UI_KEY_COPY:
        copy(ui);
        if (key == UI_KEY_CUT)
            remove_part(editor, selected_from(editor), selected_to(editor));
        break;
    case UI_KEY_PASTE:
        pasted = ui->clipboard.get ? ui->clipboard.get(ui->clipboard.context) : NULL;
        if (pasted)
            insert(editor, pasted);
        break;
    default: /* others are meaningless in one line of text */
        break;
    }
}

/* Drawing ---------------------------------------------------------------------------------------------------------- */

static double width_of(Ui *ui, size_t bytes) {
    return ui_painter_extent(ui->painter, UI_BODY, ui->editor.text, bytes).x;
}

/* Returns the place of the mouse in the text. */
static size_t place_of(Ui *ui, double x) {
    const UiEditor *editor = &ui->editor;
    size_t at = 0;
    while (at < editor->size) {
        size_t next = behind(editor->text, at);
        if ((width_of(ui, at) + width_of(ui, next)) / 2 > x)
            break;
        at = next;
    }
    return at;
}

static void update_caret(Ui *ui, double left, UiTouch touch) {
    UiEditor *editor = &ui->editor;
    if (touch.twice) {
        editor->anchor = 0;
        editor->caret = editor->size;
    } else if (touch.pressed || (touch.held && fabs(ui->moved.x) > 0)) {
        move(editor, place_of(ui, ui->mouse.x - left + editor->scroll), !touch.pressed);
    }
}

void ui_editor_draw(Ui *ui, Box box, UiTouch touch) {
    UiEditor *editor = &ui->editor;
    Box inside = {{box.low.x + PADDING, box.low.y + 3}, {box.high.x - PADDING + CARET, box.high.y - 3}};
    update_caret(ui, inside.low.x, touch);
    double room = box_width(inside) - CARET, caret = width_of(ui, editor->caret), middle = (box.low.y + box.high.y) / 2;
    editor->scroll = real_clamp(editor->scroll, fmax(0, caret - room), caret);
    editor->scroll = fmin(editor->scroll, fmax(0, width_of(ui, editor->size) - room));
    double left = inside.low.x - editor->scroll;
    ui_painter_clip(ui->painter, inside);
    if (editor->caret != editor->anchor) {
        Box chosen = {{left + width_of(ui, selected_from(editor)), inside.low.y},
                      {left + width_of(ui, selected_to(editor)), inside.high.y}};
        ui_painter_box(ui->painter, chosen, ui_state_ink(ui, ROLE_CHAIR, 0.35));
    }
    ui_painter_text(ui->painter, UI_BODY, ui_state_ink(ui, ROLE_TEXT, 1), vec2(left, middle), editor->text,
                    editor->size);
    Box line = {{left + caret, inside.low.y}, {left + caret + CARET, inside.high.y}};
    ui_painter_box(ui->painter, line, ui_state_ink(ui, ROLE_TEXT, 1));
    ui_painter_unclip(ui->painter);
}
