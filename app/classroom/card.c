#include "classroom/card.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/text.h"
#include "classroom/dots.h"
#include "classroom/hands.h"
#include "lesson/words.h"

/* Design points. */
#define EDGE 12.0
#define LABEL_PAD 20.0 /* beside the label of a button */
#define GAP 7.0
#define FOOT 36.0   /* height of the buttons */
#define DIGIT 28.0  /* width of the box with an option's number */
#define STRIP 15.0  /* height of the bar of a vote */
#define MARK 24.0   /* width of a tick or cross */
#define SPACING 1.1 /* height of a line, times that of its letters */
#define FOLD 30.0   /* width of the button that folds it */
#define BESIDE 0.5  /* of an option's width: shorter words leave room for the bars beside them */

enum { LINES_MOST = 24, SIZES = 3, TRIES = 5 };

/* A text is set in the first size in which all of the card fits. */
typedef enum CardText { CARD_TEXT, CARD_ASK } CardText;
static const UiTextStyle styles[SIZES][2] = {{UI_DETAIL, UI_CLOCK}, {UI_DETAIL, UI_HEADING}, {UI_BODY, UI_BOLD}};

/* Small letters only where leaving something out does not do. */
static const struct {
    int size;
    bool whole;
} tries[TRIES] = {{0, true}, {0, false}, {1, true}, {1, false}, {2, false}};

typedef struct Card {
    Ui *ui;
    const Play *play;
    const LessonStep *step;
    const PlayStep *shown;
    Arena *arena;
    Box box;    /* inside the edges */
    double y;   /* of the next line */
    int size;   /* of `styles` */
    bool whole; /* with remarks, the guesses behind the result, conditions that hold, earlier hints */
    bool draws; /* otherwise it is only measured */
    bool roomy; /* below the text there is room for a button */
    CardLook look;
    CardPress press;
} Card;

/* Text ------------------------------------------------------------------------------------------------------------- */

static double line_height(const Card *card, UiTextStyle style) {
    return SPACING * ui_extent(card->ui, style, "x").y;
}

/* True if the blank between two parts of a text keeps a number and its unit together, "1 %", "0.63 m". */
static bool binds_unit(const char *text, size_t blank) {
    static const char *const units[] = {"%", "m", "cm", "mm", "s", "N", "Hz"};
    if (!blank || text[blank - 1] < '0' || text[blank - 1] > '9')
        return false;
    const char *word = text + blank + 1;
    size_t length = strcspn(word, " .,;:?!)");
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strlen(units[i]) == length && strncmp(units[i], word, length) == 0)
            return true;
    return false;
}

/* Returns the bytes of the text that fit into the width, up to a blank; at least one word. */
static size_t fitting(const Card *card, UiTextStyle style, const char *text, double width) {
    size_t good = 0, length = strlen(text);
    for (size_t at = 0; at <= length; at++) {
        if (at < length && (text[at] != ' ' || binds_unit(text, at)))
            continue;
        const char *part = text_in_arena(card->arena, "%.*s", (int)at, text);
        if (good && ui_extent(card->ui, style, part).x > width)
            break;
        good = at;
    }
    return good;
}

/* Adds wrapped text from `left` on, and returns its height. */
static double add_wrapped(Card *card, UiTextStyle style, Role role, double left, double right, double top,
                          const char *text) {
    double height = line_height(card, style), y = top;
    for (int lines = 0; *text && lines < LINES_MOST; lines++) {
        size_t length = fitting(card, style, text, right - left);
        if (card->draws)
            ui_draw_text(card->ui, style, role, vec2(left, y + height / 2), 0,
                         text_in_arena(card->arena, "%.*s", (int)length, text));
        text += length;
        text += *text == ' ';
        y += height;
    }
    return y - top;
}

static void add_text(Card *card, CardText kind, Role role, const char *text) {
    if (!*text)
        return;
    const char *filled = words_fill(&card->play->lesson, text, card->arena);
    card->y += add_wrapped(card, styles[card->size][kind], role, card->box.low.x, card->box.high.x, card->y, filled);
    card->y += GAP;
}

