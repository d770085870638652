#include "visual/house/shake_scene.h"

#include <string.h>

#include "plan/plan_geometry.h"
#include "result/census.h"
#include "result/headline.h"
#include "result/names.h"
#include "result/shake.h"
#include "result/source_line.h"
#include "visual/house/house_scene.h"
#include "visual/house/people_scene.h"
#include "visual/house/plan_scene.h"

/* Design points. */
#define PIECE_EDGE 2.0
#define FALL_EDGE 2.0
#define TEXT_SIZE 16.0

/* Weights against being covered by labels. */
#define KEEP_PIECE 2.0
#define KEEP_FALL 0.2

/* 1, shares of shakes above which a piece is a middle and a high danger. */
static const double MIDDLE = 0.05, HIGH = 0.2;

enum { ROWS_MOST = 12 /* of pieces, and of people, in the list */ };

/* Returns the danger of a piece that stops somebody in this share of shakes. */
static Role danger_of(double share) {
    return share >= HIGH ? ROLE_DANGER_HIGH : share >= MIDDLE ? ROLE_DANGER_MIDDLE : ROLE_DANGER_LOW;
}

static const Furniture *piece_of(const ShakeFindings *findings, const ShakePiece *piece) {
    return &findings->house->plan.furniture[piece->index];
}

static const char *name_of(const Furniture *piece) {
    return *piece->name ? piece->name : piece->id;
}

/* Adds the place of the fallen piece, dashed. */
static void add_falls(Scene *scene, const ShakeFindings *findings) {
    for (size_t p = 0; p < findings->piece_count; p++) {
        Furniture lying = *piece_of(findings, &findings->pieces[p]);
        if (lying.toppled || lying.topples == TOPPLE_NO)
            continue;
        lying.toppled = true;
        Vec2 corners[4];
        plan_geometry_corners(&lying, corners);
        Primitive *fall = scene_add_polygon(scene, ROLE_FURNITURE, corners, 4);
        fall->fill_opacity = 0;
        fall->edge = ROLE_FURNITURE_LINE;
        fall->width = FALL_EDGE;
        fall->style = LINE_DASHED;
        fall->keep_clear = KEEP_FALL;
    }
}

static void add_pieces(Scene *scene, const ShakeFindings *findings) {
    for (size_t p = 0; p < findings->piece_count; p++) {
        const ShakePiece *piece = &findings->pieces[p];
        if (!piece->stops.good)
            continue;
        Vec2 corners[4];
        plan_geometry_corners(piece_of(findings, piece), corners);
        Primitive *body = scene_add_polygon(scene, danger_of(piece->stops.value), corners, 4);
        body->edge = ROLE_WALL;
        body->width = PIECE_EDGE;
        body->keep_clear = KEEP_PIECE;
    }
}

static const char *per_cent(Scene *scene, double share) {
    return scene_text(scene, share > 0 && share < 0.01 ? "%.1f %%" : "%.0f %%", 100 * share);
}

static void add_tag(Scene *scene, Role fill, Vec2 at, const char *text) {
    Primitive *tag = scene_add_label(scene, ROLE_TEXT, TEXT_SIZE, at, text);
    tag->fill = fill;
    tag->shape = LABEL_TAG;
    tag->bold = tag->leader = true;
}

static void add_piece_tags(Scene *scene, const ShakeFindings *findings) {
    for (size_t p = 0; p < findings->piece_count && p < ROWS_MOST; p++) {
        const ShakePiece *piece = &findings->pieces[p];
        if (piece->stops.good)
            add_tag(scene, danger_of(piece->stops.value), piece_of(findings, piece)->centre,
                    scene_text(scene, "%s blocks in %s", name_of(piece_of(findings, piece)),
                               per_cent(scene, piece->stops.value)));
    }
}

/* Sets the note of the house before a shake. */
static void add_people(Scene *scene, const House *house) {
    for (size_t i = 0; i < house->person_count; i++)
        people_scene_start(scene, &house->people[i], census_walks(house->people[i].profile) ? ROLE_WALKER : ROLE_CHAIR);
}

/* Returns the letter of a person, as in the other pictures, or the word for a crowd's people. */
static const char *who_of(Scene *scene, const ShakeFindings *findings, const ShakeParty *party) {
    size_t person = 0;
    while (person < findings->house->person_count && strcmp(findings->house->people[person].id, party->id) != 0)
        person++;
    return party->people == 1 && person < findings->house->person_count
               ? names_person(findings->house, person, &scene->arena)
               : names_profile(party->profile);
}

