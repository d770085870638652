#include "visual/house/furniture_fall.h"

#include <math.h>

#include "base/digest.h"
#include "base/random.h"
#include "plan/plan_geometry.h"

void furniture_fall_move(FurnitureFall *fall, double seconds) {
    double late = fmin(fall->delay, seconds), part = (seconds - late) / FURNITURE_FALL_SECONDS;
    fall->delay -= late;
    fall->way = real_clamp(fall->way + (fall->piece.toppled ? part : -part), 0, 1);
}

bool furniture_fall_is_over(const FurnitureFall *fall) {
    return fall->piece.toppled ? fall->way >= 1 : fall->way <= 0;
}

double furniture_fall_share(const FurnitureFall *fall) {
    return fall->way * fall->way;
}

void furniture_fall_corners(const Furniture *piece, double share, Vec2 corners[4]) {
    Furniture leaning = *piece;
    leaning.toppled = share > 0;
    leaning.height *= share;
    plan_geometry_corners(&leaning, corners);
}

static double depth_of(const Furniture *piece) {
    bool sideways = piece->topples == TOPPLE_LEFT || piece->topples == TOPPLE_RIGHT;
    return sideways ? piece->size.x : piece->size.y;
}

static double cosine(double share) {
    return sqrt(fmax(0, 1 - share * share));
}

double furniture_fall_height(const Furniture *piece, double share) {
    return piece->height * cosine(share) + depth_of(piece) * share;
}

void furniture_fall_cut(const Furniture *piece, double share, double height, double *from, double *to) {
    double depth = depth_of(piece), along = cosine(share);
    Vec2 up = vec2(piece->height * share, piece->height * along), back = vec2(-depth * along, depth * share);
    Vec2 corners[] = {{0, 0}, up, vec2_add(up, back), back};
    *from = HUGE_VAL;
    *to = -HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        Vec2 a = corners[i], b = corners[(i + 1) % 4];
        if ((a.y > height) == (b.y > height))
            continue;
        double x = a.x + (b.x - a.x) * (height - a.y) / (b.y - a.y);
        *from = fmin(*from, x);
        *to = fmax(*to, x);
    }
}

double furniture_fall_delay(uint64_t seed, const char *id) {
    Random random = random_seed(digest_text(DIGEST_START, id), seed);
    return FURNITURE_FALL_SPREAD * random_uniform(&random);
}
