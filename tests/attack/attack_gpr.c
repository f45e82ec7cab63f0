/* Attacks on ms_gpr.h: tastes of any size, unit, offset and kind of answer; models rebuilt from their views; materials
   inside their box, on their steps, all different. */
#define MS_GPR_IMPLEMENTATION
#include "ms_gpr.h"
#include "attack.h"
#include "../../examples/tools/warnings.h"

enum { ROWS = 60, COLUMNS = 10, CHOICES = 12, COUNT = 24 };

typedef struct taste {
    int n, m;
    double x[ROWS * COLUMNS], y[ROWS], unit[COLUMNS], offset[COLUMNS], floor;
    int rows[CHOICES * 4], sizes[CHOICES];
    ms_gpr_choices choices;
    int with_floor, constant;
} taste;

/* Materials u in [0, 1], told as offset + unit u; scores of a bump, in steps or not. */
static void draw_taste(taste *t)
{
    static const double peaks[3] = {0.2, 0.5, 0.8};
    uint64_t state;
    int i, k, at = 0;
    const int kind = attack_index(5), far = attack_one_in(3), twice = attack_one_in(6);
    const double scale = attack_one_in(3) ? attack_log(1e-6, 1e6) : 10,
                 shift = attack_one_in(4) ? scale * attack_linear(-20, 20) : 0;
    memset(t, 0, sizeof *t);
    t->n = (int)attack_int(0, attack_one_in(4) ? ROWS : 24);
    t->m = (int)attack_int(1, COLUMNS);
    for (k = 0; k < t->m; ++k) {
        t->unit[k] = far && attack_one_in(2) ? attack_log(1e-6, 1e6) : 1;
        t->offset[k] = far && attack_one_in(2) ? t->unit[k] * attack_log(1, 1e6) : 0;
    }
    t->constant = attack_one_in(5) ? attack_index(t->m) : -1;
    state = attack_draw();
    for (i = 0; i < t->n; ++i) {
        double off = 0;
        for (k = 0; k < t->m; ++k) {
            double u = (double)(attack_mix(&state) >> 11) / 9007199254740992.0;
            if (k == t->constant) u = 0.5;
            if (twice && i > 0 && i % 3 == 0) u = (t->x[(i - 1) * t->m + k] - t->offset[k]) / t->unit[k];
            t->x[i * t->m + k] = t->offset[k] + t->unit[k] * u;
            if (k < 3) off += (u - peaks[k]) * (u - peaks[k]) / 0.1;
        }
        t->y[i] = off < 1 ? 1 - off : 0;
        if (kind == 1) t->y[i] = floor(5 * t->y[i]) / 5;
        if (kind == 2) t->y[i] = t->y[i] > 0.3;
        if (kind == 3) t->y[i] = (double)(attack_mix(&state) >> 11) / 9007199254740992.0;
        if (kind == 4) t->y[i] = 0.4; /* equal */
        t->y[i] = shift + scale * t->y[i];
    }
    if (t->n >= 3 && attack_one_in(3)) {
        t->choices.count = 1 + attack_index(CHOICES);
        for (i = 0; i < t->choices.count; ++i) {
            t->sizes[i] = 2 + attack_index(t->n >= 4 ? 3 : 2);
            k = attack_index(t->n);
            for (; t->sizes[i] + k > t->n && k > 0;) --k;
            {
                int j;
                for (j = 0; j < t->sizes[i]; ++j) t->rows[at++] = k + j;
            }
        }
        t->choices.rows = t->rows;
        t->choices.sizes = t->sizes;
        if (attack_one_in(2))
            for (i = 0; i < t->n; i += 1 + attack_index(3)) t->y[i] = MS_GPR_UNSCORED;
    }
    t->with_floor = attack_one_in(3);
    t->floor = shift;
    attack_say("n %d, m %d, kind of scores %d of %.4g from %.4g, choices %d, floor %d, constant column %d, unit 0 %.4g "
               "offset 0 %.6g; ",
               t->n, t->m, kind, scale, shift, t->choices.count, t->with_floor, t->constant, t->unit[0], t->offset[0]);
}

