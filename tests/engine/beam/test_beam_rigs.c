#include <math.h>
#include <stdio.h>

#include "beam/beam_cycle.h"
#include "check.h"
#include "oscillator.h"

enum { STATES_MOST = 128 };

/* What an identified set does at one setting, as the design says and as was found independently with 12 modes.
 *
 * A periodic peak is known to a part in a thousand. In chaos the smallest and the largest peak of 100 cycles are drawn
 * anew in each 100: of 300 such windows, the smallest were from 8 % below to 11 % above the claim, which is itself of
 * one window, and the largest from 6.5 % below to 4 % above. */
typedef struct Claim {
    const char *beam;
    double frequency, length; /* Hz, m; 0: the set's own */
    ResponseVerdict verdict;
    double min, max; /* N, of the peaks; 0: not stated */
} Claim;

static const Claim claims[] = {
    {"ibs", 190, 0, RESPONSE_PERIODIC, 568, 568},  {"ibs", 290, 0, RESPONSE_PERIODIC, 1032, 1032},
    {"ibs", 300, 0, RESPONSE_CHAOTIC, 480, 956},   {"ibs", 290, 0.2868, RESPONSE_CHAOTIC, 0, 0},
    {"ibs-r", 300, 0, RESPONSE_CHAOTIC, 340, 827},
};
enum { CLAIMS = sizeof claims / sizeof *claims, STARTS = 9 /* at rest, and eight at random */ };

static const double PERIODIC_MARGIN = 0.001, MIN_MARGIN = 0.13, MAX_MARGIN = 0.08;

static Beam beam_of(const Claim *claim) {
    Beam beam = oscillator_beam(claim->beam, NULL);
    beam.frequency = claim->frequency;
    beam.length = claim->length > 0 ? claim->length : beam.length;
    return beam;
}

static Response respond(const Rig *rig, const Beam *beam, unsigned start) {
    double state[STATES_MOST];
    Response response;
    oscillator_start(rig, start, state);
    beam_cycle_respond(&response, rig, beam, state, NULL);
    return response;
}

static Rig rig_of(const Beam *beam) {
    Fault fault = {0};
    Rig rig;
    CHECK(rig_build(&rig, beam, beam->name, &fault));
    return rig;
}

static void check_claim(const Claim *claim, const Response *response) {
    bool periodic = claim->verdict == RESPONSE_PERIODIC;
    CHECK_TEXT(response_verdict_name(response->verdict), response_verdict_name(claim->verdict));
    CHECK(response->peaks.count > 150);
    if (claim->max > 0) {
        CHECK_NEAR(response->peaks.min, claim->min, (periodic ? PERIODIC_MARGIN : MIN_MARGIN) * claim->min);
        CHECK_NEAR(response->peaks.max, claim->max, (periodic ? PERIODIC_MARGIN : MAX_MARGIN) * claim->max);
    }
    CHECK(periodic == (response->exponent.value < 0));
    if (periodic)
        CHECK(response->orbit.period == 1 && response->orbit.largest < 1 && response->settled);
    else
        CHECK(response->zero_one > 0.95 && response->exponent.value > 10 * response->exponent.error);
}

LONG_TEST(the_identified_sets_do_what_they_were_identified_by_from_every_start) {
    for (int c = 0; c < CLAIMS; c++) {
        Beam beam = beam_of(&claims[c]);
        Rig rig = rig_of(&beam);
        double least = HUGE_VAL, most = 0, low = HUGE_VAL, high = -HUGE_VAL;
        for (unsigned start = 0; start < STARTS; start++) {
            Response response = respond(&rig, &beam, start);
            check_claim(&claims[c], &response);
            least = fmin(least, response.peaks.min);
            most = fmax(most, response.peaks.max);
            low = fmin(low, response.exponent.value);
            high = fmax(high, response.exponent.value);
            response_clear(&response);
        }
        printf("     %-5s %3g Hz, %5.1f mm: %.0f to %.0f N (%.0f to %.0f), exponent %.3f to %.3f\n", claims[c].beam,
               beam.frequency, 1e3 * beam.length, least, most, claims[c].min, claims[c].max, low, high);
        rig_clear(&rig);
        beam_free(&beam);
    }
}

/* From some initial states period 1 at 759 N, from others chaos, after the same transient. */
TEST(what_set_r_does_at_290_hz_depends_on_the_start) {
    Beam beam = oscillator_beam("ibs-r", NULL);
    beam.frequency = 290;
    Rig rig = rig_of(&beam);
    int seen[RESPONSE_DIVERGED + 1] = {0};
    for (unsigned start = 0; start < STARTS; start++) {
        Response response = respond(&rig, &beam, start);
        seen[response.verdict]++;
        if (response.verdict == RESPONSE_PERIODIC)
            CHECK(response.orbit.period <= 5);
        if (response.verdict == RESPONSE_PERIODIC && response.settled && response.orbit.period == 1)
            CHECK_NEAR(response.peaks.max, 759, 0.001 * 759);
        response_clear(&response);
    }
    printf("     of %d starts %d periodic, %d transient, %d chaotic\n", STARTS, seen[RESPONSE_PERIODIC],
           seen[RESPONSE_TRANSIENT], seen[RESPONSE_CHAOTIC]);
    CHECK(seen[RESPONSE_PERIODIC] + seen[RESPONSE_TRANSIENT] > 0 && seen[RESPONSE_CHAOTIC] > 0);
    CHECK(seen[RESPONSE_PERIODIC] + seen[RESPONSE_TRANSIENT] + seen[RESPONSE_CHAOTIC] == STARTS);
    rig_clear(&rig);
    beam_free(&beam);
}

