#include "classroom/judge.h"

#include <pthread.h>
#include <string.h>

#include "base/text.h"
#include "lesson/attempt.h"

typedef struct Question {
    size_t step;
    uint64_t state;
    char *text;
    char *settings[LESSON_SETTINGS_MOST];
    size_t count;
    double answer;
    char *selected;
} Question;

struct Judge {
    Lesson lesson, numbers; /* copies of the two threads, */
    const char *profiles;
    int jobs;
    pthread_t thread, counter; /* the judge's, and that of the numbers, which no question interrupts */
    Stop stop, counter_stop;
    pthread_mutex_t lock; /* of the members below */
    pthread_cond_t changed;
    Question *asked; /* NULL: nothing new */
    Question *done;  /* its goals are judged, or a fault says why not */
    Fault fault;     /* of `done` */
    bool good, working, closing;
    size_t known, taken; /* numbers that were computed, and taken over */
    bool numbered;       /* all were computed */
};

static void question_free(Question *question) {
    if (!question)
        return;
    memory_free(question->text);
    memory_free(question->selected);
    for (size_t i = 0; i < question->count; i++)
        memory_free(question->settings[i]);
    memory_free(question);
}

/* Judges a question without the lock; false: it was given up. */
static bool answer(Judge *judge, const Question *question, Fault *fault) {
    AttemptState state = {.text = question->text,
                          .settings = (const char *const *)question->settings,
                          .setting_count = question->count,
                          .profiles = judge->profiles,
                          .jobs = judge->jobs,
                          .stop = &judge->stop,
                          .person = {.answer = question->answer, .selected = question->selected}};
    return attempt_goal(&judge->lesson, &judge->lesson.steps[question->step], &state, fault);
}

static void note_known(void *context, size_t known) {
    Judge *judge = context;
    pthread_mutex_lock(&judge->lock);
    judge->known = known;
    pthread_mutex_unlock(&judge->lock);
}

static void *find_numbers(void *context) {
    Judge *judge = context;
    AttemptState state = {.profiles = judge->profiles,
                          .jobs = judge->jobs,
                          .stop = &judge->counter_stop,
                          .note = note_known,
                          .context = judge};
    Fault fault = {0};
    bool good = attempt_numbers(&judge->numbers, &state, &fault);
    fault_clear(&fault);
    pthread_mutex_lock(&judge->lock);
    judge->numbered = good;
    pthread_mutex_unlock(&judge->lock);
    return NULL;
}

/* Returns the next question; NULL: there is none yet, or the judge is closing. */
static Question *take_question(Judge *judge) {
    Question *question = judge->asked;
    judge->asked = NULL;
    judge->working = question;
    return question;
}

static void *work(void *context) {
    Judge *judge = context;
    pthread_mutex_lock(&judge->lock);
    while (!judge->closing) {
        Question *question = take_question(judge);
        if (!question) {
            pthread_cond_wait(&judge->changed, &judge->lock);
            continue;
        }
        stop_withdraw(&judge->stop);
        pthread_mutex_unlock(&judge->lock);
        Fault fault = {0};
        bool good = answer(judge, question, &fault);
        pthread_mutex_lock(&judge->lock);
        bool wanted = !judge->asked && !judge->closing && (good || fault.total);
        if (wanted) {
            question_free(judge->done);
            fault_clear(&judge->fault);
            judge->done = question;
            judge->good = good;
            judge->fault = fault;
        } else {
            question_free(question);
            fault_clear(&fault);
        }
        judge->working = false;
    }
    pthread_mutex_unlock(&judge->lock);
    return NULL;
}

/* Ends what judge_create has begun; `threads` of the two. */
static void end(Judge *judge, int threads) {
    pthread_mutex_lock(&judge->lock);
    judge->closing = true;
    stop_request(&judge->stop);
    stop_request(&judge->counter_stop);
    pthread_cond_signal(&judge->changed);
    pthread_mutex_unlock(&judge->lock);
    if (threads > 0)
        pthread_join(judge->thread, NULL);
    if (threads > 1)
        pthread_join(judge->counter, NULL);
    pthread_cond_destroy(&judge->changed);
    pthread_mutex_destroy(&judge->lock);
    question_free(judge->asked);
    question_free(judge->done);
    fault_clear(&judge->fault);
    lesson_free(&judge->lesson);
    lesson_free(&judge->numbers);
    memory_free(judge);
}

Judge *judge_create(const char *path, const char *profiles, int jobs) {
    Judge *judge = memory_zeroed(1, sizeof *judge);
    Fault fault = {0};
    int threads = 0;
    judge->profiles = profiles;
    judge->jobs = jobs;
    bool read = lesson_read(&judge->lesson, path, &fault) && lesson_read(&judge->numbers, path, &fault);
    fault_clear(&fault);
    pthread_mutex_init(&judge->lock, NULL);
    pthread_cond_init(&judge->changed, NULL);
    if (read && pthread_create(&judge->thread, NULL, work, judge) == 0)
        threads++;
    if (threads == 1 && pthread_create(&judge->counter, NULL, find_numbers, judge) == 0)
        return judge;
    end(judge, threads);
    return NULL;
}

void judge_destroy(Judge *judge) {
    if (judge)
        end(judge, 2);
}

void judge_ask(Judge *judge, const JudgeQuestion *asked) {
    Question *question = memory_zeroed(1, sizeof *question);
    *question = (Question){.step = asked->step,
                           .state = asked->state,
                           .text = asked->text ? text_copy(asked->text) : NULL,
                           .count = asked->count,
                           .answer = asked->person.answer,
                           .selected = asked->person.selected ? text_copy(asked->person.selected) : NULL};
    for (size_t i = 0; i < question->count; i++)
        question->settings[i] = text_copy(asked->settings[i]);
    pthread_mutex_lock(&judge->lock);
    question_free(judge->asked);
    judge->asked = question;
    stop_request(&judge->stop);
    pthread_cond_signal(&judge->changed);
    pthread_mutex_unlock(&judge->lock);
}

/* Copies what was found into another copy of the same lesson. */
static void copy_condition(Condition *to, const Condition *from) {
    to->verdict = from->verdict;
    to->value = from->value;
    memcpy(to->note, from->note, sizeof to->note);
}

static void copy_goals(Judge *judge, Lesson *lesson, size_t step) {
    for (size_t g = 0; g < lesson->steps[step].goal_count; g++) {
        Condition *condition = &lesson->steps[step].goals[g].condition;
        copy_condition(condition, &judge->lesson.steps[step].goals[g].condition);
        if (!judge->good)
            condition->verdict = VERDICT_NOT_RUN;
    }
}

JudgeNews judge_take(Judge *judge, Lesson *lesson, Fault *fault) {
    pthread_mutex_lock(&judge->lock);
    JudgeNews news = {.counted = judge->taken < judge->known, .numbered = judge->numbered};
    for (; judge->taken < judge->known; judge->taken++)
        copy_condition(&lesson->numbers[judge->taken].condition, &judge->numbers.numbers[judge->taken].condition);
    Question *done = judge->working ? NULL : judge->done; /* the thread may be writing into the goals */
    if (done) {
        news.judged = true;
        news.step = done->step;
        news.state = done->state;
        copy_goals(judge, lesson, done->step);
        for (size_t i = 0; i < judge->fault.count; i++)
            fault_add(fault, "%s", judge->fault.lines[i]);
        fault_clear(&judge->fault);
        question_free(done);
        judge->done = NULL;
    }
    pthread_mutex_unlock(&judge->lock);
    return news;
}
