/* Words in a picture: a typeface of even strokes, drawn for these examples, at any size, with smooth edges. image.h
   comes first.

     image_text(&im, left, top, "score 7.5", 16, rgb);      16 pixels high, p and q included; cut at the edges
     width = image_text_width("score 7.5", 16);             in pixels
     image_text_in(&im, left, top, width, "7.5", 16, rgb);  in the middle of a width

   Letters, digits and . , : ; ' ! ? - + = _ | ( ) / % < > * and \xd7, the multiplication sign; else a box. */
#ifndef EXAMPLES_TEXT_H
#define EXAMPLES_TEXT_H

/* A glyph: its advance, then strokes in fortieths of the size, the baseline at 0, capitals 28 high. M: from here. L: a
   line. q: a parabola with a control point. h, v: a quarter of an oval that leaves horizontally, or vertically. */
static inline const char *text__glyph(unsigned char letter)
{
    static const char *const glyphs[95] = {"10",
                                           "9M4 28L4 9M4 0L4 0",
                                           NULL,
                                           NULL,
                                           NULL,
                                           "29M3 22v7 28h11 22v7 16h3 22M18 6v22 12h26 6v22 0h18 6M22 28L7 0", /* % */
                                           NULL,
                                           "8M4 28L4 22",
                                           "13M10 31q4 24 4 13q4 2 10 -6",
                                           "13M3 31q9 24 9 13q9 2 3 -6",
                                           "18M9 28L9 16M4 25L14 19M14 25L4 19",
                                           "25M4 12L20 12M12 20L12 4",
                                           "9M5 1L3 -5",
                                           "17M4 11L13 11",
                                           "8M4 0L4 0",
                                           "15M2 -4L13 30", /* / */
                                           "22M4 14v11 28h18 14v11 0h4 14",
                                           "22M5 22L12 28L12 0",
                                           "22M4 21q5 28 11 28h18 21q18 16 13 11L4 0L19 0",
                                           "22M5 25q7 28 11 28h18 22v11 15L9 15M11 15h18 7v10 0q6 0 4 3",
                                           "22M14 0L14 28L3 8L19 8",
                                           "22M17 28L6 28L5 15q8 18 11 18h18 9v10 0q6 0 4 3",
                                           "22M15 28q4 24 4 9v11 0h18 9v11 17h4 9",
                                           "22M4 28L18 28L8 0",
                                           "22M11 15h5 22v11 28h17 22v11 15h4 8v11 0h18 8v11 15",
                                           "22M7 0q18 4 18 19v11 28h4 19v11 11h18 19",
                                           "9M4 17L4 17M4 0L4 0",
                                           "9M5 17L5 17M5 1L3 -5",
                                           "23M19 20L4 12L19 4",
                                           "25M4 16L20 16M4 8L20 8",
                                           "23M4 20L19 12L4 4",
                                           "20M4 23q5 28 10 28h17 22q17 17 10 13L10 9M10 0L10 0", /* ? */
                                           NULL,
                                           "26M3 0L13 28L23 0M7 10L19 10",
                                           "25M4 0L4 28L12 28h20 22v12 15L4 15M12 15h21 8v12 0L4 0",
                                           "27M23 23q20 28 14 28h4 14v14 0q20 0 23 5",
                                           "28M4 0L4 28L11 28h24 14v11 0L4 0",
                                           "23M19 28L4 28L4 0L19 0M4 15L17 15",
                                           "21M18 28L4 28L4 0M4 14L16 14",
                                           "28M23 23q20 28 14 28h4 14v14 0q20 0 24 4L24 13L16 13",
                                           "26M4 28L4 0M22 28L22 0M4 15L22 15",
                                           "8M4 28L4 0",
                                           "17M13 28L13 7v7 0q4 0 2 3",
                                           "23M4 28L4 0M20 28L4 12M9 17L21 0",
                                           "20M4 28L4 0L18 0",
                                           "30M4 0L4 28L15 8L26 28L26 0",
                                           "26M4 0L4 28L22 0L22 28",
                                           "30M4 14v15 28h26 14v15 0h4 14",
                                           "24M4 0L4 28L13 28h21 20v13 12L4 12",
                                           "30M4 14v15 28h26 14v15 0h4 14M18 6L26 -2",
                                           "25M4 0L4 28L13 28h21 21v13 13L4 13M13 13L22 0",
                                           "25M20 24q17 28 12 28h4 21q4 16 12 14q21 12 21 7v12 0q6 0 3 4",
                                           "24M2 28L22 28M12 28L12 0",
                                           "26M4 28L4 10v13 0h22 10L22 28",
                                           "26M3 28L13 0L23 28",
                                           "36M3 28L10 0L18 28L26 0L33 28",
                                           "24M3 28L21 0M21 28L3 0",
                                           "24M3 28L12 13L21 28M12 13L12 0",
                                           "24M4 28L20 28L4 0L21 0", /* Z */
                                           NULL,
                                           NULL,
                                           NULL,
                                           NULL,
                                           "22M2 -5L20 -5",
                                           NULL,
                                           "24M5 15q6 20 12 20h19 13L19 0M19 11L12 11h4 6v10 0h19 7",
                                           "24M4 29L4 0M4 10v12 20h20 10v12 0h4 10", /* a */
                                           "22M19 17q16 20 12 20h4 10v12 0q16 0 19 3",
                                           "24M20 29L20 0M20 10v12 20h4 10v12 0h20 10",
                                           "24M4 11L20 11v12 20h4 10v12 0q17 0 19 4",
                                           "16M15 29h8 23L8 0M3 20L14 20",
                                           "24M20 20L20 -1v12 -8q7 -8 5 -5M20 10v12 20h4 10v12 0h20 10",
                                           "23M4 29L4 0M4 12v12 20h19 13L19 0",
                                           "8M4 20L4 0M4 28L4 28",
                                           "10M6 20L6 -4q6 -8 1 -8M6 28L6 28",
                                           "21M4 29L4 0M18 20L4 8M9 12L19 0",
                                           "8M4 29L4 0",
                                           "34M4 20L4 0M4 13v11 20h17 14L17 0M17 13v24 20h30 14L30 0",
                                           "23M4 20L4 0M4 12v12 20h19 13L19 0",
                                           "24M4 10v12 20h20 10v12 0h4 10",
                                           "24M4 20L4 -8M4 10v12 20h20 10v12 0h4 10",
                                           "24M20 20L20 -8M20 10v12 20h4 10v12 0h20 10",
                                           "15M4 20L4 0M4 11v13 20",
                                           "20M16 17q14 20 10 20h4 15q4 11 10 10q17 9 17 5v10 0q6 0 3 3",
                                           "16M8 26L8 6v14 0M3 20L14 20",
                                           "23M4 20L4 7v11 0h19 8M19 20L19 0",
                                           "22M3 20L11 0L19 20",
                                           "32M3 20L9 0L16 20L23 0L29 20",
                                           "20M3 20L17 0M17 20L3 0",
                                           "22M3 20L11 1M19 20L9 -5q8 -8 3 -8",
                                           "21M4 20L17 20L4 0L18 0", /* z */
                                           NULL,
                                           "9M4 31L4 -6",
                                           NULL,
                                           NULL};
    const char *glyph = letter > 31 && letter < 127 ? glyphs[letter - 32] : NULL;
    if (letter == 0xd7) glyph = "22M4 19L18 5M18 19L4 5";
    return glyph ? glyph : "24M4 28L20 28L20 0L4 0L4 28";
}