static ms_gpr *fit(const taste *t, const double *x, ms_gpr_fit_report *report)
{
    ms_gpr_fit_options o;
    ms_error error = attack_no_error();
    ms_gpr *gp = NULL;
    ms_status status;
    memset(&o, 0, sizeof o);
    if (t->with_floor) o.floor = &t->floor;
    o.choices = t->choices;
    o.evaluations = 20;
    o.simd = (ms_simd)attack_index(4);
    o.allocator = attack_allocator((size_t)1 << 28);
    status = ms_gpr_fit(x, t->y, t->n, t->m, &o, &gp, report, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        ATTACK_CHECK(gp == NULL, "output touched on failure: model");
        if (status == MS_INVALID_ARGUMENT || status == MS_BAD_DATA)
            attack_fail("a valid taste is refused: %s", error.message);
    }
    return gp;
}

static void draw_points(const taste *t, double *p, int count)
{
    uint64_t state = attack_draw();
    int i, k;
    for (i = 0; i < count; ++i)
        for (k = 0; k < t->m; ++k)
            p[i * t->m + k] = t->offset[k] +
                t->unit[k] * (i % 4 == 3 ? 30 : 1) * ((double)(attack_mix(&state) >> 11) / 9007199254740992.0);
}

static void family_models(void)
{
    static taste t;
    double p[COUNT * COLUMNS], mean[COUNT], variance[COUNT], again[COUNT], probability[COUNT], moved[ROWS * COLUMNS];
    ms_gpr_fit_report report;
    ms_gpr *gp, *copy = NULL;
    ms_gpr_view view, parts;
    ms_gpr_options o;
    ms_error error = attack_no_error();
    ms_status status;
    int i, k;
    double most = 1e-300, close = 1e-7, explained;
    warnings_outlier outlier;
    draw_taste(&t);
    gp = fit(&t, t.x, &report);
    if (gp == NULL) return;
    if (t.choices.count) close = 1e-4; /* Newton ends where rounding hides a gain of 1e-8: 1e-4 of a deviation */
    ATTACK_CHECK(report.likelihood - report.likelihood == 0 && report.objective - report.objective == 0,
                 "not finite: likelihood %g, objective %g", report.likelihood, report.objective);
    outlier = warnings_judge(gp, &explained);
    ATTACK_CHECK(outlier.row >= -1 && outlier.row < t.n, "an outlier that is no row: %d", outlier.row);
    ATTACK_CHECK(explained <= 1 + 1e-9, "explains more than all: %g", explained);
    draw_points(&t, p, COUNT);
    status = ms_gpr_predict(gp, p, COUNT, mean, variance, &error);
    ATTACK_CHECK(status == MS_OK, "predict: %s", status ? error.message : "");
    view = ms_gpr_view_of(gp);
    most = exp(view.theta[t.m]); /* the unit of predictions where nothing was scored */
    for (i = 0; i < t.n; ++i)
        if (t.y[i] > -1e37) most = fmax(most, fabs(t.y[i] - view.mean));
    most = fmax(most, exp(view.theta[t.m])); /* of choices alone, the prior is the scale */
    for (i = 0; i < COUNT; ++i) {
        ATTACK_CHECK(mean[i] - mean[i] == 0 && variance[i] >= 0 && variance[i] - variance[i] == 0,
                     "a prediction: %g, variance %g", mean[i], variance[i]);
        ATTACK_CHECK(variance[i] <= exp(2 * view.theta[t.m]) * (1 + 1e-6), "more variance than the prior: %g of %g",
                     variance[i], exp(2 * view.theta[t.m]));
    }
    ATTACK_CHECK(ms_gpr_preference(gp, p, p + t.m, COUNT - 1, probability, &error) == MS_OK, "preference fails");
    ms_gpr_preference(gp, p + t.m, p, COUNT - 1, again, &error);
    for (i = 0; i < COUNT - 1; ++i)
        ATTACK_CHECK(fabs(probability[i] + again[i] - 1) < 1e-9, "of two, neither or both: %.12g and %.12g",
                     probability[i], again[i]);
    /* what the view shows makes the same model */
    memset(&o, 0, sizeof o);
    o.simd = view.level;
    o.allocator = attack_allocator((size_t)1 << 28);
    if (attack_one_in(2)) o.parallel = attack_parallel();
    status = ms_gpr_create(&view, &o, &copy, &error);
    if (status != MS_OK) attack_fail("a view makes no model: %s", error.message);
    else {
        ms_gpr_predict(copy, p, COUNT, again, NULL, &error);
        for (i = 0; i < COUNT; ++i)
            ATTACK_CHECK(fabs(again[i] - mean[i]) <= close * most, "a view's model differs: %.12g for %.12g", again[i],
                         mean[i]);
        /* one row less and again all */
        parts = ms_gpr_view_of(copy);
        if (parts.n > 1 && parts.choices.count == 0) {
            parts.n -= 1;
            if (ms_gpr_update(copy, &parts, &error) == MS_OK && ms_gpr_update(copy, &view, &error) == MS_OK) {
                ms_gpr_predict(copy, p, COUNT, again, NULL, &error);
                for (i = 0; i < COUNT; ++i)
                    ATTACK_CHECK(fabs(again[i] - mean[i]) <= close * most, "after an update: %.12g for %.12g", again[i],
                                 mean[i]);
            }
        }
        /* a value that is refused leaves the model as it is */
        parts = view;
        if (parts.n > 0) {
            memcpy(moved, view.x, sizeof(double) * (size_t)(t.n * t.m));
            moved[attack_index(t.n * t.m)] = attack_one_in(2) ? (double)NAN : 1e31;
            parts.x = moved;
            error = attack_no_error();
            status = ms_gpr_update(copy, &parts, &error);
            if (status == MS_OK) attack_fail("a value that is not finite is taken: %s", "x");
            else attack_check_error(status, &error);
            ms_gpr_predict(copy, p, COUNT, again, NULL, &error);
            for (i = 0; i < COUNT; ++i)
                ATTACK_CHECK(fabs(again[i] - mean[i]) <= close * most,
                             "a refused update changes the model: %.12g for %.12g", again[i], mean[i]);
        }
        ms_gpr_destroy(copy);
        copy = NULL;
        /* another offset of the materials: the same predictions */
        if (t.n > 0) {
            double q[COUNT * COLUMNS];
            for (i = 0; i < t.n * t.m; ++i) moved[i] = view.x[i] + 3 * t.unit[i % t.m];
            for (i = 0; i < COUNT * t.m; ++i) q[i] = p[i] + 3 * t.unit[i % t.m];
            parts = view;
            parts.x = moved;
            if (ms_gpr_create(&parts, &o, &copy, &error) == MS_OK) {
                ms_gpr_predict(copy, q, COUNT, again, NULL, &error);
                for (i = 0; i < COUNT && !attack->failed; ++i) {
                    int near = 1; /* offsets a million times the unit leave 1e-10 of it */
                    for (k = 0; k < t.m; ++k) near &= fabs(t.offset[k]) < 1e3 * t.unit[k];
                    if (near)
                        ATTACK_CHECK(fabs(again[i] - mean[i]) <= 1e-4 * most, "moved materials: %.12g for %.12g",
                                     again[i], mean[i]);
                }
                ms_gpr_destroy(copy);
            }
        }
    }
    ms_gpr_destroy(gp);
}

