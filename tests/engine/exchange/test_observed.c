#include "check.h"

#include <unistd.h>

#include "scratch.h"
#include "exchange/observed.h"

/* Reads loci from a text; its \' stand for quotation marks. */
static bool read_text(ObservedLoci *loci, const char *text) {
    char path[SCRATCH_PATH];
    Fault fault = {0};
    scratch_write(path, text);
    bool good = observed_read(loci, path, &fault);
    check_say(&fault);
    unlink(path);
    return good;
}

static void check_two_places(const char *text) {
    ObservedLoci loci = {0};
    CHECK(read_text(&loci, text));
    CHECK(loci.count == 1);
    if (loci.count == 1) {
        const Locus *locus = &loci.loci[0].locus;
        CHECK_TEXT(loci.loci[0].person, "");
        CHECK(locus->count == 2);
        CHECK_NEAR(locus->times[1], 0.5, 0);
        CHECK_NEAR(locus->points[0].x, 1.25, 0);
        CHECK_NEAR(locus->points[1].y, -3, 0);
    }
    observed_free(&loci);
}

TEST(columns_may_be_separated_by_a_comma_a_semicolon_or_a_tab) {
    check_two_places("time,x,y\n0,1.25,2\n0.5,1.5,-3\n");
    check_two_places("time;x;y\r\n0;1.25;2\r\n0.5;1.5;-3\r\n");
    check_two_places("time\tx\ty\n0\t1.25\t2\n0.5\t1.5\t-3");
}

TEST(units_letters_marks_and_further_columns_change_nothing) {
    check_two_places("\xef\xbb\xbfTime [s],note,Y [m],X (m)\n0,'a, b',2,1.25\n\n 0.5 ,'',-3,1.5\n");
    check_two_places("t,x,y,speed [m/s]\n+0,1.25,2,?\n5e-1,1.5,-3,?\n");
}

TEST(rows_are_brought_into_the_order_of_time_person_by_person) {
    ObservedLoci loci = {0};
    CHECK(read_text(&loci, "person,time,x,y\nb,2,20,0\na,1,11,0\nb,1,21,0\n'a',0,10,0\nb,0,22,0\n"));
    CHECK(loci.count == 2);
    CHECK_TEXT(loci.loci[0].person, "b");
    CHECK(loci.loci[0].line == 2 && loci.loci[0].locus.count == 3);
    CHECK_NEAR(loci.loci[0].locus.points[0].x, 22, 0);
    CHECK_TEXT(loci.loci[1].person, "a");
    CHECK_NEAR(loci.loci[1].locus.points[1].x, 11, 0);
    observed_free(&loci);
}

static void read_bad(const char *path, Fault *fault) {
    ObservedLoci loci = {.path = "untouched"};
    CHECK(!observed_read(&loci, path, fault));
    CHECK_TEXT(loci.path, "untouched");
    CHECK(!loci.count);
}

TEST(a_bad_file_gives_exactly_its_faults_and_leaves_its_target_as_it_was) {
    scratch_check_faults("tests/data/bad/observed", read_bad);
}

TEST(a_file_that_is_not_there_is_a_fault) {
    Fault fault = {0};
    read_bad("nowhere.csv", &fault);
    CHECK(fault.count == 1);
    CHECK_TEXT(fault.lines[0], "nowhere.csv:1:1: cannot be read: No such file or directory");
    fault_clear(&fault);
}

TEST(a_locus_is_compared_only_beside_the_other) {
    Vec2 line[] = {{0, 0}, {4, 0}}, beside[] = {{-1, 9}, {1, 0.1}, {3, -0.3}, {5, 9}};
    double times[4] = {0};
    LocusDistance apart = locus_distance(&(Locus){beside, times, 4}, &(Locus){line, times, 2});
    CHECK(apart.counted == 2);
    CHECK_NEAR(apart.mean, 0.2, 1e-12);
    CHECK_NEAR(apart.largest, 0.3, 1e-12);
    apart = locus_distance(&(Locus){beside, times, 4}, &(Locus){line, times, 1});
    CHECK(apart.counted == 0);
}
