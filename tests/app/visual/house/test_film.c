/* Tests films: a picture shows the record at its time, regardless of earlier pictures; personal spaces end at
 * obstacles. */

#include "visual/house/film.h"

#include <string.h>

#include "base/text.h"
#include "case.h"
#include "check.h"
#include "visual/house/density_scene.h"
#include "visual/house/house_scene.h"
#include "visual/house/silhouette.h"
#include "visual/house/space_scene.h"
#include "visual/house/trail.h"

/* A house after a run. */
typedef struct Shown {
    House house;
    Observation observation;
    Film *film;
} Shown;

static void show_with(Shown *shown, const char *name, const char *const *settings, FilmOptions options) {
    *shown = (Shown){.film = NULL};
    case_house(&shown->house, name, -1, settings);
    shown->observation = case_run(&shown->house, 1);
    shown->film = film_create(&shown->house, &shown->observation, &options);
}

static void show(Shown *shown, const char *name, FilmOptions options) {
    show_with(shown, name, NULL, options);
}

static void hide(Shown *shown) {
    film_destroy(shown->film);
    observation_free(&shown->observation);
    house_free(&shown->house);
}

/* Counts the primitives of a kind and role; `*last` is the index of the last one. */
static size_t count_of(const Scene *scene, PrimitiveKind kind, Role edge, size_t *last) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == kind && scene->primitives[i].edge == edge) {
            count++;
            if (last)
                *last = i;
        }
    return count;
}

static double line_length(const Primitive *line) {
    double length = 0;
    for (size_t i = 1; i < line->count; i++)
        length += vec2_distance(line->points[i - 1], line->points[i]);
    return length;
}

TEST(words_say_what_is_shown) {
    const char *unknown;
    CHECK(film_shown("", &unknown) == 0);
    CHECK(film_shown("circles", &unknown) == FILM_CIRCLES);
    CHECK(film_shown("widths,circles", &unknown) == (FILM_WIDTHS | FILM_CIRCLES));
    CHECK(film_shown("routes,round,circles", &unknown) == -1);
    CHECK(strncmp(unknown, "round", 5) == 0);
    CHECK(film_shown("route", &unknown) == -1);
}

/* Returns the input that a painter adds, as text. */
static void list_added(Text *text, const Scene *added) {
    char line[128];
    for (size_t i = 0; i < added->count; i++) {
        const Primitive *primitive = &added->primitives[i];
        snprintf(line, sizeof line, "%d %d %zu %.9f %.9f %.9f\n", primitive->kind, primitive->edge, primitive->count,
                 primitive->points[0].x, primitive->points[0].y, primitive->begun);
        text_add(text, line);
    }
}

/* A film adds the same primitives in the same order for any sequence of times. */
/* A window shows people from the first picture on, though nothing of them is recorded yet; a film does not. */
TEST(people_stand_at_their_starts_until_they_are_recorded) {
    House house;
    case_house(&house, "ube-techno-house", -1, NULL);
    PersonObservation *people = memory_zeroed(house.person_count, sizeof *people);
    double *opened = memory_zeroed(house.plan.door_count, sizeof *opened);
    for (size_t i = 0; i < house.person_count; i++)
        people[i].took_part = i != 1;
    Trail *trails = memory_zeroed(house.person_count, sizeof *trails);
    Observation empty = {.people = people,
                         .person_count = house.person_count,
                         .door_opened = opened,
                         .dt = house.plan.run.dt,
                         .sample = 0.1};
    for (int live = 0; live < 2; live++) {
        Film *film = film_create(&house, &empty, &(FilmOptions){.live = live, .trails = trails});
        const Scene *moving = (film_show(film, 0), film_moving(film));
        size_t bodies = 0;
        for (size_t p = 0; p < moving->count; p++)
            for (size_t i = 0; i < house.person_count; i++) {
                const Primitive *name = &moving->primitives[p];
                Vec2 middle = silhouette_middle(house.people[i].profile, house.people[i].at, house.people[i].heading);
                bodies += name->kind == PRIMITIVE_LABEL && vec2_distance(name->points[0], middle) < 1e-9;
            }
        CHECK(bodies == (live ? house.person_count - 1 : 0));
        film_destroy(film);
    }
    memory_free(trails);
    memory_free(opened);
    memory_free(people);
    house_free(&house);
}

