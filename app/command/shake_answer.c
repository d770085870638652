#include "command/shake_answer.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "base/json.h"
#include "command/output.h"
#include "command/report_files.h"
#include "plot/plot_write.h"
#include "visual/house/shake_plots.h"
#include "visual/house/shake_scene.h"
#include "report/shake_report.h"
#include "study/summary.h"

/* JSON ------------------------------------------------------------------------------------------------------------- */

static json_t *known(double value) {
    return isfinite(value) ? json_number(value) : json_null();
}

static json_t *whole(size_t value) {
    return json_integer((json_int_t)value);
}

static json_t *share_of(const Share *share) {
    return json_pack("{s:o, s:o, s:o, s:o, s:o}", "shakes", whole(share->good), "of", whole(share->all), "share",
                     known(share->value), "q025", known(share->low), "q975", known(share->high));
}

static json_t *time_of(const Distribution *time) {
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "count", whole(time->count), "mean", known(time->mean),
                     "q25", known(time->quarters[0]), "q50", known(time->median), "q75", known(time->quarters[1]),
                     "q95", known(time->high), "least", known(time->least), "greatest", known(time->greatest));
}

static json_t *people_of(const ShakeFindings *findings) {
    json_t *people = json_array();
    for (size_t p = 0; p < findings->party_count; p++) {
        const ShakeParty *party = &findings->parties[p];
        json_array_append_new(people,
                              json_pack("{s:s, s:s, s:o, s:o, s:o, s:o}", "id", party->id, "profile", party->profile,
                                        "people", whole(party->people), "out", share_of(&party->out), "members_out",
                                        known(party->members), "time", time_of(&party->time)));
    }
    return people;
}

static json_t *pieces_of(const ShakeFindings *findings) {
    json_t *pieces = json_array();
    for (size_t p = 0; p < findings->piece_count; p++) {
        const ShakePiece *piece = &findings->pieces[p];
        const Furniture *furniture = &findings->house->plan.furniture[piece->index];
        json_array_append_new(pieces, json_pack("{s:s, s:s, s:o, s:o, s:o, s:o}", "id", furniture->id, "name",
                                                furniture->name, "probability", known(furniture->probability),
                                                "toppled", whole(piece->toppled), "toppled_and_not_all_out",
                                                whole(piece->with_loss), "blocks", share_of(&piece->stops)));
    }
    return pieces;
}

static json_t *worst_of(const ShakeFindings *findings) {
    if (!findings->worst)
        return json_null();
    return json_pack("{s:I, s:s}", "seed", (json_int_t)findings->worst->seed, "settings", findings->made_by);
}

json_t *shake_answer_make(const ShakeFindings *findings, const char *file) {
    const Study *study = findings->study;
    SummaryCount count = summary_count(study);
    char digest[17];
    snprintf(digest, sizeof digest, "%016" PRIx64, summary_digest(study));
    json_t *answer = json_pack("{s:s, s:s, s:s, s:I, s:o, s:o, s:o}", "kind", "shake", "house",
                               findings->house->plan.name, "file", file, "seed", (json_int_t)study->seed, "shakes",
                               whole(count.trials), "done", whole(count.done), "faults", whole(count.faults));
    json_object_set_new(answer, "everybody_out", share_of(&findings->everybody));
    json_object_set_new(answer, "time", time_of(&findings->time));
    json_object_set_new(answer, "without_shake",
                        json_pack("{s:b, s:o}", "completed", findings->calm_out, "time", known(findings->calm_time)));
    json_object_set_new(answer, "people", people_of(findings));
    json_object_set_new(answer, "furniture", pieces_of(findings));
    json_object_set_new(answer, "blocked_elsewhere", share_of(&findings->elsewhere));
    json_object_set_new(answer, "caught", share_of(&findings->caught));
    json_object_set_new(answer, "worst", worst_of(findings));
    json_object_set_new(answer, "digest", json_string(digest));
    return answer;
}

/* Files ------------------------------------------------------------------------------------------------------------ */

static bool write_plan(const ShakeFindings *findings, const Options *options) {
    Scene scene;
    shake_scene_make(&scene, findings);
    bool written = output_stills(&scene, options);
    scene_clear(&scene);
    return written;
}

static bool write_times(const ShakeFindings *findings, const Options *options) {
    Arena arena = {0};
    Plot plot;
    char path[PLOT_WRITE_PATH];
    int error = 0;
    if (shake_plots_times(&plot, findings, &arena))
        error = plot_write_files(&plot, "times", options->out, options->width, options->height, options->theme, path);
    if (error)
        output_failed(path, error);
    arena_clear(&arena);
    return !error;
}

static bool write_report(const ShakeFindings *findings, const Options *options) {
    if (!options->report)
        return true;
    char *command = report_files_command(options);
    const Making making = report_files_making(options, command);
    Document document = shake_report_make(findings, &making);
    bool written = report_files_write(&document, "report", options);
    document_clear(&document);
    memory_free(command);
    return written;
}

bool shake_answer_write(const ShakeFindings *findings, const Options *options) {
    return write_plan(findings, options) && write_times(findings, options) && write_report(findings, options);
}
