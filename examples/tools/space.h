/* Parameters in steps, equal ones, and rows of lists for ms_gpr.h, behind the snap of a ms_gpr_space; round ranges for
   those without one; ms_gpr.h comes first.

     space_kept s;
     const char *problem = space_make(&s, &wish, 19);   NULL: fine; otherwise a sentence, valid until the next call
     space_round(&s, x, n);                             ranges that parameters seem to have, where none is wished
     options.space = space_of(&s);                      as long as s lives
     space_free(&s);

   Everything of the wish is copied. Of a list, the row that is nearest to a material takes its place. */
#ifndef EXAMPLES_SPACE_H
#define EXAMPLES_SPACE_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Values that some parameters take together, such as a list of metals. */
typedef struct space_list {
    const int *columns; /* [width] which parameters, from 0; none in two lists */
    int width;
    const double *rows; /* [count][width]; rows outside the box are left out */
    int count;
} space_list;

/* All zero: nothing. */
typedef struct space_wish {
    const double *low, *high; /* [m] as of ms_gpr_space, or NULL */
    const double
        *steps;       /* [m] of parameters that come in steps from low on, with low and high; 0: continuous; or NULL */
    const int *equal; /* [equal_count][2] columns that always have equal values, on the same scale */
    int equal_count;
    const space_list *lists;
    int list_count;
    const char *const *names; /* [m] of the parameters, for sentences; or NULL: they are numbered from 0 */
} space_wish;

typedef struct space_kept {
    int m;
    const char *const *names;   /* as of the wish; space_make alone needs them */
    double *low, *high, *steps; /* [m] of the wish; steps: of equal columns together */
    double *box_low, *box_high; /* [m] the box that ms_gpr.h gets: half a step wider, as wide as lists */
    double *first, *last;       /* [m] the values that equal columns have in common, as indices of steps */
    int *lead;                  /* [m] the first of the columns that are equal to this one */
    int *equal, equal_count;
    space_list *lists; /* of rows in the box */
    int list_count;
    int snaps;
} space_kept;

static inline void space_free(space_kept *s)
{
    int i;
    for (i = 0; s->lists && i < s->list_count; ++i)
        free((void *)(uintptr_t)s->lists[i].columns), free((void *)(uintptr_t)s->lists[i].rows);
    free(s->low), free(s->lead), free(s->equal), free(s->lists);
    memset(s, 0, sizeof *s);
}

/* What parameter k is called, into text [48]. */
static inline const char *space__name(const space_kept *s, int k, char *text)
{
    if (s->names && k >= 0 && k < s->m) snprintf(text, 48, "'%.40s'", s->names[k]);
    else snprintf(text, 48, "%d", k);
    return text;
}

static void space__snap(void *user, double *x)
{
    const space_kept *s = (const space_kept *)user;
    int i, k, row;
    for (k = 0; k < s->m; ++k) { /* equal columns meet in their mean, at a step, or in the common range */
        double sum = 0, count = 0;
        if (s->lead[k] != k) continue;
        for (i = k; i < s->m; ++i)
            if (s->lead[i] == k) sum += x[i], count += 1;
        if (count > 1) sum /= count; /* one alone keeps its bits */
        if (s->steps[k] > 0)
            sum = s->low[k] +
                s->steps[k] * fmin(fmax(floor((sum - s->low[k]) / s->steps[k] + 0.5), s->first[k]), s->last[k]);
        else if (count > 1) sum = fmin(fmax(sum, s->low[k]), s->high[k]);
        for (i = k; i < s->m; ++i)
            if (s->lead[i] == k) x[i] = sum;
    }
    for (i = 0; i < s->list_count; ++i) {
        const space_list *list = &s->lists[i];
        double least = HUGE_VAL;
        int best = 0;
        for (row = 0; row < list->count; ++row) {
            const double *from = list->rows + (size_t)row * (size_t)list->width;
            double d2 = 0;
            for (k = 0; k < list->width && d2 < least; ++k) {
                const int column = list->columns[k];
                const double width = s->box_high[column] - s->box_low[column];
                const double d = width > 0 ? (from[k] - x[column]) / width : 0;
                d2 += d * d;
            }
            if (d2 < least) least = d2, best = row;
        }
        for (k = 0; k < list->width; ++k) x[list->columns[k]] = list->rows[best * list->width + k];
    }
}