TEST(what_comes_does_not_depend_on_when_one_looks) {
    static const double steps[] = {1.0 / 60, 1.0 / 30, 0.04, 0.37, 5, 100};
    static const char *const houses[] = {"closed-door", "two-chairs-corridor", "ube-techno-house"};
    for (size_t h = 0; h < sizeof houses / sizeof *houses; h++) {
        Text first = {0};
        Shown shown;
        show(&shown, houses[h], (FilmOptions){.panels = 0});
        for (size_t s = 0; s < sizeof steps / sizeof *steps; s++) {
            Text now = {0};
            CHECK(film_show(shown.film, 0) == (s == 0)); /* back to the beginning */
            list_added(&now, film_added(shown.film));
            for (double time = steps[s]; time < shown.observation.time; time += steps[s]) {
                CHECK(film_show(shown.film, time));
                list_added(&now, film_added(shown.film));
            }
            CHECK(film_show(shown.film, shown.observation.time));
            list_added(&now, film_added(shown.film));
            if (s == 0)
                first = now;
            else
                CHECK(strcmp(first.text, now.text) == 0);
            if (s > 0)
                memory_free(now.text);
        }
        memory_free(first.text);
        hide(&shown);
    }
}

/* The pieces of a locus are as long as the path, and each begins at the end of the previous one. */
TEST(a_locus_grows_into_the_whole_way) {
    Shown shown;
    show(&shown, "closed-door", (FilmOptions){.panels = 0});
    film_show(shown.film, shown.observation.time);
    const Scene *added = film_added(shown.film);
    double length = 0;
    Vec2 end = added->primitives[0].points[0];
    for (size_t i = 0; i < added->count; i++) {
        const Primitive *piece = &added->primitives[i];
        if (piece->kind != PRIMITIVE_LINE || piece->edge != ROLE_LOCUS)
            continue;
        if (length > 0)
            CHECK(vec2_distance(end, piece->points[0]) == 0);
        CHECK_NEAR(piece->begun, length, 1e-9);
        length = piece->begun + line_length(piece);
        end = piece->points[1];
    }
    size_t ticks = count_of(added, PRIMITIVE_TICK, ROLE_LOCUS, NULL);
    CHECK_NEAR(length, shown.observation.people[0].path_length, 0.01);
    CHECK(ticks > shown.observation.time / 2 && ticks <= shown.observation.time);
    hide(&shown);
}

/* A time gives the same picture after any other time. */
TEST(any_time_can_be_shown_in_any_order) {
    Shown shown;
    show(&shown, "two-chairs-corridor", (FilmOptions){.shown = FILM_CIRCLES});
    film_show(shown.film, 7);
    size_t count = film_moving(shown.film)->count;
    const Primitive *ring = &film_moving(shown.film)->primitives[0];
    Vec2 first[SILHOUETTE_EDGE];
    CHECK(ring->kind == PRIMITIVE_POLYGON && ring->count == SILHOUETTE_EDGE);
    memcpy(first, ring->points, sizeof first);
    film_show(shown.film, 12);
    CHECK(memcmp(first, film_moving(shown.film)->primitives[0].points, sizeof first) != 0);
    film_show(shown.film, 7);
    CHECK(film_moving(shown.film)->count == count);
    CHECK(memcmp(first, film_moving(shown.film)->primitives[0].points, sizeof first) == 0);
    hide(&shown);
}

/* The leaf's free end bars the corridor until the door is opened. */
TEST(a_door_is_seen_to_open) {
    Shown shown;
    show(&shown, "closed-door", (FilmOptions){.panels = 0});
    double opened = shown.observation.door_opened[0];
    static const struct { double after, angle; } times[] = {{-3, 0}, {-0.8, 0}, {-0.4, 45}, {0, 90}, {2, 90}};
    for (size_t i = 0; i < sizeof times / sizeof *times; i++) {
        film_show(shown.film, opened + times[i].after);
        const Scene *moving = film_moving(shown.film);
        size_t leaf = SIZE_MAX;
        for (size_t p = 0; p < moving->count; p++)
            if (moving->primitives[p].edge == ROLE_DOOR && moving->primitives[p].height > 0)
                leaf = p;
        CHECK(leaf != SIZE_MAX);
        Vec2 way = vec2_sub(moving->primitives[leaf].points[1], moving->primitives[leaf].points[0]);
        CHECK_NEAR(degrees(fabs(atan2(way.x, way.y))), times[i].angle, 4); /* the wall runs along y */
    }
    for (size_t p = 0; p < film_still(shown.film)->count; p++)
        CHECK(film_still(shown.film)->primitives[p].edge != ROLE_DOOR || film_still(shown.film)->primitives[p].text[0]);
    hide(&shown);
}