/* Adds a line with a tick or a cross before it: the mark and the words say the same, so that no colour has to. */
static void add_marked(Card *card, CardText kind, bool good, const char *text) {
    UiTextStyle style = styles[card->size][kind];
    Role role = good ? ROLE_EXIT_TAG : ROLE_ERROR;
    if (card->draws)
        ui_draw_text(card->ui, style, role, vec2(card->box.low.x, card->y + line_height(card, style) / 2), 0,
                     good ? "\u2713" : "\u2717");
    card->y += add_wrapped(card, style, kind == CARD_ASK ? role : ROLE_TEXT, card->box.low.x + MARK, card->box.high.x,
                           card->y, text);
    card->y += GAP / 2;
}

/* Options ---------------------------------------------------------------------------------------------------------- */

/* Returns what stands at the end of an option: a tick or a cross once it is known; "" before. */
static const char *option_mark(const Card *card, size_t option) {
    if (card->step->kind != LESSON_OBSERVE || !card->shown->chosen || !card->step->truth)
        return "";
    if ((int)option + 1 == card->step->truth && card->shown->chosen == card->step->truth)
        return "\u2713";
    return (int)option + 1 == card->shown->chosen ? "\u2717" : "";
}

static void press_option(Card *card, size_t option, Box box) {
    bool counts = card->step->kind == LESSON_PREDICT;
    UiButton button = {.id = text_in_arena(card->arena, "option %zu", option + 1),
                       .label = "",
                       .help = text_in_arena(card->arena,
                                             counts ? "%s (%zu): Count one more hand for it" : "%s (%zu): Answer it",
                                             card->step->options.at[option], option + 1)};
    ui_at(card->ui, box);
    if (ui_button(card->ui, &button))
        card->press = (CardPress){.pressed = true, .key = PLAY_DIGIT, .digit = (int)option + 1};
}

/* True if every option is short enough for its bars to stand beside it. */
static bool has_bars_beside(const Card *card, UiTextStyle style) {
    double room = BESIDE * (box_width(card->box) - DIGIT - GAP) - 2 * GAP;
    for (size_t o = 0; o < card->step->options.count; o++) {
        const char *text = words_fill(&card->play->lesson, card->step->options.at[o], card->arena);
        if (ui_extent(card->ui, style, text).x > room)
            return false;
    }
    return true;
}

static void add_option(Card *card, size_t option) {
    UiTextStyle style = styles[card->size][CARD_TEXT];
    int votes = card->step->kind == LESSON_PREDICT ? card->shown->vote + 1 : 0;
    bool beside = votes && has_bars_beside(card, style);
    const char *text = words_fill(&card->play->lesson, card->step->options.at[option], card->arena);
    const char *mark = option_mark(card, option);
    double left = card->box.low.x + DIGIT + GAP, right = card->box.high.x - GAP - (*mark ? MARK : 0);
    bool draws = card->draws;
    card->draws = false;
    double lines = add_wrapped(card, style, ROLE_TEXT, left, right, card->y, text);
    card->draws = draws;
    double height = lines + (votes && !beside ? STRIP : 0) + GAP;
    Box box = {{card->box.low.x, card->y}, {card->box.high.x, card->y + height}};
    if (draws) {
        press_option(card, option, box);
        double middle = card->y + GAP / 2 + line_height(card, style) / 2;
        ui_draw_text(card->ui, UI_CLOCK, ROLE_TEXT, vec2(card->box.low.x + (DIGIT + GAP) / 2, middle), 0.5,
                     text_in_arena(card->arena, "%zu", option + 1));
        add_wrapped(card, style, ROLE_TEXT, left, right, card->y + GAP / 2, text);
        if (*mark)
            ui_draw_text(card->ui, UI_CLOCK, strcmp(mark, "\u2713") == 0 ? ROLE_EXIT_TAG : ROLE_ERROR,
                         vec2(card->box.high.x - GAP, middle), 1, mark);
        for (int vote = 0; vote < votes; vote++) {
            double from = beside ? left + BESIDE * (right - left) + GAP : left, width = (right - from + GAP) / votes;
            double top = beside ? middle - STRIP / 2 : card->y + lines + GAP / 2;
            hands_draw(card->ui, card->shown, vote, option,
                       (Box){{from + vote * width, top + 2}, {from + (vote + 1) * width - GAP, top + STRIP - 2}},
                       card->arena);
        }
    }
    card->y += height + GAP / 2;
}

