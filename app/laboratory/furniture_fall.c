#include "laboratory/furniture_fall.h"

#include <math.h>

#include "base/digest.h"
#include "base/random.h"

void furniture_fall_move(FurnitureFall *fall, double seconds) {
    double late = fmin(fall->delay, seconds), part = (seconds - late) / FURNITURE_FALL_SECONDS;
    fall->delay -= late;
    fall->way = real_clamp(fall->way + (fall->piece.toppled ? part : -part), 0, 1);
}

bool furniture_fall_rests(const FurnitureFall *fall) {
    return fall->piece.toppled ? fall->way >= 1 : fall->way <= 0;
}

double furniture_fall_share(const FurnitureFall *fall) {
    return fall->way * fall->way;
}

void furniture_fall_corners(const Furniture *piece, double share, Vec2 corners[4]) {
    Furniture leaning = *piece;
    leaning.toppled = share > 0;
    leaning.height *= share;
    plan_furniture_corners(&leaning, corners);
}

double furniture_fall_height(const Furniture *piece, double share) {
    bool sideways = piece->topples == TOPPLE_LEFT || piece->topples == TOPPLE_RIGHT;
    double depth = sideways ? piece->size.x : piece->size.y;
    return piece->height * sqrt(fmax(0, 1 - share * share)) + depth * share;
}

double furniture_fall_delay(uint64_t seed, const char *id) {
    Random random = random_seed(digest_text(DIGEST_START, id), seed);
    return FURNITURE_FALL_SPREAD * random_uniform(&random);
}
