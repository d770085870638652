#include "fuzz_import.h"

#include <stdio.h>
#include <string.h>

#include "exchange/house_finish.h"
#include "exchange/walkable.h"
#include "fuzz.h"

enum { MOST_POINTS = 300 /* of walls: their area takes some ms */ };

static void round_trip(const Plan *plan) {
    char *once = plan_text(plan);
    Plan again = {0};
    Fault fault = {0};
    fuzz_expect(plan_read_text(&again, "again", once, NULL, 0, &fault), "a house that was imported is read");
    char *twice = plan_text(&again);
    fuzz_expect(strcmp(once, twice) == 0, "a house that was imported survives writing");
    memory_free(once);
    memory_free(twice);
    plan_free(&again);
}

static void export(const Plan *plan) {
    Fault fault = {0};
    char *wkt = walkable_wkt(plan, &fault);
    fuzz_expect((wkt != NULL) == (fault.total == 0), "an area, or a fault");
    fuzz_expect(!wkt || wkt[strlen(wkt) - 1] == '\n', "an area is a line");
    memory_free(wkt);
    fault_clear(&fault);
}

static void check_report(const ImportReport *report) {
    fuzz_expect(report->left_out_count <= IMPORT_REPORT_KINDS && report->note_count <= IMPORT_REPORT_NOTES,
                "a report is short");
    for (size_t i = 0; i < report->left_out_count; i++)
        fuzz_expect(report->left_out[i].count && *report->left_out[i].what, "what is left out has a name and a count");
}

void fuzz_import(const char *path, bool (*read)(HouseBuilder *builder)) {
    HouseBuilder builder;
    ImportReport report = {.format = "fuzz"};
    Fault fault = {0};
    Plan plan = {0};
    house_builder_init(&builder, path, &(ImportOptions){0}, &report, &fault);
    bool good = read(&builder) && house_finish_plan(&builder, &plan);
    for (size_t i = 0; good && i < fault.count; i++)
        fprintf(stderr, "%s\n", fault.lines[i]);
    fuzz_expect(good || fault.total == 1, "one line says why");
    fuzz_expect_faults(good, &fault, path);
    check_report(&report);
    if (good)
        round_trip(&plan);
    if (good && builder.points < MOST_POINTS && plan.furniture_count < MOST_POINTS)
        export(&plan);
    house_builder_clear(&builder);
    import_report_clear(&report);
    plan_free(&plan);
}
