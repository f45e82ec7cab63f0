/* WGSL of the shader files of examples/engine/shader: a preprocessor, and declarations turned round. It reads what
   those files use: #define with and without parameters, #if, #ifdef, #elif, #else, #endif, integer expressions; one
   variable a declaration, no assignment to several components, `pick` in place of ?:. */
#ifndef WGSL_H
#define WGSL_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WGSL_MACROS = 160, WGSL_DEPTH = 24, WGSL_LINE = 8000 };

typedef struct wgsl_macro {
    const char *name, *parameters, *body; /* parameters: after the parenthesis, or NULL */
    int name_length, body_length;
} wgsl_macro;

typedef struct wgsl_state {
    wgsl_macro macro[WGSL_MACROS];
    int macros;
    char *out; /* of `capacity` characters */
    size_t length, capacity;
    const char *problem; /* NULL: none so far */
    int braces, parentheses;
    const char *result; /* the type that the arrow before a function's body names, or NULL */
    int result_length;
} wgsl_state;

/* What languages differ in: before the files, and after them. */
static const char *const wgsl_before = "#define MS_SSS_WGSL\n"
                                       "#define int i32\n"
                                       "#define uint u32\n"
                                       "#define float f32\n"
                                       "#define int2 vec2<i32>\n"
                                       "#define float2 vec2<f32>\n"
                                       "#define float3 vec3<f32>\n"
                                       "#define float4 vec4<f32>\n"
                                       "#define bits_of bitcast<u32>\n"
                                       "#define float_of bitcast<f32>\n"
                                       "#define pick select\n"
                                       "#define CONSTANT ms_sss.v\n"
                                       "#define TEXTURE(name, fetch, slot, at) @group(0) @binding(slot) var name: "
                                       "texture_2d<f32>; fn fetch(p: vec2<i32>) -> vec4<f32> { return "
                                       "textureLoad(name, p, 0); }\n";
static const char *const wgsl_after =
    "#if MS_SSS_STEP != 8\n"
    "\n"
    "struct ms_sss_block { v: array<vec4<f32>, COUNT> };\n"
    "@group(0) @binding(0) var<uniform> ms_sss: ms_sss_block;\n"
    "\n"
    "#if PYRAMID\n"
    "var<private> ms_sss_other: vec4<f32>;\n"
    "\n"
    "struct ms_sss_targets { @location(0) first: vec4<f32>, @location(1) other: vec4<f32> };\n"
    "@fragment\n"
    "fn main(@builtin(position) position: vec4<f32>) -> ms_sss_targets {\n"
    "    let first = filter_pixel(vec2<i32>(position.xy));\n"
    "    return ms_sss_targets(first, ms_sss_other);\n"
    "}\n"
    "#else\n"
    "@fragment\n"
    "fn main(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {\n"
    "    return filter_pixel(vec2<i32>(position.xy));\n"
    "}\n"
    "#endif\n"
    "#endif\n";

/* The usual variants, which stand beside the files. */
typedef struct wgsl_variant {
    const char *file, *defines; /* lines of #define */
} wgsl_variant;
static const wgsl_variant wgsl_usual[4] = {
    {"x.wgsl", "#define MS_SSS_STEP 0\n"},
    {"y.wgsl", "#define MS_SSS_STEP 1\n"},
    {"x_materials.wgsl",
     "#define MS_SSS_STEP 0\n#define MS_SSS_PROFILES 16\n#define MS_SSS_SLOPES 2\n#define MS_SSS_STRENGTH 1\n"},
    {"y_materials.wgsl",
     "#define MS_SSS_STEP 1\n#define MS_SSS_PROFILES 16\n#define MS_SSS_SLOPES 2\n#define MS_SSS_STRENGTH 1\n"}};

