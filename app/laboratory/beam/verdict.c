#include "laboratory/beam/verdict.h"

#include <math.h>

#include "base/stop.h"
#include "beam/beam_cycle.h"
#include "experiment/beam_experiment.h"
#include "result/types.h"

bool beam_verdict_decide(BeamVerdict *verdict, const Beam *beam, const Stop *stop) {
    *verdict = (BeamVerdict){.beam = *beam};
    Rig rig;
    Fault fault = {0};
    if (!rig_build(&rig, beam, beam->name, &fault)) {
        fault_clear(&fault);
        return false;
    }
    Response response;
    beam_cycle_respond(&response, &rig, beam, NULL, stop);
    verdict->verdict = response.verdict;
    bool decided = response.verdict != RESPONSE_INTERRUPTED;
    verdict->period = response.orbit.period;
    verdict->peaks = response.peaks;
    verdict->exponent = response.exponent;
    verdict->motion = result_beam_motion(beam, &response);
    verdict->forces = result_beam_forces(&rig, &response);
    response_clear(&response);
    rig_clear(&rig);
    return decided;
}

static void write_advice(BeamVerdict *verdict, const Types *types, const Experiment *experiment) {
    int cycles = verdict->beam.transient_cycles + verdict->beam.cycles;
    ResultTable basis = result_types_basis(types, experiment, cycles);
    memory_free(verdict->advice);
    verdict->advice = text_copy(result_find(&basis, 0, "advice")->text);
    result_clear(&basis);
    verdict->type = types->kind;
    verdict->typed = true;
}

bool beam_verdict_tell_type(BeamVerdict *verdict, int jobs, const Stop *stop,
                            void (*progress)(void *context, size_t done, size_t all), void *context) {
    Experiment quick, thorough;
    Types types;
    Fault fault = {0};
    bool decided = false;
    if (beam_experiment_of(&quick, &verdict->beam, verdict->beam.name, &fault)) {
        if (beam_experiment_of(&thorough, &verdict->beam, verdict->beam.name, &fault)) {
            beam_experiment_be_thorough(&thorough);
            TypesTask task = {.experiment = &quick,
                              .thorough = &thorough,
                              .names = beam_experiment_window,
                              .name_count = BEAM_EXPERIMENT_WINDOW,
                              .jobs = jobs,
                              .stop = stop,
                              .progress = progress,
                              .context = context};
            decided = types_classify(&types, &task, &fault) && !types.stopped;
            if (decided)
                write_advice(verdict, &types, &quick);
            beam_experiment_close(&thorough);
        }
        beam_experiment_close(&quick);
    }
    fault_clear(&fault);
    return decided;
}

BeamVerdict beam_verdict_copy(const BeamVerdict *verdict) {
    BeamVerdict copy = *verdict;
    copy.motion = result_copy(&verdict->motion);
    copy.forces = result_copy(&verdict->forces);
    copy.advice = verdict->advice ? text_copy(verdict->advice) : NULL;
    return copy;
}

void beam_verdict_clear(BeamVerdict *verdict) {
    result_clear(&verdict->motion);
    result_clear(&verdict->forces);
    memory_free(verdict->advice);
    *verdict = (BeamVerdict){.advice = NULL};
}
