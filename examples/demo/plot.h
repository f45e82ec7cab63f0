/* Line and scatter plots as SVG: text that any browser draws, with no font code.

     static plot p;                       (about 4 KB: not on a small stack)
     plot_begin(&p, "title", "x label", "y label", PLOT_LOG_X | PLOT_LOG_Y);
     plot_series(&p, "name", x, y, n, PLOT_LINE | PLOT_DOTS);
     if (!plot_write(&p, "out.svg")) ...  (0: the file could not be written)

   The arrays stay the caller's and must live until plot_write. NaN, infinite and, on a log axis, non-positive
   values interrupt a line. plot_range sets an axis by hand. */
#ifndef EXAMPLES_PLOT_H
#define EXAMPLES_PLOT_H
#include "../tools/files.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define PLOT_LOG_X 1
#define PLOT_LOG_Y 2
#define PLOT_LEGEND_INSIDE 4 /* at the lower left, for curves that fall; the plot is narrow */
#define PLOT_LINE 1
#define PLOT_DOTS 2
#define PLOT_DASHED 4
#define PLOT_SERIES_MAX 40

typedef struct plot_line {
    const char *name, *color;
    const double *x, *y;
    int count, style;
} plot_line;

typedef struct plot {
    const char *title, *x_label, *y_label;
    int flags, count, width, height;
    double x_min, x_max, y_min, y_max; /* x_min >= x_max: from the data */
    plot_line series[PLOT_SERIES_MAX];
} plot;

static void plot_begin(plot *p, const char *title, const char *x_label, const char *y_label, int flags)
{
    memset(p, 0, sizeof *p);
    p->title = title;
    p->x_label = x_label;
    p->y_label = y_label;
    p->flags = flags;
    p->width = 860;
    p->height = 480;
}

/* A color is any of SVG's ("#c33"); NULL takes the next of the built-in list. */
static void plot_series_color(plot *p, const char *name, const double *x, const double *y, int n, int style,
                              const char *color)
{
    static const char *const colors[] = {"#1b6ca8", "#d1495b", "#2e933c", "#e08e0b", "#7b4fa3", "#118a8b",
                                         "#9c5518", "#5f6b75", "#d45bb3", "#8a9a10", "#3c3fa8"};
    plot_line *s;
    if (p->count == PLOT_SERIES_MAX) return;
    s = &p->series[p->count++];
    s->name = name;
    s->x = x;
    s->y = y;
    s->count = n;
    s->style = style;
    s->color = color ? color : colors[(p->count - 1) % (int)(sizeof colors / sizeof colors[0])];
}

static void plot_series(plot *p, const char *name, const double *x, const double *y, int n, int style)
{
    plot_series_color(p, name, x, y, n, style, NULL);
}

static void plot_range(plot *p, double x_min, double x_max, double y_min, double y_max)
{
    p->x_min = x_min;
    p->x_max = x_max;
    p->y_min = y_min;
    p->y_max = y_max;
}

static int plot__usable(double v, int log_axis) { return v - v == 0 && (!log_axis || v > 0); }

static void plot__limits(const plot *p, int axis, double *low, double *high)
{
    int log_axis = p->flags & (axis ? PLOT_LOG_Y : PLOT_LOG_X), i, k;
    double a = 1e300, b = -1e300;
    if (axis ? p->y_min < p->y_max : p->x_min < p->x_max) {
        *low = axis ? p->y_min : p->x_min;
        *high = axis ? p->y_max : p->x_max;
        return;
    }
    for (k = 0; k < p->count; ++k) {
        for (i = 0; i < p->series[k].count; ++i) {
            double v = axis ? p->series[k].y[i] : p->series[k].x[i];
            if (!plot__usable(v, log_axis)) continue;
            if (v < a) a = v;
            if (v > b) b = v;
        }
    }
    if (a > b) {
        a = log_axis ? 0.1 : 0;
        b = 1;
    }
    if (log_axis) {
        if (b / a < 2) {
            a /= 1.5;
            b *= 1.5;
        }
        *low = a / 1.15;
        *high = b * 1.15;
    } else {
        double pad = b > a ? 0.04 * (b - a) : b != 0 ? fabs(b) : 1;
        *low = a >= 0 && a < 0.3 * b ? 0 : a - pad;
        *high = b + pad;
    }
}