/* Returns the largest and the smallest peak of the next cycles. */
static SectionPeaks watch_peaks(Motion *motion, int cycles) {
    Section section = {0};
    motion->peak[0] = motion->peak[1] = 0;
    CycleMotion same = beam_cycle_motion(motion);
    for (int i = 0; i < cycles && motion_cycle(motion) == CYCLE_GOOD; i++)
        section_add(&section, &same);
    SectionPeaks peaks = section_peaks(&section);
    section_clear(&section);
    return peaks;
}

/* 389 to 920 N for some thousand cycles, as the design says; then the transient ends from every initial state. */
LONG_TEST(the_chaos_of_set_r_at_284_mm_and_290_hz_is_a_transient_of_thousands_of_cycles) {
    Beam beam = oscillator_beam("ibs-r", "beam.length=0.284");
    beam.frequency = 290;
    Rig rig = rig_of(&beam);
    double state[STATES_MOST];
    for (unsigned start = 0; start < 4; start++) {
        Motion motion = motion_create(&rig, 0);
        oscillator_start(&rig, start, state);
        motion_set_state(&motion, state);
        watch_peaks(&motion, 300);
        SectionPeaks peaks = watch_peaks(&motion, 100);
        CHECK_NEAR(peaks.min, 389, MIN_MARGIN * 389);
        CHECK_NEAR(peaks.max, 920, MAX_MARGIN * 920);
        int thousands = 0;
        while (peaks.min < 500 && thousands < 400) {
            peaks = watch_peaks(&motion, 1000);
            thousands++;
        }
        printf("     chaotic for %d thousand cycles, then %.1f to %.1f N\n", thousands - 1, peaks.min, peaks.max);
        CHECK_NEAR(peaks.min, 515, 1);
        CHECK_NEAR(peaks.max, 901, 1);
        motion_destroy(&motion);
    }
    rig_clear(&rig);
    beam_free(&beam);
}

/* A known disagreement of set R: the paper's response is periodic. */
TEST(set_r_is_weakly_chaotic_at_190_hz) {
    Beam beam = oscillator_beam("ibs-r", NULL);
    beam.frequency = 190;
    Rig rig = rig_of(&beam);
    Response response = respond(&rig, &beam, 0);
    CHECK(response.verdict == RESPONSE_CHAOTIC);
    CHECK(response.exponent.value > 0.1 && response.exponent.value < 0.25);
    response_clear(&response);
    rig_clear(&rig);
    beam_free(&beam);
}

/* Returns the verdict and the peaks from rest with the given modes and elements. */
static Response converge(const Claim *claim, int modes, int elements) {
    Beam beam = beam_of(claim);
    beam.modes = modes;
    beam.elements = elements;
    Rig rig = rig_of(&beam);
    Response response = respond(&rig, &beam, 0);
    printf("     %-5s %3g Hz, %2d modes, %2d elements: %-10s %7.2f to %7.2f N\n", claim->beam, claim->frequency, modes,
           elements, response_verdict_name(response.verdict), response.peaks.min, response.peaks.max);
    rig_clear(&rig);
    beam_free(&beam);
    return response;
}

LONG_TEST(verdicts_and_peaks_converge_with_modes) {
    static const int modes[] = {4, 8, 12, 16};
    for (int c = 0; c < CLAIMS; c++)
        for (int m = 0; m < 4; m++) {
            Response response = converge(&claims[c], modes[m], 20);
            bool periodic = claims[c].verdict == RESPONSE_PERIODIC;
            double margin = modes[m] == 8 ? 0.005 : 0.002; /* of a periodic peak */
            if (modes[m] > 4) {
                CHECK(response.verdict == claims[c].verdict);
                if (claims[c].max > 0)
                    CHECK_NEAR(response.peaks.max, claims[c].max, (periodic ? margin : MAX_MARGIN) * claims[c].max);
            } else if (periodic) { /* four modes are too stiff for the contact: peaks are at least 10 % too high */
                CHECK(response.peaks.max > 1.1 * claims[c].max);
            }
            response_clear(&response);
        }
}

TEST(four_modes_miss_the_chaos_of_set_b) {
    Response response = converge(&claims[2], 4, 20);
    CHECK(response.verdict != RESPONSE_CHAOTIC);
    response_clear(&response);
}

LONG_TEST(verdicts_and_peaks_converge_with_elements) {
    static const int elements[] = {10, 20, 40};
    for (int c = 0; c < CLAIMS; c++) {
        double peak[3];
        for (int e = 0; e < 3; e++) {
            Response response = converge(&claims[c], 12, elements[e]);
            CHECK(response.verdict == claims[c].verdict);
            peak[e] = response.peaks.max;
            response_clear(&response);
        }
        if (claims[c].verdict == RESPONSE_PERIODIC) {
            CHECK_NEAR(peak[0] / peak[2], 1, 2e-3);
            CHECK_NEAR(peak[1] / peak[2], 1, 1e-4);
        }
    }
}
