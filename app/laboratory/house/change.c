/* What a person does to a house at work, besides editing it: as in Laboratory, with a HouseSession as `live`. */
#include <stdio.h>

#include "base/parameters_number.h"
#include "plan/draft_file.h"
#include "plan/draft_parameter.h"
#include "laboratory/house/schedule.h"

const PanelParameter *house_change_parameters(const void *context, size_t *count) {
    const HouseSession *live = context;
    *count = live->values.count;
    return live->values.listed;
}

void house_change_hold(void *context, const char *name) {
    HouseSession *live = house_session_current(context);
    size_t row = house_value_find(&live->values, name);
    char step[2 * HOUSE_THING_NAME] = "Change a number";
    if (row != SIZE_MAX)
        snprintf(step, sizeof step, "%s: %s", live->values.rows[row].group, live->values.rows[row].label);
    editor_hold_number(live->editor, step);
}

void house_change_settle(void *context) {
    editor_settle(house_session_current(context)->editor);
}

/* Sets what a row says in the draft: as a step of its own, unless numbers are in the hand. */
static bool set_in_draft(HouseSession *live, size_t row, Fault *fault) {
    const PanelParameter *value = &live->values.rows[row];
    char name[HOUSE_THING_NAME];
    snprintf(name, sizeof name, "%s: %s", value->group, value->label);
    bool held = editor_holds_number(live->editor);
    if (held)
        draft_rewind(live->draft);
    else
        draft_begin(live->draft, name);
    bool known = draft_parameter_set(live->draft, value->name, parameters_number_json(value->row, value->value), fault);
    if (held)
        return known && draft_try(live->draft, fault);
    if (known)
        return draft_end(live->draft, fault);
    draft_cancel(live->draft);
    return false;
}

static void put_back(HouseSession *live, size_t row) {
    Fault none = {0};
    set_in_draft(live, row, &none);
    fault_clear(&none);
}

bool house_change_set(void *context, const char *name, double value, Fault *fault) {
    HouseSession *live = house_session_current(context);
    size_t row = house_value_find(&live->values, name);
    if (row == SIZE_MAX) {
        fault_add(fault, "there is no number called \"%s\"", name);
        return false;
    }
    double before = live->values.rows[row].value;
    if (!house_value_set(&live->values, row, value, fault))
        return false;
    if (value == before)
        return true;
    if (!set_in_draft(live, row, fault)) {
        live->values.rows[row].value = before;
        if (editor_holds_number(live->editor)) /* the last that stood, if there was one, is what is put down */
            put_back(live, row);
        return false;
    }
    house_schedule_apply_edit(live);
    if (live->runs[RUN_SHOWN])
        house_value_sort(&live->values, &live->runs[RUN_SHOWN]->house, live->selected);
    return true;
}

void house_change_reset(void *context) {
    HouseSession *live = house_session_current(context);
    uint64_t before = draft_revision(live->draft);
    editor_reset(live->editor, "Reset scene");
    if (draft_revision(live->draft) == before)
        return;
    for (size_t i = 0; i < live->values.count; i++)
        live->values.rows[i].value = live->values.rows[i].initial;
    if (live->kept_itself)
        house_schedule_clear(live);
    house_history_begin(&live->history, draft_text(live->draft), draft_revision(live->draft));
    house_schedule_apply_edit(live);
}

const Preset *house_change_presets(const void *context, size_t *count) {
    (void)context;
    *count = 0;
    return NULL;
}

void house_change_prefer(void *context, size_t preset) {
    (void)context;
    (void)preset;
}

const PanelChoice *house_change_choices(void *context, size_t *count) {
    return house_choices_list(house_session_current(context), count);
}

void house_change_choose(void *context, size_t choice, size_t word) {
    house_choices_take(house_session_current(context), choice, word);
}

/* What is recorded is what would come: only a run that was stopped or broke down is made again, or one in which the
 * plan changed. */
void house_change_again(void *context) {
    HouseSession *live = house_session_current(context);
    house_schedule_restart(live);
    if (live->trouble.text && !live->runs[RUN_LATEST])
        house_schedule_request(live);
}

bool house_change_keep(void *context, double time) {
    HouseSession *live = house_session_current(context);
    (void)time;
    live->changed |= LABORATORY_WORDS | LABORATORY_PLOTS;
    return house_schedule_store(live, false);
}

void house_change_clear(void *context, double time) {
    (void)time;
    house_schedule_clear(house_session_current(context));
}
