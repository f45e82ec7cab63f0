/* A small JSON reader for the reference data of the tests. Trusted input: a malformed file ends the program.
   json *j = json_load("tests/data/x.json"); double v = json_number(json_get(j, "key")); json_free(j). */
#ifndef TEST_JSON_H
#define TEST_JSON_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct json {
    char kind; /* 'n' null, 'b' bool, 'd' number, 's' string, 'a' array, 'o' object */
    double number;
    char *text;         /* of a string */
    char *key;          /* of a member of an object */
    int count;          /* elements or members */
    struct json *child; /* [count] */
} json;

static void json__die(const char *what)
{
    fprintf(stderr, "json: %s\n", what);
    exit(2);
}

static const char *json__space(const char *p)
{
    while (*p == ' ' || *p == '\n' || *p == '\r' || *p == '\t') ++p;
    return p;
}

static const char *json__string(const char *p, char **out)
{
    size_t n = 0;
    char *s;
    const char *q = ++p;
    while (*q && *q != '"') q += (*q == '\\' && q[1]) ? 2 : 1;
    if (*q != '"') json__die("unterminated string");
    s = (char *)malloc((size_t)(q - p) + 1);
    if (s == NULL) json__die("out of memory");
    while (p < q) {
        char c = *p++;
        if (c == '\\') {
            c = *p++;
            if (c == 'n') c = '\n';
            else if (c == 't') c = '\t';
            else if (c == 'u') {
                c = '?';
                p += 4;
            }
        }
        s[n++] = c;
    }
    s[n] = 0;
    *out = s;
    return q + 1;
}

static const char *json__value(const char *p, json *v)
{
    memset(v, 0, sizeof *v);
    p = json__space(p);
    if (*p == '{' || *p == '[') {
        char close = *p == '{' ? '}' : ']';
        int room = 0;
        v->kind = *p == '{' ? 'o' : 'a';
        p = json__space(p + 1);
        while (*p != close) {
            char *key = NULL;
            if (v->count == room) {
                room = room ? 2 * room : 8;
                v->child = (json *)realloc(v->child, (size_t)room * sizeof(json));
                if (v->child == NULL) json__die("out of memory");
            }
            if (v->kind == 'o') {
                if (*p != '"') json__die("expected a key");
                p = json__space(json__string(p, &key));
                if (*p++ != ':') json__die("expected ':'");
            }
            p = json__space(json__value(p, &v->child[v->count]));
            v->child[v->count++].key = key;
            if (*p == ',') p = json__space(p + 1);
            else if (*p != close) json__die("expected ',' or the end");
        }
        return p + 1;
    }
    if (*p == '"') {
        v->kind = 's';
        return json__string(p, &v->text);
    }
    if (strncmp(p, "null", 4) == 0) {
        v->kind = 'n';
        return p + 4;
    }
    if (strncmp(p, "true", 4) == 0) {
        v->kind = 'b';
        v->number = 1;
        return p + 4;
    }
    if (strncmp(p, "false", 5) == 0) {
        v->kind = 'b';
        return p + 5;
    }
    {
        char *end;
        v->kind = 'd';
        v->number = strtod(p, &end); /* also NaN and Infinity */
        if (end == p) json__die("expected a value");
        return end;
    }
}

static void json__clear(json *v)
{
    int i;
    for (i = 0; i < v->count; ++i) json__clear(&v->child[i]);
    free(v->child);
    free(v->text);
    free(v->key);
}

static void json_free(json *v)
{
    if (v) json__clear(v);
    free(v);
}

/* Of a whole file; ends the program with a message if it is not there. */
static json *json_load(const char *path)
{
    FILE *f = fopen(path, "rb");
    long n;
    char *text;
    json *v;
    if (f == NULL) {
        fprintf(stderr, "json: cannot open %s (run from the repository's root)\n", path);
        exit(2);
    }
    fseek(f, 0, SEEK_END);
    n = ftell(f);
    rewind(f);
    text = (char *)malloc((size_t)n + 1);
    v = (json *)malloc(sizeof *v);
    if (text == NULL || v == NULL || fread(text, 1, (size_t)n, f) != (size_t)n) json__die("cannot read");
    fclose(f);
    text[n] = 0;
    json__value(text, v);
    free(text);
    return v;
}

/* Member of an object, or NULL. */
static json *json_find(const json *v, const char *key)
{
    int i;
    if (v && v->kind == 'o')
        for (i = 0; i < v->count; ++i)
            if (strcmp(v->child[i].key, key) == 0) return &v->child[i];
    return NULL;
}

/* Member that must be there. */
static json *json_get(const json *v, const char *key)
{
    json *member = json_find(v, key);
    if (member == NULL) {
        fprintf(stderr, "json: no member '%s'\n", key);
        exit(2);
    }
    return member;
}

static double json_number(const json *v)
{
    if (v == NULL || v->kind != 'd') json__die("expected a number");
    return v->number;
}

/* Numbers of an array, nested arrays flattened in order, into a new array (caller frees); their count in *count. */
static int json__flatten(const json *v, double *out)
{
    int i, n = 0;
    if (v->kind != 'a') {
        if (out) *out = v->number;
        return 1;
    }
    for (i = 0; i < v->count; ++i) n += json__flatten(&v->child[i], out ? out + n : NULL);
    return n;
}

static double *json_numbers(const json *v, int *count)
{
    int n = json__flatten(v, NULL);
    double *out = (double *)malloc((size_t)(n ? n : 1) * sizeof *out);
    if (out == NULL) json__die("out of memory");
    json__flatten(v, out);
    if (count) *count = n;
    return out;
}

/* Keeps -Wunused-function quiet where a test needs only a part. */
typedef struct json__use {
    void (*a)(json *);
    json *(*b)(const char *);
    json *(*c)(const json *, const char *);
    double (*d)(const json *);
    double *(*e)(const json *, int *);
} json__use;
static inline json__use json__all(void)
{
    json__use u;
    u.a = json_free;
    u.b = json_load;
    u.c = json_get;
    u.d = json_number;
    u.e = json_numbers;
    return u;
}
#endif
