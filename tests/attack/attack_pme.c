/* Attacks on ms_pme.h: least-squares problems of any scale, box, budget and failing callbacks; matches of small pictures
   by every kind of candidate. */
#define MS_PME_IMPLEMENTATION
#include "ms_pme.h"
#include "attack.h"

enum { MOST = 256, RESIDUALS = 60 };

/* Residuals of u_j = (x_j - shift_j) / unit_j. */
typedef struct problem {
    int n, m, kind, fail_at, calls, nan_calls;
    ms_status failure;
    double shift[MOST], unit[MOST], lower[MOST], upper[MOST], wall;
    double a[RESIDUALS * MOST], b[RESIDUALS];
    int bounds; /* 0 none, 1 lower, 2 upper, 3 both */
} problem;
static problem q;

static double u_of(int j, const double *x) { return (x[j] - q.shift[j]) / q.unit[j]; }

static void residuals_of(const double *x, double *r, double *jacobian)
{
    int i, j;
    for (i = 0; i < q.m; ++i) {
        double sum = -q.b[i], v;
        for (j = 0; j < q.n; ++j) sum += q.a[i * q.n + j] * u_of(j, x);
        v = sum;
        if (q.kind == 1) v = tanh(sum);
        if (q.kind == 2) v = sum * sum - 1 + 0.1 * sum;
        if (q.kind == 3 && u_of(0, x) > q.wall) v = (double)NAN;
        if (q.kind == 4) v = q.b[i];
        r[i] = v;
        for (j = 0; jacobian != NULL && j < q.n; ++j) {
            double slope = q.a[i * q.n + j] / q.unit[j];
            if (q.kind == 1) slope *= 1 - v * v;
            if (q.kind == 2) slope *= 2 * sum + 0.1;
            if (q.kind == 4) slope = 0;
            jacobian[(size_t)i * (size_t)q.n + (size_t)j] = slope;
        }
    }
}

static ms_status residuals(void *user, const double *x, double *r, double *jacobian)
{
    int j;
    (void)user;
    ++q.calls;
    for (j = 0; j < q.n; ++j) {
        if (!(fabs(x[j]) <= 1.7e308)) attack_fail("a callback gets a value that is not finite: parameter %d", j);
        if (((q.bounds & 1) && x[j] < q.lower[j]) || ((q.bounds & 2) && x[j] > q.upper[j]))
            attack_fail("a callback gets a value out of the box: %.17g in %.17g to %.17g", x[j], q.lower[j],
                        q.upper[j]);
    }
    if (q.calls == q.fail_at) return q.failure;
    residuals_of(x, r, jacobian);
    return MS_OK;
}

static double square(const double *x)
{
    double r[RESIDUALS], sum = 0;
    int i;
    residuals_of(x, r, NULL);
    for (i = 0; i < q.m; ++i) sum += r[i] * r[i];
    return sum;
}

static void draw_box(int n, double spread)
{
    int j;
    q.n = n;
    q.bounds = attack_index(4);
    for (j = 0; j < n; ++j) {
        q.unit[j] = spread > 1 ? attack_log(1 / spread, spread) : 1;
        q.shift[j] = attack_one_in(4) ? q.unit[j] * attack_linear(-1e3, 1e3) : 0;
        q.lower[j] = q.shift[j] - q.unit[j] * attack_linear(0, 2);
        q.upper[j] = attack_one_in(12) ? q.lower[j] : q.shift[j] + q.unit[j] * attack_linear(0, 2);
        if (q.upper[j] < q.lower[j]) q.upper[j] = q.lower[j];
        if (attack_one_in(20)) q.upper[j] = HUGE_VAL;
    }
}