static inline double text__distance(double x, double y, const double *a, const double *b)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], length = dx * dx + dy * dy;
    double t = length > 0 ? ((x - a[0]) * dx + (y - a[1]) * dy) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(x - a[0] - t * dx, y - a[1] - t * dy);
}

enum { TEXT__POINTS = 200, TEXT__STEPS = 10, TEXT__TRACK = 1 }; /* fortieths between glyphs, besides their own */

/* The strokes of a glyph as short lines, in pixels right of and below (x, y), the start of the baseline; how many
   points, of which those with new_stroke begin a stroke. */
static inline int text__lines(const char *at, double x, double y, double unit, double (*point)[2], char *new_stroke)
{
    double p[3][2]; /* control points after the last point, and the end */
    int count = 0, i, k, c;
    while (*at && count + TEXT__STEPS < TEXT__POINTS) {
        char kind = *at++, *end;
        int numbers = kind == 'q' ? 4 : 2;
        double number[4] = {0, 0, 0, 0}, *from = point[count ? count - 1 : 0];
        for (i = 0; i < numbers; ++i, at = end)
            number[i] = i % 2 ? y - unit * (double)strtol(at, &end, 10) : x + unit * (double)strtol(at, &end, 10);
        if (kind == 'M' || kind == 'L') {
            new_stroke[count] = kind == 'M';
            memcpy(point[count++], number, sizeof *point);
            continue;
        }
        for (c = 0; c < 2; ++c) { /* a cubic curve; 0.6: a little squarer than an ellipse, whose number is 0.5523 */
            int first = kind == 'q' || (c == 0) == (kind == 'h'), last = kind == 'q' || !first;
            double to = number[numbers - 2 + c], near_end = kind == 'q' ? 2.0 / 3 : 0.6,
                   bend = kind == 'q' ? number[c] : to;
            p[0][c] = from[c] + (first ? near_end * (bend - from[c]) : 0);
            bend = kind == 'q' ? number[c] : from[c];
            p[1][c] = to + (last ? near_end * (bend - to) : 0);
            p[2][c] = to;
        }
        for (k = 1; k <= TEXT__STEPS; ++k, ++count) {
            double t = k / (double)TEXT__STEPS, s = 1 - t;
            new_stroke[count] = 0;
            for (c = 0; c < 2; ++c)
                point[count][c] = s * s * s * from[c] + 3 * s * t * (s * p[0][c] + t * p[1][c]) + t * t * t * p[2][c];
        }
    }
    return count;
}

