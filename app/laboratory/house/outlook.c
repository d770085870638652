#include "laboratory/house/outlook.h"

#include "experiment/house_experiment.h"
#include "house/shake.h"
#include "result/shake_findings.h"
#include "study/study.h"

enum { FEW = 20 };

size_t outlook_size(int step) {
    return step == OUTLOOK_STEPS - 1 ? OUTLOOK_SHAKES : FEW;
}

/* Copies what the window shows of the findings. */
static void take(Outlook *outlook, const ShakeFindings *findings) {
    Arena *arena = &outlook->arena;
    const Plan *plan = &findings->house->plan;
    outlook->shakes = findings->shakes;
    outlook->all_out = findings->all_out.good;
    outlook->people = arena_allocate(arena, findings->party_count * sizeof *outlook->people);
    for (size_t p = 0; p < findings->party_count; p++)
        outlook->people[outlook->person_count++] =
            (OutlookPerson){arena_text(arena, findings->parties[p].id), findings->parties[p].out.good};
    outlook->pieces = arena_allocate(arena, findings->piece_count * sizeof *outlook->pieces);
    for (size_t f = 0; f < findings->piece_count; f++) {
        const ShakePiece *piece = &findings->pieces[f];
        const Furniture *furniture = &plan->furniture[piece->index];
        if (shake_can_topple(furniture))
            outlook->pieces[outlook->piece_count++] =
                (OutlookPiece){arena_text(arena, furniture->id), piece->toppled, piece->stops.good};
    }
}

bool outlook_make(Outlook *outlook, int step, const char *path, const char *text, const HouseOptions *options,
                  const char *route, int jobs, const Stop *stop, Fault *fault) {
    HouseOptions shaken = *options;
    Experiment experiment;
    *outlook = (Outlook){0};
    shaken.shake = true;
    if (!house_experiment_open_text(&experiment, path, text, &shaken, route, fault))
        return false;
    Study study = {.experiment = &experiment, .pass_count = 1, .runs = outlook_size(step), .seed = 1};
    study_begin(&study);
    study_run(&study, &(StudyOptions){.jobs = jobs, .stop = stop});
    bool done = study_done(&study) == study_room(&study);
    if (done) {
        ShakeFindings findings = shake_findings_make(&study);
        take(outlook, &findings);
        shake_findings_free(&findings);
    }
    study_clear(&study);
    house_experiment_close(&experiment);
    return done;
}

void outlook_clear(Outlook *outlook) {
    arena_clear(&outlook->arena);
    *outlook = (Outlook){0};
}
