#include "crank/stepper.h"

#include <math.h>
#include <string.h>

#include "base/real.h"

enum { STAGES = STEPPER_EVALUATIONS };

/* One product of a stage's sum. */
typedef struct Weight {
    size_t stage;
    double value;
} Weight;

enum { WEIGHTS_MOST = 9 /* at most as many in a sum; the rest are of stage 0 and value 0 */ };

typedef struct Sum {
    size_t count;
    Weight weights[WEIGHTS_MOST];
} Sum;

/* Instants of the stages, as parts of the step. */
static const double instants[STAGES] = {0,
                                        0.526001519587677318785587544488e-1,
                                        0.789002279381515978178381316732e-1,
                                        0.118350341907227396726757197510,
                                        0.281649658092772603273242802490,
                                        1.0 / 3,
                                        0.25,
                                        4.0 / 13,
                                        0.651282051282051282051282051282,
                                        0.6,
                                        6.0 / 7,
                                        1};

/* Each stage's state is the step's beginning plus the step times such a sum of earlier rates. */
static const Sum stages[STAGES] = {
    {0},
    {1, {{0, 5.26001519587677318785587544488e-2}}},
    {2, {{0, 1.97250569845378994544595329183e-2}, {1, 5.91751709536136983633785987549e-2}}},
    {2, {{0, 2.95875854768068491816892993775e-2}, {2, 8.87627564304205475450678981324e-2}}},
    {3,
     {{0, 2.41365134159266685502369798665e-1},
      {2, -8.84549479328286085344864962717e-1},
      {3, 9.24834003261792003115737966543e-1}}},
    {3,
     {{0, 3.7037037037037037037037037037e-2},
      {3, 1.70828608729473871279604482173e-1},
      {4, 1.25467687566822425016691814123e-1}}},
    {4,
     {{0, 3.7109375e-2},
      {3, 1.70252211019544039314978060272e-1},
      {4, 6.02165389804559606850219397283e-2},
      {5, -1.7578125e-2}}},
    {5,
     {{0, 3.70920001185047927108779319836e-2},
      {3, 1.70383925712239993810214054705e-1},
      {4, 1.07262030446373284651809199168e-1},
      {5, -1.53194377486244017527936158236e-2},
      {6, 8.27378916381402288758473766002e-3}}},
    {6,
     {{0, 6.24110958716075717114429577812e-1},
      {3, -3.36089262944694129406857109825},
      {4, -8.68219346841726006818189891453e-1},
      {5, 2.75920996994467083049415600797e1},
      {6, 2.01540675504778934086186788979e1},
      {7, -4.34898841810699588477366255144e1}}},
    {7,
     {{0, 4.77662536438264365890433908527e-1},
      {3, -2.48811461997166764192642586468},
      {4, -5.90290826836842996371446475743e-1},
      {5, 2.12300514481811942347288949897e1},
      {6, 1.52792336328824235832596922938e1},
      {7, -3.32882109689848629194453265587e1},
      {8, -2.03312017085086261358222928593e-2}}},
    {8,
     {{0, -9.3714243008598732571704021658e-1},
      {3, 5.18637242884406370830023853209},
      {4, 1.09143734899672957818500254654},
      {5, -8.14978701074692612513997267357},
      {6, -1.85200656599969598641566180701e1},
      {7, 2.27394870993505042818970056734e1},
      {8, 2.49360555267965238987089396762},
      {9, -3.0467644718982195003823669022}}},
    {9,
     {{0, 2.27331014751653820792359768449},
      {3, -1.05344954667372501984066689879e1},
      {4, -2.00087205822486249909675718444},
      {5, -1.79589318631187989172765950534e1},
      {6, 2.79488845294199600508499808837e1},
      {7, -2.85899827713502369474065508674},
      {8, -8.87285693353062954433549289258},
      {9, 1.23605671757943030647266201528e1},
      {10, 6.43392746015763530355970484046e-1}}},
};

/* The step of order 8. */
static const Sum whole = {8,
                          {{0, 5.42937341165687622380535766363e-2},
                           {5, 4.45031289275240888144113950566},
                           {6, 1.89151789931450038304281599044},
                           {7, -5.8012039600105847814672114227},
                           {8, 3.1116436695781989440891606237e-1},
                           {9, -1.52160949662516078556178806805e-1},
                           {10, 2.01365400804030348374776537501e-1},
                           {11, 4.47106157277725905176885569043e-2}}};