static inline int image_text_width(const char *text, int size)
{
    long sum = 0;
    for (; *text; ++text) sum += strtol(text__glyph((unsigned char)*text), NULL, 10) + TEXT__TRACK;
    return (int)((sum * size + 39) / 40);
}

static inline void image_text(image *im, int left, int top, const char *text, int size, const float *rgb)
{
    double point[TEXT__POINTS][2], unit = size / 40.0, pen = left, thick = unit * 3.6, baseline = top + 30.5 * unit;
    char new_stroke[TEXT__POINTS], *strokes;
    int x, y, c, i;
    for (; *text; ++text) {
        long advance = strtol(text__glyph((unsigned char)*text), &strokes, 10);
        int count = text__lines(strokes, pen, baseline, unit, point, new_stroke);
        int last = (int)ceil(pen + unit * (double)advance);
        for (y = top > 0 ? top : 0; count && y < top + size && y < im->height; ++y)
            for (x = pen > 0 ? (int)pen : 0; x < last && x < im->width; ++x) {
                double nearest = 1e30, cover;
                for (i = 0; i < count; ++i) {
                    double distance = text__distance(x + 0.5, y + 0.5, point[new_stroke[i] ? i : i - 1], point[i]);
                    nearest = distance < nearest ? distance : nearest;
                }
                cover = 0.5 + 0.5 * thick - nearest;
                cover = cover < 0 ? 0 : cover > 1 ? 1 : cover;
                for (c = 0; c < im->channels && c < 3; ++c) {
                    float *value = &im->pixels[im->channels * (y * im->width + x) + c];
                    *value += (float)cover * (rgb[im->channels < 3 ? 1 : c] - *value);
                }
            }
        pen += unit * (double)(advance + TEXT__TRACK);
    }
}

static inline void image_text_in(image *im, int left, int top, int width, const char *text, int size, const float *rgb)
{
    image_text(im, left + (width - image_text_width(text, size)) / 2, top, text, size, rgb);
}
#endif