/* ---- materials ------------------------------------------------------------------------------------------------------ */

typedef struct steps {
    int m, equal;
    double from[COLUMNS], step[COLUMNS], high[COLUMNS];
} steps;

static void snap(void *user, double *x)
{
    const steps *s = (const steps *)user;
    int k;
    if (s->equal && s->m > 1) x[1] = x[0];
    for (k = 0; k < s->m; ++k)
        if (s->step[k] > 0) {
            double n = floor((x[k] - s->from[k]) / s->step[k] + 0.5);
            while (n > 0 && s->from[k] + n * s->step[k] > s->high[k]) n -= 1;
            if (n < 0) n = 0;
            x[k] = s->from[k] + n * s->step[k];
        }
}

static void check_materials(const taste *t, const ms_gpr_space *s, const double *x, int count, int discrete)
{
    double copy[COLUMNS];
    int i, j, k;
    for (i = 0; i < count && !attack->failed; ++i) {
        for (k = 0; k < t->m; ++k) {
            const double v = x[i * t->m + k];
            if (!(v - v == 0)) attack_fail("a material is not finite: row %d", i);
            if (s->low && !(v >= s->low[k] && v <= s->high[k]))
                attack_fail("out of the box: column %d is %.17g in %.17g to %.17g", k, v, s->low[k], s->high[k]);
        }
        if (s->snap) {
            memcpy(copy, x + i * t->m, sizeof(double) * (size_t)t->m);
            s->snap(s->user, copy);
            if (memcmp(copy, x + i * t->m, sizeof(double) * (size_t)t->m) != 0)
                attack_fail("not allowed by snap: row %d", i);
        }
        for (j = 0; j < i && !attack->failed; ++j)
            if (memcmp(x + i * t->m, x + j * t->m, sizeof(double) * (size_t)t->m) == 0 && !discrete)
                attack_fail("two equal materials: rows %d and %d", j, i);
    }
}