static void family_minimize(void)
{
    ms_pme_function f;
    ms_pme_options o = ms_pme_defaults();
    ms_pme_result result;
    ms_error error = attack_no_error();
    ms_status status;
    double x[MOST], start[MOST], clipped[MOST], begin, end;
    uint64_t state;
    int i, j;
    memset(&q, 0, sizeof q);
    draw_box((int)attack_int(1, attack_one_in(10) ? MOST : 12), attack_one_in(2) ? 1 : attack_log(1, 1e6));
    q.m = (int)attack_int(1, RESIDUALS);
    q.kind = attack_index(5);
    q.wall = attack_linear(-1, 2);
    state = attack_draw();
    for (i = 0; i < q.m * q.n; ++i) q.a[i] = (double)(attack_mix(&state) >> 11) / 4503599627370496.0 - 1;
    for (i = 0; i < q.m; ++i)
        q.b[i] = attack_one_in(20) ? 0 : 2 * ((double)(attack_mix(&state) >> 11) / 4503599627370496.0 - 1);
    memset(&f, 0, sizeof f);
    f.parameter_count = q.n;
    f.residual_count = (size_t)q.m;
    f.residuals = residuals;
    f.residuals_only = attack_one_in(2);
    if (attack_one_in(3)) f.jacobian_cost = attack_log(0.01, 100);
    if (q.bounds & 1) f.lower = q.lower;
    if (q.bounds & 2) f.upper = q.upper;
    if (attack_one_in(2)) o.max_cost = attack_log(1, 3000);
    if (attack_one_in(4)) o.tolerance = attack_log(1e-15, 0.1);
    if (attack_one_in(4)) o.restarts = attack_one_in(4) ? 2147483647 - attack_index(3) : (int)attack_int(0, 20);
    if (o.restarts > 1000) o.max_cost = 2000;
    o.seed = attack_draw();
    o.allocator = attack_allocator((size_t)1 << 28);
    if (attack_one_in(6)) q.fail_at = (int)attack_int(1, 40);
    q.failure = attack_one_in(2) ? MS_CANCELLED : MS_IO;
    for (j = 0; j < q.n; ++j) {
        start[j] = q.shift[j] + q.unit[j] * attack_linear(-3, 3);
        clipped[j] = start[j];
        if ((q.bounds & 1) && clipped[j] < q.lower[j]) clipped[j] = q.lower[j];
        if ((q.bounds & 2) && clipped[j] > q.upper[j]) clipped[j] = q.upper[j];
    }
    memcpy(x, start, sizeof x);
    begin = square(clipped);
    attack_say("n %d, m %d, kind %d, bounds %d, differences %d, cost of a jacobian %.4g, max_cost %.6g, "
               "tolerance %.3g, restarts %d, fails at %d, unit 0 %.4g, f at the start %.9g",
               q.n, q.m, q.kind, q.bounds, f.residuals_only, f.jacobian_cost, o.max_cost, o.tolerance, o.restarts,
               q.fail_at, q.unit[0], begin);
    memset(&result, 0x55, sizeof result);
    status = ms_pme_minimize(&f, &o, x, &result, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        if (memcmp(x, start, (size_t)q.n * sizeof *x) != 0) attack_fail("output touched on failure: x");
        if (q.fail_at && q.calls >= q.fail_at)
            ATTACK_CHECK(status == q.failure, "a callback's status is lost: %d for %d", (int)status, (int)q.failure);
        ATTACK_CHECK(q.calls <= q.fail_at || !q.fail_at, "called again after a failure: %d calls", q.calls);
        return;
    }
    end = square(x);
    ATTACK_CHECK(!q.fail_at || q.calls < q.fail_at, "a failed callback is ignored: call %d of %d", q.fail_at, q.calls);
    ATTACK_CHECK(end - end == 0 && fabs(end - result.value) <= 1e-12 * fabs(end) + 1e-300,
                 "another value than f at x: %.17g for %.17g", result.value, end);
    if (begin - begin == 0) ATTACK_CHECK(end <= begin, "worse than the start: %.17g for %.17g", end, begin);
    if (o.max_cost > 0)
        ATTACK_CHECK(result.cost <= o.max_cost * (1 + 1e-9), "more than max_cost: %.9g of %.9g", result.cost,
                     o.max_cost);
    ATTACK_CHECK((size_t)q.calls == result.evaluations + result.jacobians, "calls not counted: %d, %d and %d", q.calls,
                 (int)result.evaluations, (int)result.jacobians);
    if (q.kind == 0 && result.stop == MS_PME_STOP_CONVERGED && o.tolerance == 0 && q.bounds == 0) {
        double r[RESIDUALS], best = 0; /* what a step along one axis would gain */
        residuals_of(x, r, NULL);
        for (j = 0; j < q.n; ++j) {
            double g = 0, h = 0;
            for (i = 0; i < q.m; ++i) {
                g += q.a[i * q.n + j] * r[i];
                h += q.a[i * q.n + j] * q.a[i * q.n + j];
            }
            if (h > 0) best = fmax(best, g * g / h);
        }
        ATTACK_CHECK(best <= 1e-6 * begin + 1e-12, "not a minimum: one axis gains %.3g of %.9g, %.9g at the start",
                     best, end, begin);
    }
}

/* ---- matches ------------------------------------------------------------------------------------------------------- */

enum { PIXELS = 200 };
static float weight[PIXELS];
static int predictions;

