#include "mechanics/broadphase.h"

#include <algorithm>
#include <box2d/b2_dynamic_tree.h>
#include <cstdint>
#include <new>

extern "C" {
#include "base/memory.h"
}

struct Broadphase {
    b2DynamicTree tree;
};

namespace {

b2AABB single_precision(Box box) {
    b2AABB aabb;
    aabb.lowerBound.Set(static_cast<float>(box.low.x), static_cast<float>(box.low.y));
    aabb.upperBound.Set(static_cast<float>(box.high.x), static_cast<float>(box.high.y));
    return aabb;
}

int item_of(const b2DynamicTree &tree, int32 proxy) {
    return static_cast<int>(reinterpret_cast<intptr_t>(tree.GetUserData(proxy)));
}

struct Visitor {
    const b2DynamicTree &tree;
    bool (*visit)(void *, int);
    void *context;
    bool QueryCallback(int32 proxy) {
        return visit(context, item_of(tree, proxy));
    }
};

struct Collector {
    const b2DynamicTree &tree;
    int *items;
    size_t capacity, count;
    bool QueryCallback(int32 proxy) {
        if (count < capacity)
            items[count] = item_of(tree, proxy);
        count++;
        return true;
    }
};

struct Caster {
    const b2DynamicTree &tree;
    double (*hit)(void *, int, Vec2, Vec2, double);
    void *context;
    Vec2 from, to;
    double best;
    float RayCastCallback(const b2RayCastInput &, int32 proxy) {
        best = std::min(best, hit(context, item_of(tree, proxy), from, to, best));
        return best > 0 ? static_cast<float>(best) : 0.0f;
    }
};

} // namespace

/* These two replace Box2D's functions of the same names, which do not check for exhausted memory. */
void *b2Alloc_Default(int32 size) {
    return memory_zeroed(static_cast<size_t>(size), 1);
}

void b2Free_Default(void *block) {
    memory_free(block);
}

void broadphase_use_memory(void) {
    std::set_new_handler(memory_end);
}

Broadphase *broadphase_create(void) {
    return new Broadphase;
}

void broadphase_destroy(Broadphase *broadphase) {
    delete broadphase;
}

void broadphase_insert(Broadphase *broadphase, Box box, int item) {
    broadphase->tree.CreateProxy(single_precision(box), reinterpret_cast<void *>(static_cast<intptr_t>(item)));
}

void broadphase_visit(const Broadphase *broadphase, Box box, bool (*visit)(void *context, int item), void *context) {
    Visitor visitor{broadphase->tree, visit, context};
    broadphase->tree.Query(&visitor, single_precision(box));
}

size_t broadphase_query(const Broadphase *broadphase, Box box, int *items, size_t capacity) {
    Collector collector{broadphase->tree, items, capacity, 0};
    broadphase->tree.Query(&collector, single_precision(box));
    std::sort(items, items + std::min(collector.count, capacity));
    return collector.count;
}

double broadphase_ray(const Broadphase *broadphase, Vec2 from, Vec2 to,
                      double (*hit)(void *context, int item, Vec2 from, Vec2 to, double best), void *context) {
    b2RayCastInput input;
    input.p1.Set(static_cast<float>(from.x), static_cast<float>(from.y));
    input.p2.Set(static_cast<float>(to.x), static_cast<float>(to.y));
    input.maxFraction = 1.0f;
    if ((input.p2 - input.p1).LengthSquared() <= b2_epsilon * b2_epsilon) // the tree asserts on a ray of no length
        return 1;
    Caster caster{broadphase->tree, hit, context, from, to, 1};
    broadphase->tree.RayCast(&caster, input);
    return caster.best;
}