/* Whether the materials differ in a column: else the box that they suggest may be one point. */
static int varies(const taste *t)
{
    int i;
    for (i = t->m; i < t->n * t->m; ++i)
        if (t->x[i] != t->x[i % t->m]) return 1;
    return t->n == 0;
}

static void draw_space(const taste *t, ms_gpr_space *s, double *low, double *high, steps *grid)
{
    int k;
    memset(s, 0, sizeof *s);
    memset(grid, 0, sizeof *grid);
    if (attack_one_in(3)) return;
    grid->m = t->m;
    grid->equal = attack_one_in(4);
    for (k = 0; k < t->m; ++k) {
        const double a = attack_linear(-0.2, 1), b = attack_linear(0, 1.2);
        low[k] = t->offset[k] + t->unit[k] * fmin(a, b);
        high[k] = attack_one_in(8) ? low[k] : t->offset[k] + t->unit[k] * fmax(a, b);
        if (grid->equal && k == 1) {
            low[1] = low[0];
            high[1] = high[0];
        }
        grid->from[k] = low[k];
        grid->high[k] = high[k];
        if (attack_one_in(4)) grid->step[k] = t->unit[k] * attack_log(0.01, 1);
        if (grid->equal && k == 1) grid->step[1] = grid->step[0];
    }
    s->low = low;
    s->high = high;
    if (attack_one_in(2)) {
        s->snap = snap;
        s->user = grid;
    }
}

static void family_materials(void)
{
    static taste t;
    ms_gpr_recommend_options o;
    ms_gpr_gallery_options g;
    ms_gpr_recommend_report r;
    ms_gpr_fit_report report;
    steps grid;
    double x[COUNT * COLUMNS], again[COUNT * COLUMNS], mean[COUNT], sigma[COUNT], check[COUNT], low[COLUMNS],
        high[COLUMNS], avoid[2 * COLUMNS];
    ms_error error = attack_no_error();
    ms_status status;
    ms_gpr *gp;
    int i, k;
    const int count = (int)attack_int(1, COUNT);
    draw_taste(&t);
    gp = fit(&t, t.x, &report);
    if (gp == NULL) return;
    memset(&o, 0, sizeof o);
    draw_space(&t, &o.space, low, high, &grid);
    if (attack_one_in(3)) o.tau = attack_linear(1e-3, 1);
    if (attack_one_in(4)) {
        draw_points(&t, avoid, 2);
        o.avoid = avoid;
        o.avoid_count = 1 + attack_index(2);
    }
    o.seed = attack_draw();
    attack_say("%d materials, box %d, snap %d, equal %d, tau %.3g, avoid %d", count, o.space.low != NULL,
               o.space.snap != NULL, grid.equal, o.tau, o.avoid_count);
    memset(&r, 0, sizeof r);
    for (i = 0; i < COUNT * COLUMNS; ++i) x[i] = 7e77;
    status = ms_gpr_recommend(gp, &o, count, x, mean, sigma, &r, &error);
    if (status != MS_OK && status != MS_NOT_CONVERGED) {
        attack_check_error(status, &error);
        attack_fail("a valid wish is refused: %s", error.message);
    } else {
        if (status == MS_NOT_CONVERGED) attack_check_error(status, &error);
        ATTACK_CHECK(r.found >= 0 && r.found <= count && (status != MS_OK || r.found == count), "found: %d of %d",
                     r.found, count);
        check_materials(&t, &o.space, x, r.found, 0);
        if (r.found > 0 && ms_gpr_predict(gp, x, r.found, check, NULL, &error) == MS_OK)
            for (i = 0; i < r.found; ++i)
                ATTACK_CHECK(fabs(check[i] - mean[i]) <=
                                     1e-5 * (1e-300 + fabs(check[i]) + exp(ms_gpr_view_of(gp).theta[t.m])) &&
                                 sigma[i] >= 0,
                             "another prediction: %.9g for %.9g, sigma %g", mean[i], check[i], sigma[i]);
        if (o.avoid && o.space.low)
            for (i = 0; i < r.found * o.avoid_count; ++i) {
                double sum = 0;
                int dimensions = 0;
                for (k = 0; k < t.m; ++k)
                    if (high[k] > low[k]) {
                        const double d = (x[i / o.avoid_count * t.m + k] - avoid[i % o.avoid_count * t.m + k]) /
                            (high[k] - low[k]);
                        sum += d * d;
                        ++dimensions;
                    }
                ATTACK_CHECK(!dimensions || sqrt(sum / t.m) >= 0.15 * (1 - 1e-4) ||
                                 sqrt(sum / dimensions) >= 0.15 * (1 - 1e-4),
                             "nearer than it may be: %.6g", sqrt(sum / dimensions));
            }
        if (status == MS_OK) { /* the first of them alone */
            const int first = (count + 1) / 2;
            if (ms_gpr_recommend(gp, &o, first, again, NULL, NULL, NULL, &error) == MS_OK)
                ATTACK_CHECK(memcmp(again, x, sizeof(double) * (size_t)(first * t.m)) == 0, "another sequence: of %d",
                             first);
        }
    }
    memset(&g, 0, sizeof g);
    g.space = o.space;
    g.seed = o.seed;
    status = ms_gpr_gallery(gp, &g, count, x, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        attack_fail("a gallery is refused: %s", error.message);
    } else check_materials(&t, &g.space, x, count, g.space.low != NULL || !varies(&t));
    ms_gpr_destroy(gp);
}

