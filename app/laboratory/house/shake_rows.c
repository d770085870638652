#include "laboratory/house/shake_rows.h"

#include <inttypes.h>

#include "base/text.h"
#include "laboratory/house/rows.h"
#include "laboratory/house/runs.h"
#include "result/names.h"
#include "visual/house/people_scene.h"

enum { PIECES_MOST = 6 /* that are listed */ };

static const char *name_of(HouseSession *session, Item item) {
    char name[HOUSE_ITEM_NAME];
    house_item_name(&session->runs[RUN_SHOWN]->house, session->observation, item, name, sizeof name);
    return arena_text(&session->texts.moment.arena, name);
}

static Item item_of(const HouseSession *session, const char *id) {
    return house_item_find(&session->runs[RUN_SHOWN]->house, HOUSE_FURNITURE, id);
}

static void add_button(HouseSession *session, RowAct act, const char *label, const char *help) {
    PanelRow *row = house_rows_add(session, ROW_PLAIN, label);
    row->act = act;
    row->help = help;
}

static void add_this(HouseSession *session, const EditorShake *shake) {
    Arena *arena = &session->texts.moment.arena;
    PanelRow *heading = house_rows_add(session, ROW_HEADING, "This shake");
    heading->row.cells[1] = text_in_arena(arena, "shake %" PRIu64, shake->seed);
    const char *fallen = "Nothing fell.";
    for (size_t k = 0; k < shake->count; k++)
        fallen = text_in_arena(arena, "%s%s%s", k ? fallen : "Fallen: ", k ? ", " : "",
                               name_of(session, item_of(session, shake->ids[k])));
    house_rows_add(session, ROW_PLAIN, shake->count ? text_in_arena(arena, "%s.", fallen) : fallen);
    add_button(session, ROW_ACT_SHAKE, "Another shake",
               "Another shake (Shift+T): Shake the house as it stood before, other pieces fall");
    if (shake->count)
        add_button(session, ROW_ACT_STAND_UP, "Stand up", "Stand up: Put what fell back where it stood");
}

/* Adds how often each person leaves, who are few. */
static void add_people(HouseSession *session, const Outlook *outlook) {
    Arena *arena = &session->texts.moment.arena;
    const House *house = &session->runs[RUN_SHOWN]->house;
    for (size_t p = 0; p < outlook->person_count; p++) {
        size_t person = house_find_person(house, outlook->people[p].id);
        bool known = person < house->person_count;
        LocusLook look = known ? people_scene_look(house, person) : (LocusLook){.role = ROLE_DIM_TEXT};
        PanelRow *row = house_rows_add(session, known ? ROW_LINE : ROW_PLAIN, known ? "" : outlook->people[p].id);
        row->row.role = look.role;
        row->row.style = look.style;
        row->row.mark = known ? names_person(house, person, arena) : NULL;
        row->row.cells[1] = text_in_arena(arena, "%zu of %zu", outlook->people[p].out, outlook->shakes);
        row->has_bar = true;
        row->bar = (double)outlook->people[p].out / (double)outlook->shakes;
        row->item = known ? (Item){HOUSE_PERSON, person} : row->item;
    }
}

static void add_many(HouseSession *session, const Outlook *outlook) {
    Arena *arena = &session->texts.moment.arena;
    PanelRow *heading = house_rows_add(session, ROW_HEADING, text_in_arena(arena, "In %d shakes", OUTLOOK_SHAKES));
    heading->advice = true;
    if (!outlook) {
        heading->row.cells[1] = "being worked out";
        house_rows_add(session, ROW_PLAIN, "They are being worked out.");
        return;
    }
    heading->row.cells[1] = text_in_arena(arena, "all out in %zu", outlook->all_out);
    add_people(session, outlook);
    if (outlook->person_count > 1)
        house_rows_add(session, ROW_PLAIN, "all of them")->row.cells[1] =
            text_in_arena(arena, "%zu of %zu", outlook->all_out, outlook->shakes);
    house_rows_add(session, ROW_PLAIN,
                   outlook->shakes < OUTLOOK_SHAKES
                       ? text_in_arena(arena, "How often each gets out, in the first %zu.", outlook->shakes)
                       : "How often each gets out.");
}

/* Returns the piece that a button offers to fix: the selected one, or the one that stops people most often; NULL: none
 * stops anybody. */
static const OutlookPiece *piece_to_fix(const HouseSession *session, const Outlook *outlook) {
    for (size_t f = 0; f < outlook->piece_count; f++)
        if (item_same(item_of(session, outlook->pieces[f].id), session->selected))
            return &outlook->pieces[f];
    return outlook->piece_count && outlook->pieces[0].stops ? &outlook->pieces[0] : NULL;
}

static void add_pieces(HouseSession *session, const Outlook *outlook) {
    Arena *arena = &session->texts.moment.arena;
    const OutlookPiece *fixed = piece_to_fix(session, outlook);
    PanelRow *heading = house_rows_add(session, ROW_HEADING, HOUSE_FIX_HEADING);
    heading->advice = true;
    heading->row.cells[1] = fixed ? name_of(session, item_of(session, fixed->id)) : "nothing";
    for (size_t f = 0; f < outlook->piece_count && f < PIECES_MOST; f++) {
        Item item = item_of(session, outlook->pieces[f].id);
        PanelRow *row = house_rows_add(session, ROW_PLAIN, name_of(session, item));
        row->row.cells[1] = text_in_arena(arena, "fell %zu", outlook->pieces[f].fell);
        row->row.cells[2] = text_in_arena(arena, "blocks %zu", outlook->pieces[f].stops);
        row->item = item;
    }
    if (!fixed) {
        house_rows_add(session, ROW_PLAIN, "Nothing that falls stops anybody.");
        return;
    }
    Item item = item_of(session, fixed->id);
    const char *label = text_in_arena(arena, "Fix the %s", name_of(session, item));
    add_button(session, ROW_ACT_FIX, label,
               text_in_arena(arena, "%s: Fix it to the wall, where it stands and never falls; Undo reverts it", label));
    session->texts.rows[session->texts.row_count - 1].item = item;
}

void house_shake_rows_add(HouseSession *session) {
    EditorShake shake;
    if (!house_runs_wants(session, RUN_SHAKES) || !editor_last_shake(session->editor, &shake) ||
        draft_revision(session->draft) != house_run_revision(session->runs[RUN_SHOWN]))
        return;
    const Outlook *outlook = shake.standing == session->standing ? session->outlook : NULL;
    add_this(session, &shake);
    add_many(session, outlook);
    if (outlook)
        add_pieces(session, outlook);
}