static int wgsl_is_name(char c)
{
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/* The length of the name or number at s, 0: neither. */
static int wgsl_word(const char *s)
{
    int n = 0;
    while (wgsl_is_name(s[n])) ++n;
    return n;
}

static int wgsl_is(const char *s, int n, const char *word)
{
    return (int)strlen(word) == n && strncmp(s, word, (size_t)n) == 0;
}

static const wgsl_macro *wgsl_find(const wgsl_state *w, const char *s, int n)
{
    int i;
    for (i = w->macros - 1; i >= 0; --i)
        if (w->macro[i].name_length == n && strncmp(w->macro[i].name, s, (size_t)n) == 0) return &w->macro[i];
    return NULL;
}

/* Appends to a line that macros are expanded into. */
static void wgsl_put(wgsl_state *w, char *line, const char *s, int n)
{
    const size_t length = strlen(line);
    if (length + (size_t)n >= WGSL_LINE) {
        w->problem = "a line is too long";
        return;
    }
    memcpy(line + length, s, (size_t)n);
    line[length + (size_t)n] = 0;
}

/* The value of an integer expression, in which comparisons are 0 or 1; *s ends behind it. level: the operators from the
   weakest on, || && == != < > <= >= + - * / */
static int wgsl_value(wgsl_state *w, const char **s, int level)
{
    static const char *const operators[6][4] = {{"||", NULL},           {"&&", NULL},     {"==", "!=", NULL, NULL},
                                                {"<=", ">=", "<", ">"}, {"+", "-", NULL}, {"*", "/", NULL}};
    int left, i, found;
    while (**s == ' ') ++*s;
    if (level == 6) {
        if (**s == '!') return ++*s, !wgsl_value(w, s, 6);
        if (**s == '(') {
            ++*s;
            left = wgsl_value(w, s, 0);
            while (**s == ' ') ++*s;
            if (**s != ')') w->problem = "a parenthesis is missing";
            else ++*s;
            return left;
        }
        if (**s < '0' || **s > '9') w->problem = "not an integer expression";
        left = (int)strtol(*s, NULL, 10);
        *s += wgsl_word(*s);
        return left;
    }
    left = wgsl_value(w, s, level + 1);
    do {
        while (**s == ' ') ++*s;
        for (found = -1, i = 0; i < 4 && found < 0 && operators[level][i]; ++i)
            if (strncmp(*s, operators[level][i], strlen(operators[level][i])) == 0) found = i;
        if (found >= 0) {
            int right;
            *s += strlen(operators[level][found]);
            right = wgsl_value(w, s, level + 1);
            if (level == 0) left = left || right;
            else if (level == 1) left = left && right;
            else if (level == 2) left = found == 0 ? left == right : left != right;
            else if (level == 3)
                left = found == 0 ? left <= right
                    : found == 1  ? left >= right
                    : found == 2  ? left < right
                                  : left > right;
            else if (level == 4) left = found == 0 ? left + right : left - right;
            else if (found == 0) left *= right;
            else if (right) left /= right;
        }
    } while (found >= 0 && !w->problem);
    return left;
}

/* Whether a text is an integer expression (1), one with comparisons (2) or neither (0). The words of comparisons become
   numbers in it. */
static int wgsl_constant(char *s)
{
    const size_t n = strlen(s);
    char *word;
    while ((word = strstr(s, "true")) != NULL) memcpy(word, "(1) ", 4);
    while ((word = strstr(s, "false")) != NULL) memcpy(word, "(0)  ", 5);
    if (n == 0 || strspn(s, "0123456789 ()+-*/<>=!&|") != n) return 0;
    return strpbrk(s, "<>=!&|") ? 2 : 1;
}

/* Appends s with its macros replaced; those of integers become their values. */
static void wgsl_expand(wgsl_state *w, const char *s, int length, char *line, int depth)
{
    const char *const end = s + length;
    if (depth > WGSL_DEPTH) w->problem = "macros of macros without an end";
    while (s < end && !w->problem) {
        const int n = wgsl_word(s) < (int)(end - s) ? wgsl_word(s) : (int)(end - s);
        const wgsl_macro *m = n ? wgsl_find(w, s, n) : NULL;
        if (s[0] == '/' && s + 1 < end && s[1] == '/') { /* a comment */
            wgsl_put(w, line, s, (int)(end - s));
            return;
        }
        if (!m || (m->parameters && s[n] != '(')) {
            wgsl_put(w, line, s, n ? n : 1);
            s += n ? n : 1;
        } else if (!m->parameters) {
            char *body = (char *)calloc(1, WGSL_LINE);
            const char *value = body;
            if (!body) {
                w->problem = "out of memory";
                return;
            }
            wgsl_expand(w, m->body, m->body_length, body, depth + 1);
            if (wgsl_constant(body) == 1) {
                char number[16];
                snprintf(number, sizeof number, "%d", wgsl_value(w, &value, 0));
                wgsl_put(w, line, number, (int)strlen(number));
            } else if (wgsl_constant(body) == 2) {
                const int holds = wgsl_value(w, &value, 0);
                wgsl_put(w, line, holds ? "true" : "false", holds ? 4 : 5);
            } else {
                wgsl_put(w, line, body, (int)strlen(body));
            }
            free(body);
            s += n;
        } else { /* with arguments: the body with each parameter's argument in its place, expanded again */
            const char *argument[8], *p = s + n + 1, *b, *name;
            int size[8], count = 0, open = 1, i, k;
            char *body = (char *)calloc(1, WGSL_LINE);
            argument[0] = p;
            for (; p < end && open; ++p) {
                open += (*p == '(' || *p == '[') - (*p == ')' || *p == ']');
                if ((*p == ',' && open == 1) || !open) {
                    size[count] = (int)(p - argument[count]);
                    if (++count == 8) w->problem = "more than 8 arguments";
                    else argument[count] = p + 1 + (p[1] == ' ');
                    if (w->problem) break;
                }
            }
            for (b = m->body; body && b < m->body + m->body_length && !w->problem; b += k) {
                k = wgsl_word(b) ? wgsl_word(b) : 1;
                name = m->parameters;
                for (i = 0; i < count && !(wgsl_word(name) == k && strncmp(name, b, (size_t)k) == 0); ++i) {
                    name += wgsl_word(name);
                    name += strspn(name, ", ");
                }
                wgsl_put(w, body, i < count ? argument[i] : b, i < count ? size[i] : k);
            }
            if (!body) w->problem = "out of memory";
            else wgsl_expand(w, body, (int)strlen(body), line, depth + 1);
            free(body);
            s = p;
        }
    }
}

/* Emits a line of code: TYPE name becomes name: TYPE, behind `var` in bodies; a function's type comes behind an arrow.
 */
static void wgsl_code(wgsl_state *w, const char *s, int length)
{
    static const char *const types[8] = {"bool", "int", "uint", "float", "int2", "float2", "float3", "float4"};
    const char *const end = s + length;
    char *turned = (char *)calloc(1, WGSL_LINE), *line = (char *)calloc(1, WGSL_LINE);
    size_t n;
    while (turned && s < end && !w->problem) {
        const int k = wgsl_word(s), m = k && s[k] == ' ' ? wgsl_word(s + k + 1) : 0;
        int i;
        if (s[0] == '/' && s[1] == '/') break;
        for (i = 0; i < 8 && !wgsl_is(s, k, types[i]); ++i) {}
        if (i < 8 && m && !w->braces && !w->parentheses && s[k + 1 + m] == '(') {
            wgsl_put(w, turned, "fn ", 3);
            wgsl_put(w, turned, s + k + 1, m);
            w->result = types[i];
            s += k + 1 + m;
        } else if (i < 8 && m) {
            wgsl_put(w, turned, "var ", w->braces ? 4 : 0);
            wgsl_put(w, turned, s + k + 1, m);
            wgsl_put(w, turned, ": ", 2);
            wgsl_put(w, turned, s, k);
            s += k + 1 + m;
        } else {
            wgsl_put(w, turned, s, k ? k : 1);
            w->braces += (*s == '{') - (*s == '}');
            w->parentheses += (*s == '(') - (*s == ')');
            if (*s == ')' && w->result && !w->parentheses) {
                wgsl_put(w, turned, " -> ", 4);
                wgsl_put(w, turned, w->result, (int)strlen(w->result));
                w->result = NULL;
            }
            s += k ? k : 1;
        }
    }
    if (turned && line) {
        wgsl_put(w, turned, s, (int)(end - s));
        wgsl_expand(w, turned, (int)strlen(turned), line, 0);
        n = strlen(line);
        if (w->length + n + 2 > w->capacity) w->problem = "there is no room for the text";
        else {
            memcpy(w->out + w->length, line, n);
            w->length += n;
            w->out[w->length++] = '\n';
            w->out[w->length] = 0;
        }
    } else {
        w->problem = "out of memory";
    }
    free(turned);
    free(line);
}

/* Whether the condition of an #if, #ifdef, #ifndef or #elif holds. */
static int wgsl_condition(wgsl_state *w, const char *directive, int n, const char *s, int length)
{
    char asked[WGSL_LINE] = "";
    char *line;
    const char *end = s + length, *value;
    int holds;
    if (wgsl_is(directive, n, "ifdef") || wgsl_is(directive, n, "ifndef"))
        return (wgsl_find(w, s, wgsl_word(s)) != NULL) == wgsl_is(directive, n, "ifdef");
    while (s < end && !(s[0] == '/' && s[1] == '/')) { /* defined(NAME) first, which is not expanded */
        if (strncmp(s, "defined(", 8) == 0) {
            const int k = wgsl_word(s + 8);
            wgsl_put(w, asked, wgsl_find(w, s + 8, k) ? "1" : "0", 1);
            s += 8 + k + 1;
        } else {
            wgsl_put(w, asked, s++, 1);
        }
    }
    line = (char *)calloc(1, WGSL_LINE);
    if (!line) return w->problem = "out of memory", 0;
    wgsl_expand(w, asked, (int)strlen(asked), line, 0);
    if (!wgsl_constant(line)) w->problem = "a condition is no integer expression";
    value = line;
    holds = wgsl_value(w, &value, 0);
    free(line);
    return holds;
}

/* Translates one text; what follows it goes on with its macros. */
static void wgsl_text(wgsl_state *w, const char *s)
{
    int taken[32], done[32], depth = 0; /* of the open #if: whether its lines count now; whether one part did */
    const char *comment = NULL;         /* lines of comment that wait for code to follow */
    taken[0] = 1;
    while (*s && !w->problem) {
        const char *end = strchr(s, '\n') ? strchr(s, '\n') : s + strlen(s);
        const int length = (int)(end - s);
        if (*s == '#') {
            const char *directive = s + 1, *rest;
            const int n = wgsl_word(directive);
            rest = directive + n + strspn(directive + n, " ");
            if (strncmp(directive, "if", 2) == 0 && depth < 31) {
                ++depth;
                taken[depth] = taken[depth - 1] && wgsl_condition(w, directive, n, rest, (int)(end - rest));
                done[depth] = taken[depth];
            } else if (wgsl_is(directive, n, "elif") && depth) {
                taken[depth] = taken[depth - 1] && !done[depth] &&
                    wgsl_condition(w, directive, n, rest, (int)(end - rest));
                done[depth] |= taken[depth];
            } else if (wgsl_is(directive, n, "else") && depth) {
                taken[depth] = taken[depth - 1] && !done[depth];
            } else if (wgsl_is(directive, n, "endif") && depth) {
                --depth;
                comment = NULL;
            } else if (wgsl_is(directive, n, "define") && taken[depth]) {
                wgsl_macro *m = &w->macro[w->macros];
                const char *stop = strstr(rest, " //");
                if (w->macros == WGSL_MACROS) w->problem = "too many macros";
                else ++w->macros;
                m->name = rest;
                m->name_length = wgsl_word(rest);
                rest += m->name_length;
                m->parameters = *rest == '(' ? rest + 1 : NULL;
                if (m->parameters) rest = strchr(rest, ')') + 1;
                m->body = rest + strspn(rest, " ");
                m->body_length = (int)((stop && stop < end ? stop : end) - m->body);
                if (m->body_length < 0) m->body_length = 0;
                comment = NULL;
            }
        } else if (taken[depth] && s[0] == '/' && s[1] == '/') {
            if (!comment) comment = s;
        } else if (taken[depth] && !length) { /* one empty line, and none where comments wait */
            if (!comment && w->length > 1 && w->out[w->length - 2] != '\n') wgsl_code(w, s, 0);
        } else if (taken[depth]) {
            while (comment && comment < s) { /* but not the directives between them */
                const char *stop = strchr(comment, '\n');
                if (*comment != '#') wgsl_code(w, comment, (int)(stop - comment));
                comment = stop + 1;
            }
            comment = NULL;
            wgsl_code(w, s, length);
        }
        s = *end ? end + 1 : end;
    }
    if (depth && !w->problem) w->problem = "an #endif is missing";
}

/* WGSL of the lines of #define and of ms_sss.glsl (with a step of the pyramid: and ms_sss_pyramid.glsl, else NULL) into
   out. NULL, or what is wrong. */
static inline const char *wgsl_make(const char *defines, const char *shader, const char *pyramid, char *out,
                                    size_t capacity)
{
    wgsl_state *w = (wgsl_state *)calloc(1, sizeof *w);
    const char *problem;
    if (!w || !capacity) return free(w), "out of memory";
    w->out = out;
    w->capacity = capacity;
    out[0] = 0;
    wgsl_text(w, wgsl_before);
    wgsl_text(w, defines);
    wgsl_text(w, shader);
    if (pyramid) wgsl_text(w, pyramid);
    wgsl_text(w, wgsl_after);
    problem = w->problem;
    free(w);
    return problem;
}

/* A usual variant, with what was defined in its first lines. */
static inline const char *wgsl_usual_text(const wgsl_variant *v, const char *shader, char *out, size_t capacity)
{
    static const char first[] = "// Of ms_sss.glsl by examples/tools/sss_wgsl.c, with\n",
                      last[] = "// and the defaults. The module adds the functions ms_sss_fetch_... that it calls.\n\n";
    const char *s;
    char *to = out;
    if (capacity < sizeof first + sizeof last + 2 * strlen(v->defines)) return "there is no room for the text";
    memcpy(to, first, sizeof first);
    to += sizeof first - 1;
    for (s = v->defines; *s; *to++ = *s++) {
        if (s != v->defines && s[-1] != '\n') continue;
        memcpy(to, "//     ", 7);
        to += 7;
    }
    memcpy(to, last, sizeof last);
    to += sizeof last - 1;
    return wgsl_make(v->defines, shader, NULL, to, capacity - (size_t)(to - out));
}

#endif