static void family_planes(void)
{
    static taste t;
    ms_gpr_latent_options o;
    ms_gpr_latent *plane = NULL;
    ms_gpr_latent_report report;
    ms_gpr_latent_view view;
    ms_error error = attack_no_error();
    ms_status status;
    double at[2 * COUNT], x[COUNT * COLUMNS], variance[COUNT];
    int i;
    draw_taste(&t);
    if (t.n < 2) return;
    memset(&o, 0, sizeof o);
    o.allocator = attack_allocator((size_t)1 << 28);
    if (attack_one_in(2)) o.prior = attack_log(1e-6, 10);
    status = ms_gpr_latent_fit(t.x, t.n, t.m, &o, &plane, &report, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        ATTACK_CHECK(plane == NULL, "output touched on failure: plane");
        return;
    }
    view = ms_gpr_latent_view_of(plane);
    for (i = 0; i < 2 * COUNT; ++i) at[i] = attack_linear(-20, 20);
    status = ms_gpr_latent_map(plane, at, COUNT, x, variance, &error);
    ATTACK_CHECK(status == MS_OK && view.sf > 0, "a map: status %d", (int)status);
    for (i = 0; i < COUNT; ++i)
        ATTACK_CHECK(variance[i] >= 0 && variance[i] <= view.sf * view.sf * (1 + 1e-9), "a plane's variance: %g of %g",
                     variance[i], view.sf * view.sf);
    for (i = 0; i < COUNT * t.m; ++i) ATTACK_CHECK(x[i] - x[i] == 0, "a plane's material: %g", x[i]);
    ms_gpr_latent_destroy(plane);
}

/* --- what a tool's users do: choices that contradict each other, boxes open on some sides, few allowed materials, every
   search, a start, planes in a box --- */

static void draw_contradictions(taste *t)
{
    int order[ROWS], i, j, at = 0;
    for (i = 0; i < t->n; ++i) order[i] = i;
    t->choices.count = attack_index(CHOICES / 2);
    for (i = 0; i < t->choices.count; ++i) {
        t->sizes[i] = 2 + attack_index(t->n < 8 ? t->n - 1 : 7);
        for (j = 0; j < t->sizes[i]; ++j) { /* different rows */
            const int from = j + attack_index(t->n - j), row = order[from];
            order[from] = order[j];
            t->rows[at++] = order[j] = row;
        }
    }
    t->choices.rows = t->rows;
    t->choices.sizes = t->sizes;
}

static int stop_after(void *left, double fraction)
{
    if (!(fraction >= 0 && fraction <= 1)) attack_fail("progress of %g", fraction);
    return --*(int *)left < 0;
}