static void add_people_tags(Scene *scene, const ShakeFindings *findings) {
    for (size_t p = 0; p < findings->party_count && p < ROWS_MOST; p++) {
        const ShakeParty *party = &findings->parties[p];
        const char *text =
            scene_text(scene, "%s: out in %zu of %zu", who_of(scene, findings, party), party->out.good, party->out.all);
        add_tag(scene, party->out.good < party->out.all ? ROLE_ERROR : ROLE_PAPER, party->at, text);
    }
}

static const char *value_of(Scene *scene, const ResultTable *table, size_t record, const char *key) {
    const char *value = result_value_and_unit(result_find(table, record, key), &scene->arena);
    return value ? value : "-";
}

static void list_people(Scene *scene, const ShakeFindings *findings) {
    ResultTable people = result_shake_people(findings);
    scene_add_row(scene, ROW_HEADING, "People: out in, median time");
    for (size_t p = 0; p < people.record_count && p < ROWS_MOST; p++) {
        const ShakeParty *party = &findings->parties[p];
        const char *who = who_of(scene, findings, party), *kind = names_profile(party->profile);
        SceneRow *row = scene_add_row(scene, ROW_PLAIN, who == kind ? who : scene_text(scene, "%s, %s", who, kind));
        row->cells[1] = value_of(scene, &people, p, "out.share");
        row->cells[2] = party->out.good ? headline_duration(party->time.median, &scene->arena) : "-";
    }
    result_clear(&people);
}

static void list_pieces(Scene *scene, const ShakeFindings *findings) {
    ResultTable pieces = result_shake_furniture(findings);
    scene_add_row(scene, ROW_HEADING, "Furniture: falls in, blocks in");
    for (size_t p = 0; p < pieces.record_count && p < ROWS_MOST; p++) {
        const ShakePiece *piece = &findings->pieces[p];
        SceneRow *row =
            scene_add_row(scene, piece->stops.good ? ROW_LINE : ROW_PLAIN, name_of(piece_of(findings, piece)));
        row->role = danger_of(piece->stops.value);
        row->symbol = SYMBOL_BOX;
        row->cells[1] = value_of(scene, &pieces, p, "toppled_share");
        row->cells[2] = value_of(scene, &pieces, p, "blocks.share");
    }
    if (!pieces.record_count)
        scene_add_row(scene, ROW_PLAIN, "nothing here can fall");
    result_clear(&pieces);
}

static void list_key(Scene *scene) {
    scene_add_row(scene, ROW_HEADING, "Key");
    SceneRow *row = scene_add_row(scene, ROW_LINE, "where it would fall");
    row->role = ROLE_FURNITURE_LINE;
    row->style = LINE_DASHED;
    row->width = FALL_EDGE;
}

static void format_answer(Scene *scene, const ShakeFindings *findings) {
    const Plan *plan = &findings->house->plan;
    const Share *share = &findings->all_out;
    scene->name = scene_text(scene, "%s, %zu shakes", *plan->name ? plan->name : "house", findings->shakes);
    scene->note = source_line_is_assumed(plan) ? arena_text(&scene->arena, plan->note) : "";
    scene->title = shake_findings_headline(findings, &scene->arena);
    scene->title_role = share->good == share->all ? ROLE_TEXT : ROLE_ERROR;
    const char *times = shake_findings_times(findings, &scene->arena);
    const char *interval = "95 %% confidence: %.0f to %.0f %%", *both = "95 %% confidence: %.0f to %.0f %%; %s";
    scene->detail = times;
    if (share->good < share->all)
        scene->detail = scene_text(scene, *times ? both : interval, 100 * share->low, 100 * share->high, times);
}

void shake_scene_make(Scene *scene, const ShakeFindings *findings) {
    const House *house = findings->house;
    *scene = (Scene){.grid = HOUSE_SCENE_GRID, .top = PLAN_SCENE_CUT};
    scene->box = box_expand(house->outline.box, HOUSE_SCENE_MARGIN);
    format_answer(scene, findings);
    list_people(scene, findings);
    list_pieces(scene, findings);
    list_key(scene);
    plan_scene_solids(scene, house);
    add_pieces(scene, findings);
    add_falls(scene, findings);
    add_people(scene, house);
    plan_scene_tags(scene, house, NULL);
    add_piece_tags(scene, findings);
    add_people_tags(scene, findings);
    plan_scene_names(scene, house);
}
