#include "inquiry/condition.h"

#include <math.h>
#include <string.h>

#include "base/text.h"
#include "plan/plan.h"

enum { NAMES_MOST = 128 };

const Measure *condition_find(Condition *condition, const char *const *more, size_t more_count, const JsonNode *node,
                              Fault *fault) {
    size_t count;
    const Measure *measures = measure_table(&count);
    condition->measure = measure_find(condition->measure_name);
    if (condition->measure)
        return condition->measure;
    const char *names[NAMES_MOST];
    size_t known = 0;
    for (size_t m = 0; m < count && known < NAMES_MOST; m++)
        names[known++] = measures[m].name;
    for (size_t m = 0; m < more_count && known < NAMES_MOST; m++)
        names[known++] = more[m];
    JsonNode name = json_member(node, "measure");
    const char *nearest = text_nearest(condition->measure_name, names, known);
    if (nearest)
        json_fault(&name, fault, "unknown measure \"%.40s\", did you mean \"%s\"?", condition->measure_name, nearest);
    else
        json_fault(&name, fault, "unknown measure \"%.40s\"", condition->measure_name);
    return NULL;
}

void condition_check_unit(const Condition *condition, const char *expected, const JsonNode *node, Fault *fault) {
    JsonNode unit = json_member(node, "unit");
    if (strcmp(condition->unit, expected) != 0)
        json_fault(&unit, fault, "unit is \"%.20s\", must be \"%s\"", condition->unit, expected);
}

void condition_check_limits(const Condition *condition, const char *what, const JsonNode *node, Fault *fault) {
    if (condition->low == -HUGE_VAL && condition->high == HUGE_VAL)
        json_fault(node, fault, "%s needs \"low\" or \"high\"", what);
    if (condition->low > condition->high)
        json_fault(node, fault, "low is %g, must be at most high, %g", condition->low, condition->high);
}

void condition_check_needs(const Condition *condition, const JsonNode *node, Fault *fault) {
    const MeasureQuestion *question = &condition->question;
    int needs = condition->measure->needs;
    const char *name = condition->measure->name;
    if ((needs & MEASURE_GATE) && !*question->exit == !question->line.count)
        json_fault(node, fault, "%s needs an \"exit\" or a \"line\", one of the two", name);
    if ((needs & MEASURE_EXIT) && !*question->exit)
        json_fault(node, fault, "%s needs an \"exit\"", name);
    if ((needs & MEASURE_AREA) && !question->area.count)
        json_fault(node, fault, "%s needs an \"area\"", name);
    if ((needs & MEASURE_WINDOW) && !(question->until > question->from))
        json_fault(node, fault, "%s needs a time, \"until\" after \"from\"", name);
    if ((needs & MEASURE_PAST) && !question->past.count)
        json_fault(node, fault, "%s needs the people who are overtaken, \"past\"", name);
    if (question->line.count > 2)
        json_fault(node, fault, "line has %zu points, must have two", question->line.count);
    if (question->last <= question->first)
        json_fault(node, fault, "last is %g, must be more than first, %g", question->last, question->first);
}

static bool has_id(const Plan *plan, const char *id) {
    for (size_t c = 0; c < plan->crowd_count; c++)
        if (strcmp(plan->crowds[c].id, id) == 0)
            return true;
    return plan_find_person(plan, id) != SIZE_MAX;
}

static bool has_exit(const Plan *plan, const char *id) {
    for (size_t e = 0; e < plan->exit_count; e++)
        if (strcmp(plan->exits[e].id, id) == 0)
            return true;
    return false;
}

void condition_check_people(const Ids *ids, const char *key, const Plan *plan, const JsonNode *node, Fault *fault) {
    JsonNode list = json_member(node, key);
    for (size_t i = 0; i < ids->count; i++) {
        JsonNode element = json_element(&list, i);
        if (!has_id(plan, ids->at[i]))
            json_fault(&element, fault, "there is no person or crowd \"%.60s\" in %.100s", ids->at[i], plan->name);
    }
}

void condition_check_exit(const Condition *condition, const Plan *plan, const JsonNode *node, Fault *fault) {
    JsonNode exit = json_member(node, "exit");
    const char *id = condition->question.exit;
    if (*id && !has_exit(plan, id))
        json_fault(&exit, fault, "there is no exit \"%.60s\" in %.100s", id, plan->name);
}

void condition_judge(Condition *condition, double value) {
    condition->value = value;
    condition->verdict = value >= condition->low && value <= condition->high ? VERDICT_PASSED : VERDICT_FAILED;
}