static void picture_of(const double *x, float *image, float *jacobian)
{
    int i, j;
    for (i = 0; i < q.m; ++i) {
        double sum = q.b[i % RESIDUALS];
        for (j = 0; j < q.n; ++j) sum += q.a[(i * 7 + j * 13) % (RESIDUALS * 4)] * u_of(j, x);
        image[i] = (float)(0.5 + 0.5 * tanh(sum));
        if (q.kind == 3 && u_of(0, x) > q.wall) image[i] = NAN;
        for (j = 0; jacobian != NULL && j < q.n; ++j)
            jacobian[i * q.n + j] = (float)(q.a[(i * 7 + j * 13) % (RESIDUALS * 4)] / q.unit[j] * 0.5 *
                                            (1 - tanh(sum) * tanh(sum)));
    }
}

static ms_status render_both(const double *x, float *image, float *jacobian)
{
    int j;
    ++q.calls;
    for (j = 0; j < q.n; ++j)
        if (!(x[j] >= q.lower[j] && x[j] <= q.upper[j]))
            attack_fail("a callback gets a value out of the box: %.17g in %.17g to %.17g", x[j], q.lower[j],
                        q.upper[j]);
    if (q.calls == q.fail_at) return q.failure;
    picture_of(x, image, jacobian);
    return MS_OK;
}

static ms_status render(void *user, const double *x, float *image)
{
    (void)user;
    return render_both(x, image, NULL);
}

static ms_status jacobian(void *user, const double *x, float *image, float *slopes)
{
    (void)user;
    return render_both(x, image, slopes);
}

static ms_status predict(void *user, int i, const float *target, double *x)
{
    int j;
    (void)user;
    if (i < 0 || i >= predictions) attack_fail("a prediction that is not there: %d", i);
    for (j = 0; j < q.n; ++j) x[j] = q.shift[j] + q.unit[j] * ((double)target[(i + j) % q.m] * 6 - 3);
    return MS_OK;
}

static double rmse_of(const float *image, const float *target, const float *w)
{
    double sum = 0, all = 0;
    int i;
    for (i = 0; i < q.m; ++i) {
        const double d = (double)image[i] - (double)target[i], k = w ? (double)w[i] : 1;
        if (k == 0) continue;
        sum += k * d * d;
        all += k;
    }
    return sqrt(sum / all);
}