static void family_users(void)
{
    static taste t;
    ms_gpr_fit_options f;
    ms_gpr_fit_report report;
    ms_gpr_recommend_options o;
    ms_gpr_recommend_report r;
    ms_gpr_latent_options l;
    ms_gpr_latent *plane = NULL;
    ms_gpr *gp = NULL;
    ms_error error = attack_no_error();
    ms_status status;
    steps grid;
    double low[COLUMNS], high[COLUMNS], start[COLUMNS + 2], x[COUNT * COLUMNS], mean[COUNT], at[2 * COUNT], all = 1;
    int left = attack_one_in(6) ? attack_index(40) : 1000000, i, k;
    const int count = (int)attack_int(1, COUNT), few = attack_one_in(2);
    draw_taste(&t);
    if (t.n < 2) return;
    draw_contradictions(&t);
    memset(&f, 0, sizeof f);
    f.choices = t.choices;
    f.evaluations = (int)attack_int(1, 40);
    f.progress.report = stop_after;
    f.progress.user = &left;
    f.allocator = attack_allocator((size_t)1 << 28);
    for (k = 0; k < t.m + 2; ++k) start[k] = attack_linear(-20, 20);
    if (attack_one_in(2)) f.start = start;
    status = ms_gpr_fit(t.x, t.y, t.n, t.m, &f, &gp, &report, &error);
    if (status != MS_OK) {
        attack_check_error(status, &error);
        ATTACK_CHECK(status == MS_OUT_OF_MEMORY || status == MS_NOT_CONVERGED || (status == MS_CANCELLED && left < 0),
                     "a valid taste is refused: %s", error.message);
        return;
    }
    ATTACK_CHECK(report.evaluations <= 3 * f.evaluations + 60, "more evaluations than asked for: %d of %d",
                 report.evaluations, f.evaluations);

    /* a box that is open in some columns; or a few steps in every column, which can be counted */
    memset(&o, 0, sizeof o);
    memset(&grid, 0, sizeof grid);
    grid.m = t.m;
    for (k = 0; k < t.m; ++k) {
        low[k] = t.offset[k];
        high[k] = attack_one_in(3) ? low[k] : low[k] + t.unit[k];
        grid.from[k] = low[k], grid.high[k] = high[k];
        grid.step[k] = few ? t.unit[k] / 2 : 0;
        if (few && high[k] > low[k]) all *= 3;
        if (!few && attack_one_in(3)) low[k] = -HUGE_VAL;
        if (!few && attack_one_in(3)) high[k] = HUGE_VAL;
    }
    o.space.low = low, o.space.high = high;
    if (few) o.space.snap = snap, o.space.user = &grid;
    o.search = (ms_gpr_search)attack_index(3);
    o.seed = attack_draw();
    attack_say("choices %d, %d materials of %.0f, search %d", t.choices.count, count, few ? all : HUGE_VAL, o.search);
    status = ms_gpr_recommend(gp, &o, count, x, mean, NULL, &r, &error);
    if (status == MS_OK || status == MS_NOT_CONVERGED) {
        ATTACK_CHECK(r.found <= all || !few, "more than there are: %d of %.0f", r.found, all);
        if (few) check_materials(&t, &o.space, x, r.found, 0);
        if (few && status == MS_NOT_CONVERGED && r.search == MS_GPR_SEARCH_VARIANTS && all <= 9)
            ATTACK_CHECK(r.found == (int)all, "fewer than there are: %d of %.0f", r.found, all);
        if (r.search == MS_GPR_SEARCH_THRESHOLD)
            for (i = 0; i < r.found; ++i)
                ATTACK_CHECK(mean[i] >= r.threshold - 1e-9 * (fabs(r.threshold) + fabs(r.best)),
                             "below the threshold: %.9g of %.9g", mean[i], r.threshold);
    } else attack_check_error(status, &error);
    ms_gpr_destroy(gp);

    memset(&l, 0, sizeof l);
    l.space = o.space;
    l.allocator = attack_allocator((size_t)1 << 28);
    if (ms_gpr_latent_fit(t.x, t.n, t.m, &l, &plane, NULL, &error) != MS_OK) return;
    for (i = 0; i < 2 * COUNT; ++i) at[i] = attack_linear(-5, 5);
    status = ms_gpr_latent_map(plane, at, COUNT, x, NULL, &error);
    if (few && status == MS_OK)
        for (i = 0; i < COUNT; ++i) check_materials(&t, &l.space, x + i * t.m, 1, 1);
    ms_gpr_latent_destroy(plane);
}

int main(int argc, char **argv)
{
    static const attack_family families[] = {
        {"models", family_models}, {"materials", family_materials}, {"planes", family_planes}, {"users", family_users}};
    return attack_main(argc, argv, families, (int)(sizeof families / sizeof *families));
}
