#include "laboratory/machine/verdict.h"

#include "result/types.h"

bool machine_verdict_decide(MachineVerdict *verdict, const MachineKind *kind, const Machine *machine,
                            const Stop *stop) {
    *verdict = (MachineVerdict){.kind = kind, .machine = *machine};
    return kind->decide(&verdict->machine, &verdict->facts, stop);
}

static void write_advice(MachineVerdict *verdict, const Types *types, const Experiment *experiment) {
    ResultTable basis = result_types_basis(types, experiment, verdict->kind->cycles(&verdict->machine));
    memory_free(verdict->advice);
    verdict->advice = text_copy(result_find(&basis, 0, "advice")->text);
    result_clear(&basis);
    verdict->type = types->kind;
    verdict->typed = true;
}

bool machine_verdict_tell_type(MachineVerdict *verdict, int jobs, const Stop *stop,
                               void (*progress)(void *context, size_t done, size_t all), void *context) {
    const MachineKind *kind = verdict->kind;
    Experiment quick, thorough;
    Types types;
    Fault fault = {0};
    bool decided = false;
    if (kind->open_experiment(&quick, &verdict->machine, &fault)) {
        if (kind->open_experiment(&thorough, &verdict->machine, &fault)) {
            kind->be_thorough(&thorough);
            TypesTask task = {.experiment = &quick,
                              .thorough = &thorough,
                              .names = kind->window,
                              .name_count = kind->window_count,
                              .jobs = jobs,
                              .stop = stop,
                              .progress = progress,
                              .context = context};
            decided = types_classify(&types, &task, &fault) && !types.stopped;
            if (decided)
                write_advice(verdict, &types, &quick);
            kind->close_experiment(&thorough);
        }
        kind->close_experiment(&quick);
    }
    fault_clear(&fault);
    return decided;
}

TypesKind machine_verdict_type_at(const MachineKind *kind, const Machine *machine, const char *name, double value,
                                  int jobs, const Stop *stop) {
    Machine own = *machine;
    Experiment quick;
    Types types = {.kind = TYPES_UNRESOLVED};
    Fault fault = {0};
    if (parameters_set_number(parameters_find(kind->table(), name), &own, value, &fault) &&
        kind->open_experiment(&quick, &own, &fault)) {
        TypesTask task = {.experiment = &quick,
                          .names = kind->window,
                          .name_count = kind->window_count,
                          .window_only = true,
                          .jobs = jobs,
                          .stop = stop};
        if (!types_classify(&types, &task, &fault) || types.stopped)
            types.kind = TYPES_UNRESOLVED;
        kind->close_experiment(&quick);
    }
    fault_clear(&fault);
    return types.kind;
}

bool machine_verdict_confirm(MachineVerdict *verdict, int jobs, const Stop *stop) {
    MachineFacts facts = {.quick = false};
    bool confirmed =
        verdict->kind->confirm(&verdict->machine, &facts, jobs, stop) && facts.verdict != RESPONSE_INTERRUPTED;
    if (confirmed) {
        MachineFacts quick = verdict->facts;
        verdict->facts = facts;
        facts = quick;
    }
    result_clear(&facts.motion);
    result_clear(&facts.forces);
    memory_free(facts.words);
    return confirmed;
}

MachineVerdict machine_verdict_copy(const MachineVerdict *verdict) {
    MachineVerdict copy = *verdict;
    copy.facts.motion = result_copy(&verdict->facts.motion);
    copy.facts.forces = result_copy(&verdict->facts.forces);
    copy.facts.words = verdict->facts.words ? text_copy(verdict->facts.words) : NULL;
    copy.advice = verdict->advice ? text_copy(verdict->advice) : NULL;
    return copy;
}

void machine_verdict_clear(MachineVerdict *verdict) {
    result_clear(&verdict->facts.motion);
    result_clear(&verdict->facts.forces);
    memory_free(verdict->facts.words);
    memory_free(verdict->advice);
    *verdict = (MachineVerdict){.advice = NULL};
}