static void family_match(void)
{
    ms_pme_renderer r = ms_pme_renderer_defaults();
    ms_pme_match_options o = ms_pme_match_defaults();
    ms_pme_match_result result;
    ms_error error = attack_no_error();
    ms_status status;
    float target[PIXELS], image[PIXELS], check[PIXELS];
    double x[16], hidden[16], candidates[5 * 16], deviation[16], source[16], pull[16], v;
    uint64_t state;
    int i, j, with_weight = attack_one_in(3);
    memset(&q, 0, sizeof q);
    draw_box((int)attack_int(1, 12), attack_one_in(2) ? 1 : attack_log(1, 1e6));
    q.bounds = 3;
    for (j = 0; j < q.n; ++j)
        if (!(q.upper[j] < 1e300)) q.upper[j] = q.lower[j] + q.unit[j];
    q.m = (int)attack_int(1, PIXELS);
    q.kind = attack_one_in(4) ? 3 : 0;
    q.wall = attack_linear(-1, 2);
    state = attack_draw();
    for (i = 0; i < RESIDUALS * 4; ++i) q.a[i] = (double)(attack_mix(&state) >> 11) / 4503599627370496.0 - 1;
    for (i = 0; i < RESIDUALS; ++i) q.b[i] = (double)(attack_mix(&state) >> 11) / 4503599627370496.0 - 1;
    for (j = 0; j < q.n; ++j) hidden[j] = q.lower[j] + (q.upper[j] - q.lower[j]) * attack_unit();
    i = q.kind;
    q.kind = 0;
    picture_of(hidden, target, NULL);
    q.kind = i;
    if (attack_one_in(3)) attack_fill(target, (size_t)q.m, 0, 1);
    if (attack_one_in(12))
        for (i = 0; i < q.m; ++i) target[i] = 0;
    for (i = 0; i < q.m; ++i) weight[i] = i % 5 == 1 && attack_one_in(4) ? 0 : 0.1f + (float)(i % 3);
    r.parameter_count = q.n;
    r.image_size = (size_t)q.m;
    r.lower = q.lower;
    r.upper = q.upper;
    r.render = render;
    if (attack_one_in(2)) r.jacobian = jacobian;
    predictions = r.prediction_count = attack_one_in(3) ? 1 + attack_index(3) : 0;
    r.predict = predict;
    o.refine.allocator = attack_allocator((size_t)1 << 28);
    if (attack_one_in(2)) o.refine.max_cost = attack_log(1, 1000);
    o.initial_only = attack_one_in(4);
    if (attack_one_in(3)) {
        o.candidate_count = 1 + attack_index(5);
        for (i = 0; i < o.candidate_count * q.n; ++i)
            candidates[i] = q.shift[i % q.n] + q.unit[i % q.n] * attack_linear(-3, 3);
        o.candidates = candidates;
    }
    if (attack_one_in(2)) o.random_count = (int)attack_int(1, 30);
    if (attack_one_in(3)) {
        for (j = 0; j < q.n; ++j) {
            source[j] = q.lower[j] + (q.upper[j] - q.lower[j]) * attack_unit();
            pull[j] = attack_log(1e-6, 1) / (q.unit[j] * q.unit[j]);
        }
        o.source = source;
        o.pull = pull;
    }
    if (attack_one_in(2)) o.deviation = deviation;
    if (attack_one_in(6)) q.fail_at = (int)attack_int(1, 60);
    q.failure = attack_one_in(2) ? MS_CANCELLED : MS_IO;
    attack_say(
        "n %d, %d pixels, jacobian %d, predictions %d, candidates %d, random %d, initial only %d, max_cost %.5g, "
        "weights %d, pulls %d, deviations %d, NaN %d, fails at %d, box 0 of %.6g",
        q.n, q.m, r.jacobian != NULL, predictions, o.candidate_count, o.random_count, o.initial_only, o.refine.max_cost,
        with_weight, o.pull != NULL, o.deviation != NULL, q.kind, q.fail_at, q.upper[0] - q.lower[0]);
    for (j = 0; j < 16; ++j) x[j] = deviation[j] = 7e77;
    for (i = 0; i < PIXELS; ++i) image[i] = 7e7f;
    memset(&result, 0x55, sizeof result);
    status = ms_pme_match(&r, target, with_weight ? weight : NULL, &o, x, image, &result, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        for (j = 0; j < 16; ++j)
            ATTACK_CHECK(x[j] == 7e77 && deviation[j] == 7e77, "output touched on failure: x or deviation (%s)",
                         error.message);
        for (i = 0; i < q.m; ++i) ATTACK_CHECK(image[i] == 7e7f, "output touched on failure: image");
        for (i = 0; i < (int)sizeof result; ++i)
            ATTACK_CHECK(((unsigned char *)&result)[i] == 0x55, "output touched on failure: result");
        if (q.fail_at && q.calls >= q.fail_at)
            ATTACK_CHECK(status == q.failure, "a callback's status is lost: %d for %d", (int)status, (int)q.failure);
        else if (status == MS_INVALID_ARGUMENT && q.kind == 0)
            ATTACK_CHECK(strstr(error.message, "cost") != NULL || strstr(error.message, "budget") != NULL,
                         "a valid match is refused: %s", error.message);
        return;
    }
    for (j = 0; j < q.n; ++j)
        ATTACK_CHECK(x[j] >= q.lower[j] && x[j] <= q.upper[j], "out of the box: %.17g in %.17g to %.17g", x[j],
                     q.lower[j], q.upper[j]);
    picture_of(x, check, NULL);
    ATTACK_CHECK(memcmp(check, image, (size_t)q.m * sizeof(float)) == 0, "another picture than that of x");
    v = rmse_of(check, target, with_weight ? weight : NULL);
    ATTACK_CHECK(fabs(v - result.rmse) <= 1e-5 * v + 1e-7, "another rmse: %.9g for %.9g", result.rmse, v);
    if (!o.pull)
        ATTACK_CHECK(result.rmse <= result.rmse_initial * (1 + 1e-5) + 1e-7,
                     "worse than the best candidate: %.9g for %.9g", result.rmse, result.rmse_initial);
    if (o.initial_only)
        ATTACK_CHECK(fabs(result.rmse - result.rmse_initial) <= 1e-5 * v + 1e-7,
                     "another rmse of the candidate: %.9g for %.9g", result.rmse_initial, result.rmse);
    ATTACK_CHECK(result.best_candidate >= 0, "no best candidate: %d", result.best_candidate);
    if (o.deviation)
        for (j = 0; j < q.n; ++j) {
            const double range = q.upper[j] - q.lower[j];
            ATTACK_CHECK(deviation[j] >= 0 && deviation[j] <= 0.2887 * range * 1.0001 + 1e-300,
                         "a deviation: %.6g of a range of %.6g", deviation[j], range);
        }
}

int main(int argc, char **argv)
{
    static const attack_family families[] = {{"minimize", family_minimize}, {"match", family_match}};
    return attack_main(argc, argv, families, (int)(sizeof families / sizeof *families));
}
