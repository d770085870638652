#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "scratch.h"
#include "plan/profile.h"

/* Reads assets/profiles/NAME.json, which must be valid. */
static Profile shipped(const char *name) {
    char path[100];
    Profile profile = {0};
    Fault fault = {0};
    snprintf(path, sizeof path, "assets/profiles/%s.json", name);
    CHECK(profile_read(&profile, scratch_source(path), &fault));
    check_say(&fault);
    return profile;
}

TEST(every_shipped_profile_reads_and_is_stable_at_the_usual_step) {
    size_t count;
    char **paths = scratch_list("assets/profiles", &count);
    CHECK(count >= 4);
    for (size_t i = 0; i < count; i++) {
        Profile profile = {0};
        Fault fault = {0};
        CHECK(profile_read(&profile, scratch_source(paths[i]), &fault));
        CHECK(profile_check(&profile, 0.001, paths[i], &fault));
        for (size_t f = 0; f < fault.count; f++)
            printf("%s\n", fault.lines[f]);
        char path[100];
        snprintf(path, sizeof path, "assets/profiles/%s.json", profile.name);
        CHECK_TEXT(path, paths[i]);
        CHECK(*profile.note);
        fault_clear(&fault);
        profile_free(&profile);
    }
    scratch_free_list(paths, count);
}

TEST(every_value_of_every_shipped_profile_says_where_it_comes_from) {
    size_t count;
    char **paths = scratch_list("assets/profiles", &count);
    for (size_t i = 0; i < count; i++) {
        Profile profile = {0};
        Fault fault = {0};
        CHECK(profile_read(&profile, scratch_source(paths[i]), &fault));
        for (size_t r = 0; r < profile_table()->count; r++)
            CHECK((profile.provenance[r] && *profile.provenance[r]) == profile_row_matters(r, profile.driving));
        for (size_t r = profile_table()->count; r < PROFILE_NUMBERS; r++)
            CHECK(!profile.provenance[r]);
        fault_clear(&fault);
        profile_free(&profile);
    }
    scratch_free_list(paths, count);
}

/* c = sqrt(2 m k) with a mass that is given to 0.1 kg and a damping given to 0.1 N s/m. */
static void check_damping(double damping, double mass, double stiffness) {
    double expected = sqrt(2 * mass * stiffness);
    CHECK_NEAR(damping, expected, expected * 0.05 / (2 * mass) + 0.05);
}

TEST(one_mass_gives_both_dampings_of_the_papers_chair) {
    const char *const names[] = {"miura-chair", "manual-chair"};
    for (int i = 0; i < 2; i++) {
        Profile profile = shipped(names[i]);
        CHECK_NEAR(profile.mass, 80.2, 0);
        check_damping(profile.contact.normal_damping, profile.mass, profile.contact.normal_stiffness);
        check_damping(profile.contact.tangential_damping, profile.mass, profile.contact.tangential_stiffness);
        CHECK_NEAR(profile.contact.normal_stiffness / profile.contact.tangential_stiffness, 4, 1e-12);
        profile_free(&profile);
    }
}

TEST(the_personal_space_of_the_paper_keeps_its_ratios) {
    Profile profile = shipped("miura-chair");
    const ContactLaw *space = &profile.space;
    CHECK_NEAR(space->normal_stiffness / space->tangential_stiffness, 2 * (1 + 0.3), 0.001);
    CHECK_NEAR(space->normal_damping / space->tangential_damping, sqrt(2.6), 0.005);
    profile_free(&profile);
}

TEST(a_parameter_is_changed_by_its_name_and_says_so) {
    Profile profile = shipped("manual-chair");
    Fault fault = {0};
    CHECK(profile_set(&profile, "width", "0.70", "here: ", &fault));
    CHECK_NEAR(profile.width, 0.7, 0);
    CHECK(profile_set(&profile, "contact.normal_stiffness", "15000", "here: ", &fault));
    CHECK_NEAR(profile.contact.normal_stiffness, 15000, 0);
    CHECK(profile_set(&profile, "driving", "\"miura\"", "here: ", &fault));
    CHECK(profile.driving == DRIVING_MIURA);
    CHECK(fault.count == 0);
    for (size_t r = 0; r < profile_table()->count; r++)
        if (strcmp(profile_table()->rows[r].name, "body.width") == 0)
            CHECK_TEXT(profile.provenance[r], "assumed: set for this run");
    profile_free(&profile);
}

TEST(a_wrong_change_of_a_parameter_leaves_it_and_names_the_place) {
    static const char *const wrong[][3] = {
        {"width", "7", "a.json:3:4: body.width is 7, must be from 0.1 to 3 m"},
        {"width", "\"wide\"", "a.json:3:4: body.width must be a number in m"},
        {"widht", "0.7", "a.json:3:4: profile has no parameter \"widht\", did you mean \"width\"?"},
        {"normal_stiffness", "1",
         "a.json:3:4: profile parameter \"normal_stiffness\" must be space.normal_stiffness or "
         "contact.normal_stiffness"},
        {"driving", "\"flyer\"", "a.json:3:4: driving is \"flyer\", must be driver, miura or walker"},
        {"driving", "\"walker\"",
         "a.json:3:4: a walking profile cannot be changed to a driving one, nor the reverse: use another profile"},
        {"time_gap", "1", "a.json:3:4: drive.time_gap does not apply to manual-chair: people of this profile drive"},
    };
    Profile profile = shipped("manual-chair");
    double width = profile.width;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        Fault fault = {0};
        CHECK(!profile_set(&profile, wrong[i][0], wrong[i][1], "a.json:3:4: ", &fault));
        CHECK(fault.count == 1);
        if (fault.count)
            CHECK_TEXT(fault.lines[0], wrong[i][2]);
        fault_clear(&fault);
    }
    CHECK(profile.width == width && profile.driving == DRIVING_DRIVER);
    profile_free(&profile);
}

TEST(the_parts_of_a_body_must_fit_together) {
    static const char *const wrong[][3] = {
        {"axle", "1.5", "here: axle is 1.5 m ahead of the rear edge, must be at most the length, 1.1 m"},
        {"corner_radius", "0.4", "here: corner_radius is 0.4 m, must be at most half the smaller side, 0.315 m"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        Profile profile = shipped("manual-chair");
        Fault fault = {0};
        CHECK(profile_set(&profile, wrong[i][0], wrong[i][1], "", &fault));
        CHECK(!profile_check(&profile, 0.001, "here", &fault));
        CHECK(fault.count == 1);
        if (fault.count)
            CHECK_TEXT(fault.lines[0], wrong[i][2]);
        fault_clear(&fault);
        profile_free(&profile);
    }
}

TEST(a_step_too_long_for_the_contact_law_is_a_fault) {
    Profile profile = shipped("manual-chair");
    Fault fault = {0};
    CHECK(!profile_check(&profile, 0.05, "here", &fault));
    CHECK(fault.count == 1 && strstr(fault.lines[0], "the step dt is 0.05 s"));
    CHECK(profile_set(&profile, "contact.normal_stiffness", "1e8", "", &fault));
    CHECK(!profile_check(&profile, 0.001, "here", &fault));
    fault_clear(&fault);
    profile_free(&profile);
}