/* Its error by the embedded method of order 5. */
static const Sum fifth = {8,
                          {{0, 0.1312004499419488073250102996e-1},
                           {5, -0.1225156446376204440720569753e1},
                           {6, -0.4957589496572501915214079952},
                           {7, 0.1664377182454986536961530415e1},
                           {8, -0.3503288487499736816886487290},
                           {9, 0.3341791187130174790297318841},
                           {10, 0.8192320648511571246570742613e-1},
                           {11, -0.2235530786388629525884427845e-1}}};

/* Its error by the embedded method of order 3: the step's weights without those of that method. */
static const Sum third = {8,
                          {{0, 5.42937341165687622380535766363e-2 - 0.244094488188976377952755905512},
                           {5, 4.45031289275240888144113950566},
                           {6, 1.89151789931450038304281599044},
                           {7, -5.8012039600105847814672114227},
                           {8, 3.1116436695781989440891606237e-1 - 0.733846688281611857341361741547},
                           {9, -1.52160949662516078556178806805e-1},
                           {10, 2.01365400804030348374776537501e-1},
                           {11, 4.47106157277725905176885569043e-2 - 0.220588235294117647058823529412e-1}}};

/* Safety of the next step's length, and its least and most as a part of this one. */
static const double SAFETY = 0.9, SHRINK = 0.2, GROW = 5;

/* States that are computed at a time: a whole number of them fits into the arrays. */
enum { TOGETHER = 2 };
typedef double Pack __attribute__((vector_size(TOGETHER * sizeof(double)), aligned(8), may_alias));

static inline Pack sum_of(const Sum *sum, double rates[STAGES][STEPPER_STATES_MOST], size_t state) {
    Pack total = {0};
    for (size_t k = 0; k < sum->count; k++)
        total += sum->weights[k].value * *(const Pack *)&rates[sum->weights[k].stage][state];
    return total;
}

/* Computes to = from + step x sum, for all states, and for what follows them up to a multiple of TOGETHER. */
static void combine(const Sum *sum, double rates[STAGES][STEPPER_STATES_MOST], double step, const double *from,
                    double *to, size_t count) {
    for (size_t i = 0; i < count; i += TOGETHER)
        *(Pack *)&to[i] = *(const Pack *)&from[i] + step * sum_of(sum, rates, i);
}

static double error_of(const Stepper *stepper, double rates[STAGES][STEPPER_STATES_MOST], double step) {
    double five = 0, three = 0;
    for (size_t i = 0; i < stepper->states; i += TOGETHER) {
        Pack a = sum_of(&fifth, rates, i), b = sum_of(&third, rates, i);
        for (size_t k = 0; k < TOGETHER && i + k < stepper->states; k++) {
            double per = 1 / (stepper->tolerance * stepper->scale[i + k]);
            five += a[k] * per * (a[k] * per);
            three += b[k] * per * (b[k] * per);
        }
    }
    double size = five + 0.01 * three;
    return size > 0 ? fabs(step) * five / sqrt(size * (double)stepper->states) : size;
}

double stepper_try(const Stepper *stepper, double time, double step, const double *state, const double *rates,
                   double *next, double *next_rates) {
    double stage[STAGES][STEPPER_STATES_MOST], begin[STEPPER_STATES_MOST], at[STEPPER_STATES_MOST];
    size_t count = stepper->states, size = count * sizeof(double);
    for (size_t k = 0; k < STAGES; k++)
        memset(&stage[k][count / TOGETHER * TOGETHER], 0, TOGETHER * sizeof(double));
    memset(&begin[count / TOGETHER * TOGETHER], 0, TOGETHER * sizeof(double));
    memcpy(begin, state, size);
    memcpy(stage[0], rates, size);
    for (size_t k = 1; k < STAGES; k++) {
        combine(&stages[k], stage, step, begin, at, count);
        stepper->rates(stepper->system, time + instants[k] * step, at, stage[k]);
    }
    combine(&whole, stage, step, begin, at, count);
    memcpy(next, at, size);
    stepper->rates(stepper->system, time + step, next, next_rates);
    return error_of(stepper, stage, step);
}

double stepper_next(double step, double error) {
    if (!(error < HUGE_VAL))
        return SHRINK * step;
    double root = sqrt(sqrt(sqrt(error)));
    return step * (root * GROW > SAFETY ? real_max(SHRINK, SAFETY / root) : GROW);
}