/* The rows of list g that lie in the box, and their range. */
static inline const char *space__list(space_kept *s, const space_list *from, int g, int *owner)
{
    static char text[200];
    char name[48];
    space_list *to = &s->lists[g];
    const size_t width = (size_t)(from->width > 0 ? from->width : 0);
    int *columns = (int *)malloc((width + 1) * sizeof *columns);
    double *rows = (double *)malloc((width * (size_t)(from->count > 0 ? from->count : 0) + 1) * sizeof *rows);
    int row, k;
    to->columns = columns, to->rows = rows, to->width = from->width, to->count = 0;
    if (columns == NULL || rows == NULL) return "out of memory";
    if (from->width < 1 || from->width > s->m || from->count < 1) return "a list has no columns or no rows";
    for (k = 0; k < from->width; ++k) {
        const int column = columns[k] = from->columns[k];
        const char *why = column < 0 || column >= s->m ? "is not there"
            : owner[column]                            ? "is in two lists or twice in one"
            : s->steps[column] > 0                     ? "is in a list and comes in steps"
                                                       : NULL;
        snprintf(text, sizeof text, "parameter %s of list %d %s", space__name(s, column, name), g + 1, why ? why : "");
        if (why) return text;
        owner[column] = g + 1;
    }
    for (row = 0; row < from->count; ++row) {
        const double *value = from->rows + (size_t)row * width;
        int fits = 1;
        for (k = 0; k < from->width; ++k) {
            const double slack = 1e-12 * fabs(value[k]);
            if (!(value[k] - value[k] == 0)) return "a list has a value that is not finite";
            fits &= value[k] >= s->low[columns[k]] - slack && value[k] <= s->high[columns[k]] + slack;
        }
        if (fits) memcpy(rows + (size_t)to->count++ * width, value, width * sizeof *value);
    }
    snprintf(text, sizeof text, "list %d contradicts the box: none of its %d rows lies there", g + 1, from->count);
    if (to->count == 0) return text;
    for (k = 0; k < from->width; ++k) {
        double *low = &s->box_low[columns[k]], *high = &s->box_high[columns[k]];
        *low = *high = rows[k];
        for (row = 1; row < to->count; ++row) {
            *low = fmin(*low, rows[(size_t)row * width + (size_t)k]);
            *high = fmax(*high, rows[(size_t)row * width + (size_t)k]);
        }
    }
    return NULL;
}

static inline const char *space__equal(space_kept *s, const int *owner)
{
    static char text[200];
    char one[48], two[48];
    int i, k;
    for (i = 0; i < s->equal_count; ++i) {
        const int a = s->equal[2 * i], b = s->equal[2 * i + 1];
        const char *why = NULL;
        int first = 0, second = 0;
        if (a < 0 || a >= s->m || b < 0 || b >= s->m) why = "but there is no such parameter";
        else if (owner[a] || owner[b]) why = "but are in a list";
        if (!why) first = s->lead[a] < s->lead[b] ? s->lead[a] : s->lead[b];
        if (!why) second = s->lead[a] < s->lead[b] ? s->lead[b] : s->lead[a];
        if (!why && s->steps[first] > 0 && s->steps[second] > 0 &&
            (fabs(s->steps[first] - s->steps[second]) > 0 || fabs(s->low[first] - s->low[second]) > 0))
            why = "but come in different steps";
        if (!why && fmax(s->low[first], s->low[second]) > fmin(s->high[first], s->high[second]))
            why = "but no value is in both ranges";
        snprintf(text, sizeof text, "parameters %s and %s are to be equal, %s", space__name(s, a, one),
                 space__name(s, b, two), why ? why : "");
        if (why) return text;
        for (k = 0; k < s->m; ++k)
            if (s->lead[k] == second) s->lead[k] = first;
        if (first == second) continue;
        if (s->steps[first] > 0 || s->steps[second] > 0) { /* steps count from the low of the column that has them */
            const int with = s->steps[first] > 0 ? first : second, other = with == first ? second : first;
            const double step = s->steps[with], base = s->low[with];
            s->first[first] = fmax(s->first[with], ceil((s->low[other] - base) / step - 1e-9));
            s->last[first] = fmin(s->last[with], floor((s->high[other] - base) / step + 1e-9));
            snprintf(text, sizeof text, "parameters %s and %s are to be equal, but no step is in both ranges", one,
                     two);
            if (s->first[first] > s->last[first]) return text;
            s->low[first] = base, s->high[first] = s->high[with], s->steps[first] = step;
        } else {
            s->low[first] = fmax(s->low[first], s->low[second]);
            s->high[first] = fmin(s->high[first], s->high[second]);
        }
    }
    return NULL;
}