/* Returns the ring of the `own`-th chair in the picture. */
static const Primitive *find_ring(const Scene *moving, size_t own) {
    for (size_t p = 0; p < moving->count; p++)
        if (moving->primitives[p].kind == PRIMITIVE_POLYGON && moving->primitives[p].count == SILHOUETTE_EDGE &&
            own-- == 0)
            return &moving->primitives[p];
    return NULL;
}

/* Contacts are marked at their place and time, with their force. */
TEST(a_touch_is_seen_where_it_is) {
    Shown shown;
    show_with(&shown, "corner-1.20-0.80", case_touching, (FilmOptions){.panels = 0});
    const PersonObservation *person = &shown.observation.people[0];
    CHECK(person->contacts > 0);
    Trail *trail = trail_list(&shown.observation);
    const double *hardest = trail_hardest(trail, -1, shown.observation.time);
    CHECK_NEAR(hardest[TRACE_BODY_FORCE], person->peak_force, 0);
    film_show(shown.film, hardest[TRACE_TIME]);
    size_t burst = 0;
    CHECK(count_of(film_moving(shown.film), PRIMITIVE_POLYGON, ROLE_WALL, NULL) > 0);
    for (size_t p = 0; p < film_moving(shown.film)->count; p++)
        if (film_moving(shown.film)->primitives[p].fill == ROLE_DANGER_MIDDLE &&
            film_moving(shown.film)->primitives[p].kind == PRIMITIVE_POLYGON)
            burst = p;
    const Primitive *star = &film_moving(shown.film)->primitives[burst];
    Vec2 middle = {0, 0};
    for (size_t i = 0; i < star->count; i++)
        middle = vec2_along(middle, 1.0 / (double)star->count, star->points[i]);
    CHECK_NEAR(vec2_distance(middle, person->peak_at), 0, 1e-9);
    trail_free_list(trail);
    hide(&shown);
}

TEST(the_answer_of_a_film_and_of_its_comparison_has_the_grade) {
    Grade now = {.letter = GRADE_B}, then = {.letter = GRADE_D};
    Shown shown;
    show(&shown, "corner-1.20-1.20", (FilmOptions){.letters = &now});
    const char *title = film_still(shown.film)->title, *detail = film_still(shown.film)->detail;
    CHECK(strstr(title, "Out in ") && strstr(title, ", grade B"));
    CHECK(strncmp(detail, "with care; ", strlen("with care; ")) == 0);
    const Before before = {.house = &shown.house, .observation = &shown.observation, .letters = &then};
    Film *film = film_create(&shown.house, &shown.observation, &(FilmOptions){.letters = &now, .before = before});
    detail = film_still(film)->detail;
    CHECK(strstr(detail, "before: Out in ") && strstr(detail, ", grade D; now: with care"));
    film_destroy(film);
    hide(&shown);
}

/* In a crowd each person still inside is shown once, and the exits count the others. */
TEST(a_crowd_is_counted_out) {
    House house;
    json_t *plan = case_corridor(3);
    for (int i = 0; i < 40; i++)
        case_add_person(plan, "adult", 1 + 0.5 * (i % 10), -1 + 0.6 * (i / 10), 0);
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    CHECK(observation.completed);
    Film *film = film_create(&house, &observation, &(FilmOptions){.panels = 0});
    for (double time = 0; time <= observation.time; time += 1.7) {
        size_t inside = 0, shown = 0;
        for (size_t i = 0; i < house.person_count; i++)
            inside += observation.people[i].time >= time;
        film_show(film, time);
        const char *text = "";
        for (size_t p = 0; p < film_moving(film)->count; p++) {
            const Primitive *primitive = &film_moving(film)->primitives[p];
            shown += primitive->kind == PRIMITIVE_DISC ? primitive->count : 0;
            text = primitive->kind == PRIMITIVE_LABEL ? primitive->text : text;
        }
        char expected[32];
        size_t out = house.person_count - inside;
        snprintf(expected, sizeof expected, "EXIT: %s%zu", out < 10 ? "\u2007" : "", out);
        CHECK(shown == inside);
        CHECK_TEXT(text, expected);
    }
    observation.people[0].exit = SIZE_MAX; /* by an exit that an edit has since removed */
    film_show(film, observation.time);
    film_destroy(film);
    observation_free(&observation);
    house_free(&house);
}