/* Position of v along an axis from 0 to 1. */
static double plot__place(double v, double low, double high, int log_axis)
{
    return log_axis ? log(v / low) / log(high / low) : (v - low) / (high - low);
}

static void plot__text(FILE *f, const char *text)
{
    for (; *text; ++text) {
        if (*text == '<') fputs("&lt;", f);
        else if (*text == '&') fputs("&amp;", f);
        else fputc(*text, f);
    }
}

/* Tick values of an axis into out[32]; their count. */
static int plot__ticks(double low, double high, int log_axis, double *out)
{
    int n = 0;
    if (log_axis) {
        int e, first = (int)floor(log10(low)), last = (int)ceil(log10(high)), m;
        int step = (last - first) / 10 + 1;
        for (e = first; e <= last; e += step) {
            for (m = 1; m <= 5; m += m == 1 ? 1 : 3) {
                double v = m * pow(10.0, e);
                if (m > 1 && last - first > 3) break;
                if (v >= low && v <= high && n < 32) out[n++] = v;
            }
        }
    } else {
        double raw = (high - low) / 6, unit = pow(10.0, floor(log10(raw))), v;
        unit *= raw / unit < 1.5 ? 1 : raw / unit < 3.5 ? 2 : raw / unit < 7.5 ? 5 : 10;
        for (v = ceil(low / unit) * unit; v <= high + 1e-9 * unit && n < 32; v += unit)
            out[n++] = fabs(v) < 1e-9 * unit ? 0 : v;
    }
    return n;
}

/* fprintf with '.' before decimals in every locale; the texts that it gets hold nothing else between digits. */
static void plot__print(FILE *f, const char *format, ...)
{
    const char *point = localeconv()->decimal_point;
    char text[1024], *at = text;
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    while (strcmp(point, ".") != 0 && (at = strstr(at, point)) != NULL) {
        if (at > text && at[-1] >= '0' && at[-1] <= '9' && at[strlen(point)] >= '0' && at[strlen(point)] <= '9') {
            *at = '.';
            memmove(at + 1, at + strlen(point), strlen(at + strlen(point)) + 1);
        }
        ++at;
    }
    fputs(text, f);
}