/* Adds a button as wide as the card. */
static void add_button(Card *card, const char *id, const char *label, const char *help, CardPress press) {
    ui_at(card->ui, (Box){{card->box.low.x, card->y}, {card->box.high.x, card->y + FOOT}});
    if (card->draws && ui_button(card->ui, &(UiButton){.id = id, .label = label, .help = help}))
        card->press = press;
    card->y += FOOT + GAP;
}

/* Adds the dots of guesses that are numbers; `tells`: with the answer. */
static void add_dots(Card *card, const LessonStep *asked, const PlayStep *guesses, bool tells) {
    double height = dots_height(guesses);
    if (card->draws)
        dots_draw(card->ui, asked, guesses, (Box){{card->box.low.x, card->y}, {card->box.high.x, card->y + height}},
                  tells, card->arena);
    card->y += height + GAP;
}

/* Adds what is typed, the guesses so far, and the button that takes one back. */
static void add_number_guess(Card *card) {
    const PlayStep *shown = card->shown;
    int count = play_hands(shown, shown->vote);
    const char *unit = strcmp(card->step->unit, "1") == 0 ? "" : card->step->unit;
    const char *typed = text_in_arena(card->arena, "%s_ %s", shown->typed, unit);
    card->y += add_wrapped(card, UI_CLOCK, ROLE_TEXT, card->box.low.x, card->box.high.x, card->y, typed);
    if (card->whole)
        card->y += add_wrapped(card, UI_BODY, ROLE_DIM_TEXT, card->box.low.x, card->box.high.x, card->y,
                               "Type a guess, then Return");
    card->y += GAP;
    add_dots(card, card->step, shown, false);
    if (count && card->whole)
        add_button(card, "undo",
                   text_in_arena(card->arena, "%s%d %s; take one back", shown->vote ? "Second vote: " : "", count,
                                 count == 1 ? "guess" : "guesses"),
                   "Take back (Backspace): The last guess", (CardPress){.pressed = true, .key = PLAY_UNDO});
}

static void add_options(Card *card) {
    for (size_t o = 0; o < card->step->options.count; o++)
        add_option(card, o);
    card->y += GAP / 2;
    if (*card->step->unit)
        add_number_guess(card);
    if (card->step->kind != LESSON_PREDICT || *card->step->unit)
        return;
    int hands = play_hands(card->shown, card->shown->vote);
    const char *vote = card->shown->vote ? "Second vote: " : "";
    const char *words = hands ? text_in_arena(card->arena, "%s%d %s; take one back%s", vote, hands,
                                              hands == 1 ? "hand" : "hands", *vote ? "" : " (Backspace)")
                              : text_in_arena(card->arena, "%sa number key counts a raised hand", vote);
    if (card->whole && hands)
        add_button(card, "undo", words, "Take back (Backspace): One hand less for the last option",
                   (CardPress){.pressed = true, .key = PLAY_UNDO});
    else if (card->whole)
        card->y += add_wrapped(card, UI_BODY, ROLE_DIM_TEXT, card->box.low.x, card->box.high.x, card->y, words) + GAP;
}

/* Says whether the answer after watching is right, and how the class had guessed. */
static void add_verdict(Card *card) {
    int chosen = card->shown->chosen, truth = card->step->truth;
    if (card->step->kind != LESSON_OBSERVE || !chosen || !truth)
        return;
    bool good = chosen == truth;
    const LessonTexts *wrong = &card->step->wrong;
    const char *words = good                                                       ? "Yes."
                        : (size_t)chosen <= wrong->count && *wrong->at[chosen - 1] ? wrong->at[chosen - 1]
                                                                                   : "Not so. Look again.";
    add_marked(card, CARD_ASK, good, words_fill(&card->play->lesson, words, card->arena));
}

