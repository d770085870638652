/* What a person does to a house at work, besides editing it: as in LiveKind, with a HouseLive as `live`. */
#include <stdio.h>

#include "base/parameters_number.h"
#include "plan/draft_file.h"
#include "plan/draft_parameter.h"
#include "live/house/house_live_parts.h"

const LiveParameter *house_live_change_parameters(const void *context, size_t *count) {
    const HouseLive *live = context;
    *count = live->values.count;
    return live->values.listed;
}

void house_live_change_hold(HouseLive *live, const char *name) {
    draft_begin(live->draft, name);
    live->held = true;
}

void house_live_change_settle(HouseLive *live) {
    Fault none = {0}; /* what did not stand was said when it was set */
    live->held = false;
    draft_end(live->draft, &none);
    fault_clear(&none);
    house_live_follow_edited(live);
}

/* Sets what a row says in the draft: as a step of its own, unless numbers are in the hand. */
static bool set_in_draft(HouseLive *live, size_t row, Fault *fault) {
    const LiveParameter *value = &live->values.rows[row];
    char name[HOUSE_THING_NAME];
    snprintf(name, sizeof name, "%s: %s", value->group, value->label);
    live->held = live->held && draft_is_open(live->draft); /* what ends a step lets go of its numbers */
    if (live->held)
        draft_rewind(live->draft);
    else
        draft_begin(live->draft, name);
    bool known = draft_parameter_set(live->draft, value->name, parameters_number_json(value->row, value->value), fault);
    if (live->held)
        return known && draft_try(live->draft, fault);
    if (known)
        return draft_end(live->draft, fault);
    draft_cancel(live->draft);
    return false;
}

static void put_back(HouseLive *live, size_t row) {
    Fault none = {0};
    set_in_draft(live, row, &none);
    fault_clear(&none);
}

bool house_live_change_set(void *context, const char *name, double value, Fault *fault) {
    HouseLive *live = context;
    size_t row = house_live_value_find(&live->values, name);
    if (row == SIZE_MAX) {
        fault_add(fault, "there is no number called \"%s\"", name);
        return false;
    }
    double before = live->values.rows[row].value;
    if (!house_live_value_set(&live->values, row, value, fault))
        return false;
    if (value == before)
        return true;
    if (!set_in_draft(live, row, fault)) {
        live->values.rows[row].value = before;
        if (live->held) /* the last that stood, if there was one, is what is put down */
            put_back(live, row);
        return false;
    }
    house_live_follow_edited(live);
    if (live->shown)
        house_live_value_sort(&live->values, &live->shown->house, live->selected);
    return true;
}

void house_live_change_reset(void *context) {
    HouseLive *live = context;
    house_edit_gesture_drop(live);
    uint64_t before = draft_revision(live->draft);
    live->held = false;
    draft_file_reset(live->draft, "Reset scene");
    if (draft_revision(live->draft) == before)
        return;
    for (size_t i = 0; i < live->values.count; i++)
        live->values.rows[i].value = live->values.rows[i].initial;
    if (live->kept_itself)
        house_live_follow_forget(live);
    house_live_history_begin(&live->history, draft_text(live->draft), draft_revision(live->draft));
    house_live_follow_edited(live);
}

const LivePreset *house_live_change_presets(const void *context, size_t *count) {
    (void)context;
    *count = 0;
    return NULL;
}

void house_live_change_prefer(void *context, size_t preset) {
    (void)context;
    (void)preset;
}

const LiveChoice *house_live_change_choices(const void *context, size_t *count) {
    return house_live_choices_list((HouseLive *)context, count);
}

void house_live_change_choose(void *context, size_t choice, size_t word) {
    house_live_choices_take(context, choice, word);
}

/* What is recorded is what would come: only a run that was stopped or broke down is made again, or one in which the
 * plan changed. */
void house_live_change_again(void *context) {
    HouseLive *live = context;
    house_live_follow_clean(live);
    if (live->trouble.text && !live->latest)
        house_live_follow_ask(live);
}

bool house_live_change_keep(void *context, double time) {
    HouseLive *live = context;
    (void)time;
    live->changed |= LIVE_WORDS | LIVE_PLOTS;
    return house_live_follow_keep(live, false);
}

void house_live_change_clear(void *context, double time) {
    (void)time;
    house_live_follow_forget(context);
}