static int plot_write(const plot *p, const char *path)
{
    double x0, x1, y0, y1, tick[32];
    int log_x = p->flags & PLOT_LOG_X, log_y = p->flags & PLOT_LOG_Y, i, k, n;
    double left = 76, right = p->width - (p->flags & PLOT_LEGEND_INSIDE ? 14.0 : 210.0), top = 44,
           bottom = p->height - 56.0;
    file_out out;
    FILE *f = file_create(path, &out);
    if (f == NULL) return 0;
    plot__limits(p, 0, &x0, &x1);
    plot__limits(p, 1, &y0, &y1);
    plot__print(f,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
                "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n",
                p->width, p->height, p->width, p->height);
    plot__print(f,
                "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n<clipPath id=\"area\"><rect x=\"%g\" y=\"%g\" "
                "width=\"%g\" height=\"%g\"/></clipPath>\n",
                left, top, right - left, bottom - top);
    plot__print(f, "<text x=\"%g\" y=\"26\" font-size=\"16\" fill=\"#222\">", left);
    plot__text(f, p->title);
    plot__print(f, "</text>\n<g stroke=\"#e3e6e8\" stroke-width=\"1\" fill=\"#444\">\n");
    n = plot__ticks(x0, x1, log_x, tick);
    for (i = 0; i < n; ++i) {
        double x = left + plot__place(tick[i], x0, x1, log_x) * (right - left);
        plot__print(
            f, "<path d=\"M%.1f %g V%g\"/><text x=\"%.1f\" y=\"%g\" text-anchor=\"middle\" stroke=\"none\">%g</text>\n",
            x, top, bottom, x, bottom + 18, tick[i]);
    }
    n = plot__ticks(y0, y1, log_y, tick);
    for (i = 0; i < n; ++i) {
        double y = bottom - plot__place(tick[i], y0, y1, log_y) * (bottom - top);
        plot__print(
            f, "<path d=\"M%g %.1f H%g\"/><text x=\"%g\" y=\"%.1f\" text-anchor=\"end\" stroke=\"none\">%g</text>\n",
            left, y, right, left - 8, y + 4, tick[i]);
    }
    plot__print(f, "</g>\n<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"none\" stroke=\"#9aa2a8\"/>\n",
                left, top, right - left, bottom - top);
    plot__print(f, "<text x=\"%g\" y=\"%g\" text-anchor=\"middle\" fill=\"#222\">", (left + right) / 2, bottom + 42);
    plot__text(f, p->x_label);
    plot__print(f, "</text>\n<text transform=\"translate(18 %g) rotate(-90)\" text-anchor=\"middle\" fill=\"#222\">",
                (top + bottom) / 2);
    plot__text(f, p->y_label);
    plot__print(f, "</text>\n");
    for (k = 0; k < p->count; ++k) {
        const plot_line *s = &p->series[k];
        double x_legend = right + 14, y_legend = top + 12 + 18 * k;
        const char *dash = s->style & PLOT_DASHED ? " stroke-dasharray=\"6 4\"" : "";
        if (p->flags & PLOT_LEGEND_INSIDE) x_legend = left + 10, y_legend = bottom - 12 - 18 * (p->count - 1 - k);
        plot__print(f, "<g clip-path=\"url(#area)\" stroke=\"%s\" fill=\"%s\">\n", s->color, s->color);
        if (s->style & PLOT_LINE) {
            int pen = 0;
            plot__print(f, "<path fill=\"none\" stroke-width=\"2\" stroke-linejoin=\"round\"%s d=\"", dash);
            for (i = 0; i < s->count; ++i) {
                if (!plot__usable(s->x[i], log_x) || !plot__usable(s->y[i], log_y)) {
                    pen = 0;
                    continue;
                }
                plot__print(f, "%c%.1f %.1f", pen ? 'L' : 'M',
                            left + plot__place(s->x[i], x0, x1, log_x) * (right - left),
                            bottom - plot__place(s->y[i], y0, y1, log_y) * (bottom - top));
                pen = 1;
            }
            plot__print(f, "\"/>\n");
        }
        if (s->style & PLOT_DOTS)
            for (i = 0; i < s->count; ++i)
                if (plot__usable(s->x[i], log_x) && plot__usable(s->y[i], log_y))
                    plot__print(f, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" stroke=\"none\"/>\n",
                                left + plot__place(s->x[i], x0, x1, log_x) * (right - left),
                                bottom - plot__place(s->y[i], y0, y1, log_y) * (bottom - top));
        plot__print(f, "</g>\n");
        if (s->name) {
            if (s->style & PLOT_LINE)
                plot__print(f, "<path d=\"M%g %g h22\" stroke=\"%s\" stroke-width=\"2\"%s/>", x_legend, y_legend,
                            s->color, dash);
            if (s->style & PLOT_DOTS)
                plot__print(f, "<circle cx=\"%g\" cy=\"%g\" r=\"3.5\" fill=\"%s\"/>", x_legend + 11, y_legend,
                            s->color);
            plot__print(f, "<text x=\"%g\" y=\"%g\" fill=\"#222\">", x_legend + 28, y_legend + 4);
            plot__text(f, s->name);
            plot__print(f, "</text>\n");
        }
    }
    plot__print(f, "</svg>\n");
    return file_finish(&out, 1) == NULL;
}

/* Keeps -Wunused-function quiet where a program needs only a part. */
static inline void plot__use(void)
{
    (void)&plot_range;
    (void)&plot_series;
    (void)&plot_series_color;
    (void)&plot_begin;
    (void)&plot_write;
}
#endif