/* Lays the result over the guesses of the class. */
static void add_guesses(Card *card) {
    size_t at = play_guessed(card->play);
    const LessonStep *asked = at == SIZE_MAX ? NULL : &card->play->lesson.steps[at];
    const PlayStep *guesses = asked ? &card->play->steps[at] : NULL;
    bool compares = card->step->kind == LESSON_COMPARE;
    if (!guesses || (*asked->unit && !compares) || (!*asked->unit && !asked->truth) ||
        (!compares && (!play_hands(guesses, 0) || !card->whole)))
        return; /* a number is often found by a task only, and told later */
    double height = line_height(card, UI_BODY);
    const char *answer = *asked->unit
                             ? words_value(asked->answer, -1, asked->unit, card->arena)
                             : text_in_arena(card->arena, "\u201c%s\u201d", asked->options.at[asked->truth - 1]);
    card->y += GAP;
    card->y += add_wrapped(card, UI_BOLD, ROLE_TEXT, card->box.low.x, card->box.high.x, card->y,
                           text_in_arena(card->arena, "Your guesses: it was %s", answer));
    if (*asked->unit)
        add_dots(card, asked, guesses, true);
    for (size_t o = 0; o < asked->options.count; o++, card->y += height) {
        if (!card->draws)
            continue;
        bool true_one = (int)o + 1 == asked->truth;
        double middle = card->y + height / 2, left = card->box.low.x + DIGIT + GAP;
        ui_draw_text(card->ui, UI_BOLD, ROLE_TEXT, vec2(card->box.low.x, middle), 0,
                     text_in_arena(card->arena, "%zu%s", o + 1, true_one ? " \u2713" : ""));
        hands_draw(card->ui, guesses, guesses->vote, o,
                   (Box){{left, card->y + 2}, {card->box.high.x, card->y + height - 2}}, card->arena);
    }
    card->y += GAP;
}

/* A task ----------------------------------------------------------------------------------------------------------- */

static void add_goal(Card *card) {
    PlayGoal goal = card->shown->goal;
    if (!card->step->goal_count)
        return;
    if (card->look.working || goal == PLAY_GOAL_OPEN) {
        card->y += add_wrapped(card, styles[card->size][CARD_ASK], ROLE_DIM_TEXT, card->box.low.x, card->box.high.x,
                               card->y, "\u2026 being worked out") +
                   GAP;
        return;
    }
    add_marked(card, CARD_ASK, goal == PLAY_GOAL_YES, goal == PLAY_GOAL_YES ? "Goal reached" : "Not yet");
    if (goal == PLAY_GOAL_YES) {
        add_text(card, CARD_TEXT, ROLE_TEXT, card->step->done);
        return;
    }
    for (size_t g = 0; g < card->step->goal_count; g++) {
        const Condition *condition = &card->step->goals[g].condition;
        if (condition->verdict == VERDICT_PASSED && !card->whole)
            continue;
        add_marked(card, CARD_TEXT, condition->verdict == VERDICT_PASSED,
                   words_goal(&card->step->goals[g], card->arena));
    }
}

static void add_hints(Card *card) {
    int first = !card->whole && card->shown->hints > 0 ? card->shown->hints - 1 : 0;
    if (card->shown->goal == PLAY_GOAL_YES)
        return;
    for (int h = first; h < card->shown->hints; h++)
        add_text(card, CARD_TEXT, ROLE_TEXT, text_in_arena(card->arena, "Hint %d: %s", h + 1, card->step->hints.at[h]));
}

/* The card --------------------------------------------------------------------------------------------------------- */

static const char *place_words(const Card *card) {
    return text_in_arena(card->arena, "%zu of %zu", card->play->step + 1, card->play->lesson.step_count);
}

static void show_fold(Card *card, Box box, const char *label, const char *help) {
    ui_at(card->ui, box);
    if (ui_button(card->ui, &(UiButton){.id = "fold", .label = label, .help = help}))
        card->press = (CardPress){.folds = true};
}