/* s is to be freed only if there is no problem. */
static inline const char *space_make(space_kept *s, const space_wish *wish, int m)
{
    static char text[200];
    char name[48];
    const size_t size = (size_t)m * sizeof(double);
    const char *problem = NULL;
    int *owner = (int *)calloc((size_t)m + 1, sizeof *owner), i, k;
    memset(s, 0, sizeof *s);
    s->m = m;
    s->names = wish->names;
    s->low = (double *)calloc(7, size + 1);
    s->lead = (int *)malloc((size_t)m * sizeof(int));
    s->equal = (int *)malloc((2 * (size_t)wish->equal_count + 1) * sizeof(int));
    s->lists = (space_list *)calloc((size_t)wish->list_count + 1, sizeof *s->lists);
    if (!owner || !s->low || !s->lead || !s->equal || !s->lists) problem = "out of memory";
    for (k = 0; k < m && !problem; ++k) {
        s->high = s->low + m, s->steps = s->high + m, s->box_low = s->steps + m, s->box_high = s->box_low + m;
        s->first = s->box_high + m, s->last = s->first + m;
        s->lead[k] = k;
        s->box_low[k] = s->low[k] = wish->low ? wish->low[k] : -HUGE_VAL;
        s->box_high[k] = s->high[k] = wish->high ? wish->high[k] : HUGE_VAL;
        s->steps[k] = wish->steps && s->high[k] > s->low[k] ? wish->steps[k] : 0;
        if (!(s->low[k] <= s->high[k])) problem = "has an empty range: its low end is above its high end";
        if (!(s->steps[k] >= 0 && s->steps[k] < HUGE_VAL)) problem = "has a step that is not a number of at least 0";
        if (s->steps[k] > 0 && !(s->high[k] - s->low[k] < HUGE_VAL)) problem = "comes in steps but has no range";
        snprintf(text, sizeof text, "parameter %s %s", space__name(s, k, name), problem ? problem : "");
        if (problem) problem = text;
        if (problem || !(s->steps[k] > 0)) continue;
        s->last[k] = floor((s->high[k] - s->low[k]) / s->steps[k] + 1e-9);
        s->box_low[k] -= 0.5 * s->steps[k]; /* all steps are as likely */
        s->box_high[k] = s->low[k] + s->steps[k] * (s->last[k] + 0.5);
        s->snaps = 1;
    }
    if (!problem && wish->equal_count > 0) memcpy(s->equal, wish->equal, 2 * (size_t)wish->equal_count * sizeof(int));
    s->equal_count = wish->equal_count;
    s->snaps |= wish->equal_count > 0 || wish->list_count > 0;
    for (i = 0; i < wish->list_count && !problem; ++i) {
        s->list_count = i + 1;
        problem = space__list(s, &wish->lists[i], i, owner);
    }
    if (!problem) problem = space__equal(s, owner);
    free(owner);
    if (problem) space_free(s);
    return problem;
}

/* Columns without bounds get a round range that holds those of the materials x [n][m]: [0, 1] or another unit's, or
   steps of 1, 2 or 5 times a power of ten. A locked column, equal in 8 rows or more, keeps its value. */
static inline void space_round(space_kept *s, const double *x, int n)
{
    static const double unit[][2] = {{0, 1}, {-1, 1}, {0, 100}, {0, 255}, {0, 360}, {-180, 180}};
    int i, k;
    for (k = 0; k < s->m; ++k) {
        double least = HUGE_VAL, largest = -HUGE_VAL, low, high, step;
        for (i = 0; i < n; ++i) {
            least = fmin(least, x[(size_t)i * (size_t)s->m + (size_t)k]);
            largest = fmax(largest, x[(size_t)i * (size_t)s->m + (size_t)k]);
        }
        low = least, high = largest;
        for (i = 0; i < 6; ++i) /* [0, 1] holds any such values; another unit's those that fill most of it */
            if (least >= unit[i][0] && largest <= unit[i][1] &&
                (i == 0 || largest - least > 0.8 * (unit[i][1] - unit[i][0])))
                break;
        if (n >= 8 && !(largest > least)) i = 7;
        if (i < 6) low = unit[i][0], high = unit[i][1];
        else if (largest > least) {
            step = pow(10, floor(log10((largest - least) / 8)));
            step *= 5 * step <= (largest - least) / 8 ? 5 : 2 * step <= (largest - least) / 8 ? 2 : 1;
            low = step * floor(least / step);
            high = step * ceil(largest / step);
        }
        if (s->box_low[k] < -1e300) s->box_low[k] = low;
        if (s->box_high[k] > 1e300) s->box_high[k] = high;
    }
}

static inline ms_gpr_space space_of(const space_kept *s)
{
    ms_gpr_space box;
    memset(&box, 0, sizeof box);
    box.low = s->box_low;
    box.high = s->box_high;
    box.snap = s->snaps ? space__snap : NULL;
    box.user = (void *)(uintptr_t)s;
    return box;
}
#endif