/* Loci of walkers would be darker together than the colours that show how crowded a place is. */
TEST(no_locus_of_a_walker_lies_below_the_density) {
    House house;
    json_t *plan = case_corridor(8);
    for (int i = 0; i < DENSITY_SCENE_PEOPLE; i++)
        case_add_person(plan, "adult", 1 + 0.5 * (i % 20), -3 + 0.6 * (i / 20), 0);
    case_made(&house, plan, -1, NULL);
    Observation observation = case_run(&house, 1);
    for (int hidden = 0; hidden <= FILM_RINGS; hidden += FILM_RINGS) {
        Film *film = film_create(&house, &observation, &(FilmOptions){.hidden = hidden});
        film_show(film, observation.time / 2);
        CHECK((count_of(film_added(film), PRIMITIVE_LINE, ROLE_WALKER, NULL) > 0) == (hidden == FILM_RINGS));
        film_destroy(film);
    }
    observation_free(&observation);
    house_free(&house);
}

/* The list names people by the rooms where they start, and by their exits where two who start in one room differ. */
TEST(people_of_one_room_are_told_apart_by_their_exits) {
    Shown shown;
    for (int same = 0; same < 2; same++) {
        show(&shown, "two-chairs-corridor", (FilmOptions){.panels = 0});
        if (same)
            shown.observation.people[0].exit = shown.observation.people[1].exit;
        Scene scene = {0};
        house_scene_make(&scene, &shown.house, &shown.observation);
        const char *names[2] = {0};
        for (size_t i = 0, k = 0; i < scene.row_count && k < 2; i++)
            if (scene.rows[i].kind == ROW_LINE && scene.rows[i].mark)
                names[k++] = scene.rows[i].cells[0];
        CHECK_TEXT(names[0], same ? "corridor" : "corridor, to east");
        CHECK_TEXT(names[1], same ? "corridor" : "corridor, to west");
        scene_clear(&scene);
        hide(&shown);
    }
}

static Profile chair(void) {
    return (Profile){.driving = DRIVING_DRIVER,
                     .length = 1.1,
                     .width = 0.63,
                     .axle = 0.28,
                     .corner_radius = 0.05,
                     .space_reach = 0.3};
}

/* Points of the edge lie on the outline, with normals pointing outwards. */
TEST(the_edge_is_the_outlines) {
    Profile profiles[] = {chair(), chair()};
    profiles[1].driving = DRIVING_MIURA;
    for (int k = 0; k < 2; k++) {
        EdgePoint edge[SILHOUETTE_EDGE];
        Vec2 outline[SILHOUETTE_POINTS];
        silhouette_edge(&profiles[k], vec2(3, 1), 0.7, edge);
        silhouette_outline(&profiles[k], vec2(3, 1), 0.7, 0.3, outline);
        for (int i = 0; i < SILHOUETTE_EDGE; i++) {
            CHECK_NEAR(vec2_length(edge[i].normal), 1, 1e-12);
            double out = silhouette_ray(outline, SILHOUETTE_POINTS, edge[i].at, edge[i].normal, 1);
            CHECK(out <= 0.3 + 1e-9 && out > 0.3 - 0.02); /* the outline's corners are polygons */
        }
    }
}

/* In a corridor the personal space is as wide as the corridor, in the open as wide as its radius. */
TEST(a_space_ends_at_the_wall) {
    static const double widths[] = {0.7, 0.9, 1.1, 1.23, 1.5, 3};
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        House house;
        case_made(&house, case_corridor(widths[k]), -1, NULL);
        Profile profile = chair();
        Scene scene = {0};
        Standing standing = {.profile = &profile, .pose = {.at = {8, 0}}};
        space_scene_add(&scene, &house, NULL, &standing, 1, 0);
        Box box = box_empty();
        for (size_t i = 0; i < scene.primitives[0].count; i++)
            box = box_include(box, scene.primitives[0].points[i]);
        CHECK_NEAR(box.high.y - box.low.y, fmin(widths[k], 0.63 + 0.6), 1e-6);
        CHECK_NEAR(box.high.x - box.low.x, 1.1 + 0.6, 1e-6);
        scene_clear(&scene);
        house_free(&house);
    }
}