/* Shows the button that starts a step again in which something plays or is changed; returns its left edge. */
static double show_restart(Card *card, Box box) {
    if (!play_restarts(card->play))
        return box.high.x;
    ui_at(card->ui, box);
    if (ui_button(card->ui, &(UiButton){.id = "restart",
                                        .label = "\u21ba",
                                        .help = "Start this step again (Ctrl+R): All as the step began; guesses and "
                                                "hints stay"}))
        card->press = (CardPress){.restarts = true};
    return box.low.x - GAP;
}

static const char numbers_help[] = "Numbers (Return): Show the numbers to change them";

/* Shows the button for numbers as a small one, where a wide one has no room; returns its left edge. */
static double show_numbers(Card *card, Box box) {
    if (!card->look.numbers || card->roomy)
        return box.high.x;
    ui_at(card->ui, box);
    if (ui_button(card->ui, &(UiButton){.id = "numbers", .label = "\u270e", .help = numbers_help}))
        card->press = (CardPress){.numbers = true};
    return box.low.x - GAP;
}

static void add_head(Card *card) {
    double height = line_height(card, UI_HEADING), y = card->y + height / 2, right = card->box.high.x;
    if (card->draws) {
        Box last = {{right - FOLD, card->y - GAP / 2}, {right, card->y + height + GAP / 2}};
        show_fold(card, last, "\u25be", "Fold (C): Make the card one line; guesses and hints stay");
        right = last.low.x - GAP;
        right = show_restart(card, (Box){{right - FOLD, last.low.y}, {right, last.high.y}});
        right = show_numbers(card, (Box){{right - FOLD, last.low.y}, {right, last.high.y}});
        ui_draw_text(card->ui, UI_HEADING, ROLE_CHAIR, vec2(card->box.low.x, y), 0,
                     lesson_kind_title((LessonKind)card->step->kind));
        ui_draw_text(card->ui, UI_BODY, ROLE_DIM_TEXT, vec2(right, y), 1, place_words(card));
    }
    card->y += height + GAP;
}

static void add_body(Card *card) {
    const LessonStep *step = card->step;
    card->y = card->box.low.y;
    add_head(card);
    if (card->play->step == 0)
        add_text(card, CARD_ASK, ROLE_TEXT, card->play->lesson.title);
    add_text(card, CARD_TEXT, ROLE_TEXT, step->text);
    add_text(card, CARD_ASK, ROLE_TEXT, card->look.headline ? "" : step->ask);
    add_options(card);
    add_verdict(card);
    bool seen = step->kind == LESSON_OBSERVE && card->shown->chosen == step->truth;
    if (step->kind == LESSON_COMPARE || seen)
        add_guesses(card);
    add_goal(card);
    add_hints(card);
    if (card->shown->model)
        add_text(card, CARD_TEXT, ROLE_TEXT, step->model);
}

/* Returns the words of the button that goes on. */
static const char *next_words(const Card *card) {
    const Play *play = card->play;
    if (play->step + 1 == play->lesson.step_count)
        return "End";
    if (card->step->kind == LESSON_EXPLAIN && !card->shown->model && *card->step->model)
        return "An answer";
    return play->lesson.steps[play->step + 1].kind == LESSON_OBSERVE ? "Watch" : "On";
}

typedef struct FootButton {
    const char *label, *help;
    CardPress press;
    bool usable, first;
} FootButton;

/* Returns a label, or a shorter one where it does not fit into a button. */
static const char *label_in(const Card *card, double width, const char *label, const char *shorter) {
    return ui_extent(card->ui, UI_BODY, label).x + LABEL_PAD <= width ? label : shorter;
}

