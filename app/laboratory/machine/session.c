#include "laboratory/machine/session.h"

#include <stdint.h>
#include <string.h>

#include "base/text.h"

static void show_choices(MachineSession *session) {
    const MachineKind *kind = session->kind;
    session->choices[MACHINE_CHOICE_SWEEP] = (PanelChoice){.name = "Sweep",
                                                           .meaning = kind->sweeps_meaning,
                                                           .options = kind->sweeps,
                                                           .count = MACHINE_SWEEPS,
                                                           .chosen = session->diagram.carried};
    session->choices[MACHINE_CHOICE_OVER] =
        (PanelChoice){.name = "Rhythms over",
                      .meaning = "the number that varies along \"All rhythms at a glance\" (orbit diagram)",
                      .options = kind->over_words,
                      .count = kind->over_count,
                      .chosen = session->diagram.over};
}

void machine_session_open(MachineSession *session, const MachineKind *kind, const char *path, int jobs,
                          const Machine *opened, const Machine *file) {
    session->kind = kind;
    session->path = text_copy(path);
    session->now = *opened;
    machine_controls_open(&session->controls, kind, file);
    machine_controls_show(&session->controls, opened);
    machine_diagram_open(&session->diagram, kind);
    machine_map_open(&session->map, &session->controls);
    session->worker = machine_worker_start(kind, jobs);
    session->choice_count = MACHINE_CHOICES;
    show_choices(session);
    session->news = LABORATORY_ALL & ~LABORATORY_ERROR;
}

void machine_session_close(MachineSession *session) {
    machine_worker_stop(session->worker);
    machine_picture_close(&session->picture);
    machine_diagram_close(&session->diagram);
    machine_answer_clear(&session->answer);
    machine_verdict_clear(&session->verdict);
    arena_clear(&session->command_words);
    memory_free(session->path);
}

void machine_session_ask(MachineSession *session, bool verdict) {
    session->news |= LABORATORY_TEXTS | LABORATORY_PARAMETERS;
    session->looked = SIZE_MAX;
    session->has_verdict =
        session->has_verdict && machine_same(session->kind, &session->verdict.machine, &session->now);
    machine_controls_show(&session->controls, &session->now);
    machine_diagram_ask(&session->diagram, &session->controls, &session->now, session->worker);
    machine_map_ask(&session->map, session->kind, &session->now, session->worker);
    if (verdict)
        machine_worker_ask_verdict(session->worker, &session->now);
}

/* Numbers and choices -----------------------------------------------------------------------------------------------*/

static bool change(MachineSession *session, const Machine *machine, Fault *fault) {
    if (machine_same(session->kind, machine, &session->now))
        return true;
    if (!session->change_record(session, machine, fault))
        return false;
    session->now = *machine;
    machine_session_ask(session, true);
    return true;
}

const PanelParameter *machine_session_parameters(const void *context, size_t *count) {
    const MachineSession *session = context;
    *count = session->controls.count;
    return session->controls.parameters;
}

bool machine_session_set(void *context, const char *name, double value, Fault *fault) {
    MachineSession *session = context;
    Machine machine = session->now;
    return machine_controls_set(&session->controls, &machine, name, value, fault) && change(session, &machine, fault);
}

void machine_session_reset(void *context) {
    MachineSession *session = context;
    Fault none = {0};
    change(session, &session->controls.file, &none);
    fault_clear(&none);
}

const Preset *machine_session_presets(const void *context, size_t *count) {
    const MachineSession *session = context;
    *count = session->kind->preset_count;
    return session->controls.presets;
}

void machine_session_apply_preset(void *context, size_t preset) {
    MachineSession *session = context;
    Machine machine;
    Fault none = {0};
    machine_controls_prefer(&session->controls, preset, &machine);
    change(session, &machine, &none);
    fault_clear(&none);
}

const PanelChoice *machine_session_choices(void *context, size_t *count) {
    const MachineSession *session = context;
    *count = session->choice_count;
    return session->choices;
}

void machine_session_choose(void *context, size_t choice, size_t word) {
    MachineSession *session = context;
    if (choice == MACHINE_CHOICE_SWEEP)
        session->diagram.carried = word == 1;
    else
        session->diagram.over = word;
    show_choices(session);
    machine_session_ask(session, false);
}

const char *const *machine_session_command(void *context, size_t *count) {
    MachineSession *session = context;
    *count = machine_controls_command(&session->controls, session->path, session->command, &session->command_words);
    return session->command;
}

/* Answer ------------------------------------------------------------------------------------------------------------*/

void machine_session_write(MachineSession *session, CycleStatus status, bool changed, const MachineLately *lately) {
    MachineNow now = {session->kind, status, changed, session->where};
    machine_answer_write(&session->answer, &now, lately, session->has_verdict ? &session->verdict : NULL);
    session->news |= LABORATORY_TEXTS;
}

static void apply_news(MachineSession *session, MachineNews *news) {
    if (news->verdict && machine_same(session->kind, &news->result.machine, &session->now)) {
        machine_verdict_clear(&session->verdict);
        session->verdict = news->result;
        session->has_verdict = true;
        session->looked = SIZE_MAX;
        bool typed = session->verdict.typed && session->verdict.type != TYPES_UNRESOLVED;
        if (typed && machine_controls_name_type(&session->controls, &session->verdict.machine,
                                                types_kind_name(session->verdict.type)))
            session->news |= LABORATORY_PARAMETERS;
    } else if (news->verdict) {
        machine_verdict_clear(&news->result);
    }
    if (news->followed) {
        session->looked = SIZE_MAX;
        session->answer.lines = &session->diagram.lines;
    }
    if (news->swept || news->followed || news->banded)
        machine_diagram_apply(&session->diagram, news);
    if (news->mapped)
        machine_map_apply(&session->map, news);
}

unsigned machine_session_update(void *context, double time) {
    (void)time;
    MachineSession *session = context;
    MachineNews news;
    machine_worker_take(session->worker, &news);
    apply_news(session, &news);
    session->look(session);
    char before[sizeof session->answer.doing];
    memcpy(before, session->answer.doing, sizeof before);
    machine_answer_note_doing(&session->answer, session->kind, &news);
    if (strcmp(before, session->answer.doing) != 0)
        session->news |= LABORATORY_TEXTS;
    unsigned changed = session->news;
    session->news = 0;
    return changed;
}

void machine_session_note_plots(void *context, const char *names) {
    MachineSession *session = context;
    bool shown = false;
    for (const char *at = names; *at; at += strcspn(at, ","), at += *at == ',')
        shown |= strcspn(at, ",") == strlen(MACHINE_MAP_NAME) && strncmp(at, MACHINE_MAP_NAME, strcspn(at, ",")) == 0;
    machine_map_show(&session->map, shown, session->kind, &session->now, session->worker);
}

bool machine_session_follow(void *context) {
    MachineSession *session = context;
    double state[MACHINE_STATES_MOST];
    size_t count = session->state ? session->state(session, state) : 0;
    session->looked = SIZE_MAX;
    session->news |= LABORATORY_TEXTS;
    return machine_diagram_follow(&session->diagram, session->worker, &session->now, state, count);
}

Result machine_session_answer(void *context) {
    return ((const MachineSession *)context)->answer.result;
}

const PanelRow *machine_session_rows(const void *context, size_t *count) {
    const MachineSession *session = context;
    *count = session->answer.row_count;
    return session->answer.rows;
}