/* Two neighbours share the gap between them; people who run alone do not affect each other. */
TEST(a_space_ends_at_somebody_elses_body) {
    House house;
    case_made(&house, case_corridor(5), -1, NULL);
    Profile profile = chair();
    static const struct {
        double apart, edge;
        size_t group;
    } cases[] = {{0.8, 0.8 - 0.315, 0}, {0.8, 0.315 + 0.3, 1}, {0.62, 0.315, 0} /* one presses the other */};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        Scene scene = {0};
        Standing all[] = {{.profile = &profile, .pose = {.at = {8, 0}}},
                          {.profile = &profile, .pose = {.at = {8, cases[k].apart}}, .group = cases[k].group}};
        space_scene_add(&scene, &house, NULL, all, 2, 0);
        double highest = 0;
        for (size_t i = 0; i < scene.primitives[0].count; i++)
            if (fabs(scene.primitives[0].points[i].x - 8.2) < 0.3)
                highest = fmax(highest, scene.primitives[0].points[i].y);
        CHECK_NEAR(highest, cases[k].edge, 1e-6);
        scene_clear(&scene);
    }
    house_free(&house);
}

/* The space ends at a shut door and no longer at an open one. */
TEST(a_space_ends_at_a_shut_door) {
    Shown shown;
    show(&shown, "closed-door", (FilmOptions){.panels = 0});
    const Plan *plan = &shown.house.plan;
    const Wall *wall = &plan->walls[plan->doors[0].wall_index];
    Vec2 from = wall->points.at[plan->doors[0].segment], to = wall->points.at[plan->doors[0].segment + 1];
    for (int open = 0; open <= 1; open++) {
        double beyond = 0;
        film_show(shown.film, shown.observation.door_opened[0] + (open ? 0.5 : -0.5));
        const Primitive *ring = find_ring(film_moving(shown.film), 0);
        double own = vec2_cross(vec2_sub(to, from), vec2_sub(shown.house.people[0].at, from));
        for (size_t i = 0; i < ring->count; i++) {
            double across = vec2_cross(vec2_sub(to, from), vec2_sub(ring->points[i], from)) / vec2_distance(from, to);
            beyond = fmax(beyond, own < 0 ? across : -across);
        }
        CHECK(open ? beyond > 0.1 : beyond <= 1e-9);
    }
    hide(&shown);
}

/* Every part of a figure lies within the body of the simulation. */
TEST(a_figure_stays_within_its_body) {
    Profile profiles[] = {chair(), chair(), chair()};
    profiles[1].driving = DRIVING_MIURA;
    profiles[2].length = 1.4;
    profiles[2].width = 0.7;
    profiles[2].axle = 0.4;
    for (int k = 0; k < 3; k++) {
        Scene scene = {0};
        Vec2 outline[SILHOUETTE_POINTS];
        Pose pose = {.at = {2, 3}, .heading = 1.1};
        silhouette_add_chair(&scene, &profiles[k], pose, ROLE_CHAIR);
        silhouette_outline(&profiles[k], pose.at, pose.heading, 0.02, outline);
        Vec2 middle = silhouette_middle(&profiles[k], pose.at, pose.heading);
        for (size_t p = 0; p < scene.count; p++)
            for (size_t i = 0; i < scene.primitives[p].count; i++) {
                Vec2 way = vec2_sub(scene.primitives[p].points[i], middle);
                double edge = silhouette_ray(outline, SILHOUETTE_POINTS, middle, vec2_unit(way), 5);
                CHECK(edge < 5 && vec2_length(way) <= edge);
            }
        scene_clear(&scene);
    }
}

/* Returns the number of discs and balls in a scene. */
static size_t round_marks(const Scene *scene) {
    size_t count = 0;
    for (size_t i = 0; i < scene->count; i++)
        if (scene->primitives[i].kind == PRIMITIVE_DISC || scene->primitives[i].kind == PRIMITIVE_BALL)
            count += scene->primitives[i].count;
    return count;
}

TEST(many_small_people_are_one_dot_each) {
    enum { MANY = SILHOUETTE_HEADINGS + 500 };
    Profile adult = {.name = "adult", .driving = DRIVING_WALKER, .width = 0.5};
    Pose *poses = memory_zeroed(MANY, sizeof *poses);
    for (size_t i = 0; i < MANY; i++)
        poses[i].at = vec2((double)(i % 50), (double)(i / 50));
    for (int dots = 0; dots < 2; dots++) {
        Scene scene = {.box = {{0, 0}, {50, 40}}};
        silhouette_add_walkers(&scene, &adult, poses, MANY, dots);
        CHECK(round_marks(&scene) == (dots ? 1 : 2) * (size_t)MANY);
        scene_clear(&scene);
    }
    memory_free(poses);
}