static void show_foot(Card *card, Box pane) {
    const LessonStep *step = card->step;
    enum { BUTTONS = 3 };
    double widths[BUTTONS] = {0.14, 0.45, 0.41}, left = card->box.low.x, whole = box_width(card->box);
    double room = widths[1] * whole - GAP;
    const char *hint = text_in_arena(
        card->arena, "Hint %d of %zu (?)",
        card->shown->hints < (int)step->hints.count ? card->shown->hints + 1 : card->shown->hints, step->hints.count);
    hint = label_in(card, room, hint, "Hint (?)");
    const char *vote =
        *step->unit ? label_in(card, room, "Vote again", "Again") : label_in(card, room, "Vote again (0)", "Again (0)");
    bool predicts = step->kind == LESSON_PREDICT;
    bool last = card->play->step + 1 == card->play->lesson.step_count;
    const FootButton buttons[BUTTONS] = {
        {"\u25c0",
         "Back (PgUp): The step before, as it was left",
         {.pressed = true, .key = PLAY_BACK},
         card->play->step > 0,
         false},
        {predicts ? vote : hint,
         predicts ? (*step->unit ? "Vote again: The class has talked and votes once more"
                                 : "Vote again (0): The class has talked and votes once more")
                  : "Hint (?): The next of three hints",
         {.pressed = true, .key = predicts ? PLAY_VOTE : PLAY_HINT},
         predicts ? !card->shown->vote && play_hands(card->shown, 0) > 0 : card->shown->hints < (int)step->hints.count,
         false},
        {text_in_arena(card->arena, "%s \u25b6", next_words(card)),
         "On (PgDn): The next step",
         {.pressed = true, .leaves = last, .key = PLAY_NEXT},
         true,
         true},
    };
    for (int b = 0; b < BUTTONS; b++) {
        const FootButton *row = &buttons[b];
        double right = left + widths[b] * whole - (b + 1 < BUTTONS ? GAP : 0);
        bool there = b != 1 || predicts || step->hints.count;
        ui_at(card->ui, (Box){{left, pane.high.y - EDGE - FOOT}, {right, pane.high.y - EDGE}});
        UiButton button = {.id = text_in_arena(card->arena, "foot %d", b),
                           .label = row->label,
                           .help = row->help,
                           .chosen = row->first,
                           .disabled = !row->usable};
        if (there && ui_button(card->ui, &button))
            card->press = row->press;
        left += widths[b] * whole;
    }
}

/* A folded card -------------------------------------------------------------------------------------------------- */

/* Returns what the line says of the step: the hands, the verdict, or its question; shorter words come later. */
static const char *line_words(const Card *card, int shorter) {
    const PlayStep *shown = card->shown;
    const LessonStep *step = card->step;
    const char *words = "";
    if (step->kind == LESSON_PREDICT) {
        const char *before = shown->vote ? "second vote, " : "";
        words = *step->unit ? text_in_arena(card->arena, "%sguesses: %d", before, shown->number_count[shown->vote])
                            : text_in_arena(card->arena, "%shands", before);
        for (size_t o = 0; o < step->options.count; o++)
            words =
                text_in_arena(card->arena, "%s%s %zu: %d", words, o ? "," : "", o + 1, shown->hands[shown->vote][o]);
    } else if (step->goal_count) {
        words = card->look.working || shown->goal == PLAY_GOAL_OPEN ? "\u2026 being worked out"
                : shown->goal == PLAY_GOAL_YES                      ? "\u2713 Goal reached"
                                                                    : "\u2717 Not yet";
    }
    const char *asks = *step->ask ? step->ask : step->text;
    if (shorter == 0)
        return text_in_arena(card->arena, "%s%s%s", words_fill(&card->play->lesson, asks, card->arena),
                             *words ? "   " : "", words);
    return words;
}

/* Returns the left edge of the buttons of the line. */
static double show_line_buttons(Card *card, Box box) {
    static const char *const labels[] = {"\u25c0", "\u25b4", NULL};
    static const double widths[] = {44, 44, 150};
    enum { BUTTONS = 3 };
    const char *next = text_in_arena(card->arena, "%s \u25b6", next_words(card));
    double left = box.high.x;
    for (int b = 0; b < BUTTONS; b++)
        left -= widths[b] + GAP;
    double x = left + GAP;
    for (int b = 0; b < BUTTONS; b++) {
        Box place = {{x, box.low.y}, {x + widths[b], box.high.y}};
        x += widths[b] + GAP;
        if (b == 1) {
            show_fold(card, place, labels[b], "Unfold (C): Show the whole card");
            continue;
        }
        UiButton button = {.id = text_in_arena(card->arena, "foot %d", b),
                           .label = labels[b] ? labels[b] : next,
                           .help = b ? "On (PgDn): The next step" : "Back (PgUp): The step before, as it was left",
                           .chosen = b > 0,
                           .disabled = b == 0 && card->play->step == 0};
        ui_at(card->ui, place);
        if (ui_button(card->ui, &button))
            card->press = b ? (CardPress){.pressed = true,
                                          .leaves = card->play->step + 1 == card->play->lesson.step_count,
                                          .key = PLAY_NEXT}
                            : (CardPress){.pressed = true, .key = PLAY_BACK};
    }
    return left;
}

static void show_line(Card *card, Box box) {
    double y = (box.low.y + box.high.y) / 2, left = box.low.x;
    double right = show_line_buttons(card, box) - GAP;
    const char *title = lesson_kind_title((LessonKind)card->step->kind), *place = place_words(card);
    ui_draw_text(card->ui, UI_HEADING, ROLE_CHAIR, vec2(left, y), 0, title);
    left += ui_extent(card->ui, UI_HEADING, title).x + 2 * GAP;
    ui_draw_text(card->ui, UI_BODY, ROLE_DIM_TEXT, vec2(left, y), 0, place);
    left += ui_extent(card->ui, UI_BODY, place).x + 2 * GAP;
    static const UiTextStyle fits[] = {UI_DETAIL, UI_BODY};
    for (int shorter = 0; shorter < 2; shorter++)
        for (size_t s = 0; s < sizeof fits / sizeof *fits; s++) {
            const char *words = line_words(card, shorter);
            if (left + ui_extent(card->ui, fits[s], words).x > right)
                continue;
            ui_draw_text(card->ui, fits[s], ROLE_TEXT, vec2(left, y), 0, words);
            return;
        }
}

/* Sets the text in the first size in which all of it fits, and the most important of it in the last; true if it fits.
 */
static bool set_text(Card *card) {
    for (int t = 0; t < TRIES; t++) {
        card->size = tries[t].size;
        card->whole = tries[t].whole;
        add_body(card);
        if (card->y <= card->box.high.y)
            return true;
    }
    return false;
}

/* Shows what does not fit above the buttons in a pane of its own that scrolls. */
static void show_scrolled(Card *card, Box box) {
    ui_pane_begin(card->ui, &(UiPane){.name = "lesson text", .box = box, .ground = ROLE_PANEL, .scrolls = true});
    Box inside = ui_space(card->ui, 0);
    card->box = (Box){{card->box.low.x, inside.low.y}, {inside.high.x, HUGE_VAL}};
    add_body(card);
    ui_gap(card->ui, card->y - inside.low.y);
    ui_pane_end(card->ui);
}

CardPress card_show(Ui *ui, const Play *play, Box box, const CardLook *look, Arena *arena) {
    Card card = {.ui = ui,
                 .play = play,
                 .step = play_step(play),
                 .shown = &play->steps[play->step],
                 .arena = arena,
                 .box = box_expand(box, -EDGE),
                 .look = *look};
    if (look->folded) {
        ui_pane_begin(ui, &(UiPane){.name = "lesson", .box = box, .ground = ROLE_PANEL});
        show_line(&card, (Box){vec2(box.low.x + EDGE, box.low.y + GAP), vec2(box.high.x - EDGE, box.high.y - GAP)});
        ui_pane_end(ui);
        return card.press;
    }
    card.box.high.y -= FOOT + GAP;
    bool fits = set_text(&card);
    card.roomy = card.y + FOOT + GAP <= card.box.high.y;
    card.draws = true;
    ui_pane_begin(ui, &(UiPane){.name = "lesson", .box = box, .ground = ROLE_PANEL});
    show_foot(&card, box);
    if (fits) {
        add_body(&card);
        if (look->numbers && card.roomy)
            add_button(&card, "numbers", look->numbers, numbers_help, (CardPress){.numbers = true});
    }
    ui_pane_end(ui);
    if (!fits)
        show_scrolled(&card, (Box){box.low, {box.high.x, card.box.high.y}});
    return card.press;
}
