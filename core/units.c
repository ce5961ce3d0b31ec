/* SPDX-License-Identifier: MIT */
#include "core/units.h"
#include "core/earth.h"
#include "core/units_private.h"
#include "core/utf8.h"
#include <math.h>
#include <string.h>
#include <strings.h>

typedef struct {
    const char *name;
    double si;
    schuler_dim dim;
} unit;

#define DEG SCHULER_RAD_PER_DEG
#define G0  SCHULER_G0_MPS2
#define NMI SCHULER_NMI_M

/* Prefixes only where the field uses them: a general rule would read "min" as milli-inch. The
 * degree and micro signs are turned to "deg" and "u" before the look-up. */
/* clang-format off */
static const unit units[] = {
    { "m", 1.0, SCHULER_DIM_LENGTH },      { "km", 1e3, SCHULER_DIM_LENGTH },
    { "cm", 1e-2, SCHULER_DIM_LENGTH },    { "mm", 1e-3, SCHULER_DIM_LENGTH },
    { "um", 1e-6, SCHULER_DIM_LENGTH },    { "nmi", NMI, SCHULER_DIM_LENGTH },
    { "NM", NMI, SCHULER_DIM_LENGTH },     { "mi", 1609.344, SCHULER_DIM_LENGTH },
    { "ft", 0.3048, SCHULER_DIM_LENGTH },  { "in", 0.0254, SCHULER_DIM_LENGTH },
    { "s", 1.0, SCHULER_DIM_TIME },        { "sec", 1.0, SCHULER_DIM_TIME },
    { "ms", 1e-3, SCHULER_DIM_TIME },      { "us", 1e-6, SCHULER_DIM_TIME },
    { "min", 60.0, SCHULER_DIM_TIME },     { "h", 3600.0, SCHULER_DIM_TIME },
    { "hr", 3600.0, SCHULER_DIM_TIME },    { "hour", 3600.0, SCHULER_DIM_TIME },
    { "day", 86400.0, SCHULER_DIM_TIME },  { "days", 86400.0, SCHULER_DIM_TIME },
    { "hours", 3600.0, SCHULER_DIM_TIME },
    { "Hz", 1.0, SCHULER_DIM_FREQUENCY },  { "kHz", 1e3, SCHULER_DIM_FREQUENCY },
    { "mHz", 1e-3, SCHULER_DIM_FREQUENCY },
    { "rad", 1.0, SCHULER_DIM_ANGLE },     { "mrad", 1e-3, SCHULER_DIM_ANGLE },
    { "urad", 1e-6, SCHULER_DIM_ANGLE },   { "nrad", 1e-9, SCHULER_DIM_ANGLE },
    { "deg", DEG, SCHULER_DIM_ANGLE },     { "mdeg", DEG * 1e-3, SCHULER_DIM_ANGLE },
    { "arcmin", DEG / 60.0, SCHULER_DIM_ANGLE },
    { "arcsec", DEG / 3600.0, SCHULER_DIM_ANGLE },
    { "mas", DEG / 3600e3, SCHULER_DIM_ANGLE },
    { "dps", DEG, SCHULER_DIM_RATE },      { "dph", DEG / 3600.0, SCHULER_DIM_RATE },
    { "g", G0, SCHULER_DIM_ACCEL },        { "mg", G0 * 1e-3, SCHULER_DIM_ACCEL },
    { "ug", G0 * 1e-6, SCHULER_DIM_ACCEL }, { "ng", G0 * 1e-9, SCHULER_DIM_ACCEL },
    { "Gal", 1e-2, SCHULER_DIM_ACCEL },    { "mGal", 1e-5, SCHULER_DIM_ACCEL },
    { "uGal", 1e-8, SCHULER_DIM_ACCEL },
    { "kt", NMI / 3600.0, SCHULER_DIM_SPEED }, { "kn", NMI / 3600.0, SCHULER_DIM_SPEED },
    { "kts", NMI / 3600.0, SCHULER_DIM_SPEED }, { "mph", 1609.344 / 3600.0, SCHULER_DIM_SPEED },
    { "%", 1e-2, SCHULER_DIM_NONE },       { "ppm", 1e-6, SCHULER_DIM_NONE },
    { "ppb", 1e-9, SCHULER_DIM_NONE },
    { "K", 1.0, SCHULER_DIM_TEMPERATURE },          { "mK", 1e-3, SCHULER_DIM_TEMPERATURE },
    { "degC", 1.0, SCHULER_DIM_TEMPERATURE }, /* as a difference */
    { "kg", 1.0, { 0, 0, 0, 0, 2, 0 } },   { "gram", 1e-3, { 0, 0, 0, 0, 2, 0 } },
    { "T", 1.0, { 0, 0, 0, 0, 0, 2 } },    { "mT", 1e-3, { 0, 0, 0, 0, 0, 2 } },
    { "uT", 1e-6, { 0, 0, 0, 0, 0, 2 } },  { "gauss", 1e-4, { 0, 0, 0, 0, 0, 2 } },
};
/* clang-format on */

enum { UNIT_COUNT = sizeof units / sizeof units[0], NAME_MAX_BYTES = 16, DEPTH_MAX = 16, DIMS = 6 };

typedef struct {
    double si;
    int exponent2[DIMS]; /* in the order of schuler_dim, doubled */
} term;

typedef struct {
    const char *text, *at;
    int depth;
    schuler_error *err;
} scanner;

static schuler_place place_of(const scanner *s, const char *from, const char *to)
{
    return (schuler_place){ NULL, 0, schuler_utf8_count(s->text, (size_t)(from - s->text)) + 1,
                            schuler_utf8_count(from, (size_t)(to - from)) };
}

/* what has one %.*s: the faulty part. */
static schuler_status refuse(const scanner *s, const char *from, const char *to, const char *what)
{
    const schuler_place place = place_of(s, from, to);
    const int n = to - from < 40 ? (int)(to - from) : 40;
    return schuler_fail(s->err, SCHULER_ERR_INPUT, &place, what, n, from);
}

static const unit *find(const char *name)
{
    for (size_t i = 0; i < UNIT_COUNT; i++)
        if (strcmp(units[i].name, name) == 0) return &units[i];
    return NULL;
}

static schuler_status unknown(const scanner *s, const char *from, const char *name)
{
    const char *names[UNIT_COUNT], *near = NULL;
    for (size_t i = 0; i < UNIT_COUNT; i++) {
        names[i] = units[i].name;
        if (!near && strcasecmp(name, names[i]) == 0) near = names[i];
    }
    /* Any two letters are near some unit: "kg" is not a slip for "km". */
    if (!near && strlen(name) > 2) near = schuler_nearest(name, names, UNIT_COUNT);
    if (!near) return refuse(s, from, s->at, "unknown unit '%.*s'");
    const schuler_place place = place_of(s, from, s->at);
    return schuler_fail(s->err, SCHULER_ERR_INPUT, &place,
                        "unknown unit '%.*s'; did you mean '%s'?", (int)(s->at - from), from, near);
}

/* Signs that stand for a letter or two. */
static size_t sign(const char *at, const char **ascii)
{
    static const char *const signs[][2] = {
        { "\u00b0", "deg" }, { "\u00b5", "u" }, { "\u03bc", "u" }, { "%", "%" }
    };
    for (size_t i = 0; i < sizeof signs / sizeof signs[0]; i++) {
        const size_t n = strlen(signs[i][0]);
        if (strncmp(at, signs[i][0], n) != 0) continue;
        *ascii = signs[i][1];
        return n;
    }
    return 0;
}

static int is_letter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/* Copy a name to ASCII; what does not fit is cut, which makes it unknown. */
static void scan_name(scanner *s, char name[NAME_MAX_BYTES])
{
    size_t length = 0;
    for (;;) {
        char letter[2] = { *s->at, '\0' };
        const char *ascii = letter;
        const size_t n = is_letter(*s->at) ? 1 : sign(s->at, &ascii);
        if (n == 0) break;
        for (; *ascii && length < NAME_MAX_BYTES - 1; ascii++) name[length++] = *ascii;
        s->at += n;
    }
    name[length] = '\0';
}

static void raise_term(term *t, int exponent2)
{
    const int n = exponent2 < 0 ? -exponent2 : exponent2;
    double power = n % 2 ? sqrt(t->si) : 1.0;
    for (int i = 0; i < n / 2; i++) power *= t->si;
    t->si = exponent2 < 0 ? 1.0 / power : power;
}

static schuler_status to_power(const scanner *s, term *t, int exponent2, const char *from)
{
    raise_term(t, exponent2);
    for (int i = 0; i < DIMS; i++) {
        const int e = t->exponent2[i] * exponent2;
        if (e % 2 != 0 || e > 64 || e < -64)
            return refuse(s, from, s->at, "'%.*s': only whole and half powers up to 16 are units");
        t->exponent2[i] = e / 2;
    }
    return SCHULER_OK;
}

static schuler_status scan_product(scanner *s, term *out);

static bool take(scanner *s, const char *token)
{
    const char *at = schuler_skip_space(s->at);
    const size_t n = strlen(token);
    if (strncmp(at, token, n) != 0) return false;
    s->at = at + n;
    return true;
}

static schuler_status scan_parenthesis(scanner *s, term *out, const char *from)
{
    if (++s->depth > DEPTH_MAX) return refuse(s, from, s->at, "'%.*s': too many parentheses");
    schuler_status rc = scan_product(s, out);
    s->depth--;
    if (rc == SCHULER_OK && !take(s, ")"))
        rc = refuse(s, from, s->at + strlen(s->at), "'%.*s': the parenthesis is not closed");
    return rc;
}

static void from_unit(term *out, const unit *u)
{
    const schuler_dim d = u->dim;
    *out = (term){ u->si, { d.length2, d.time2, d.angle2, d.temperature2, d.mass2, d.magnetic2 } };
}

/* A name, with the data sheets' "rtHz" and "rt(h)"; or sqrt(...). */
static schuler_status scan_name_term(scanner *s, term *out)
{
    const char *const from = s->at;
    char name[NAME_MAX_BYTES];
    scan_name(s, name);
    const unit *u = find(name);
    if (u) {
        from_unit(out, u);
        return SCHULER_OK;
    }
    const bool root = strncmp(name, "rt", 2) == 0;
    if ((strcmp(name, "sqrt") == 0 || strcmp(name, "rt") == 0) && take(s, "(")) {
        const schuler_status rc = scan_parenthesis(s, out, from);
        return rc == SCHULER_OK ? to_power(s, out, 1, from) : rc;
    }
    u = root ? find(name + 2) : NULL;
    if (!u) return unknown(s, from, name);
    from_unit(out, u);
    return to_power(s, out, 1, from);
}

static schuler_status scan_primary(scanner *s, term *out)
{
    const char *ascii, *const from = s->at = schuler_skip_space(s->at);
    if (take(s, "\u221a")) { /* the root sign */
        if (++s->depth > DEPTH_MAX) return refuse(s, from, s->at, "'%.*s': too many roots");
        const schuler_status rc = scan_primary(s, out);
        s->depth--;
        return rc == SCHULER_OK ? to_power(s, out, 1, from) : rc;
    }
    if (take(s, "(")) return scan_parenthesis(s, out, from);
    if (is_letter(*s->at) || sign(s->at, &ascii) > 0) return scan_name_term(s, out);
    if (s->at[0] == '1' && !(s->at[1] >= '0' && s->at[1] <= '9')) {
        s->at++;
        *out = (term){ 1.0, { 0 } };
        return SCHULER_OK;
    }
    const char *end = s->at + strlen(s->at);
    if (end == s->at) return refuse(s, s->text, end, "'%.*s': the unit is not complete");
    return refuse(s, s->at, end, "'%.*s' is not a unit");
}

/* What follows a factor: ^2 ^-1 ^0.5 ^(1/2), the raised figures, or a bare figure as in m/s2. */
static schuler_status scan_exponent(scanner *s, term *t, const char *from)
{
    if (take(s, "\u00b2")) return to_power(s, t, 4, from);
    if (take(s, "\u00b3")) return to_power(s, t, 6, from);
    if (*s->at >= '2' && *s->at <= '4') return to_power(s, t, 2 * (*s->at++ - '0'), from);
    if (!take(s, "^") && !take(s, "**")) return SCHULER_OK;
    const bool parenthesis = take(s, "(");
    double exponent;
    const char *end, *const at = schuler_skip_space(s->at);
    if (schuler_number_read(at, &exponent, &end, NULL) != SCHULER_OK) {
        s->at += strlen(s->at);
        return refuse(s, from, s->at, "'%.*s': a power such as ^2 or ^0.5 is expected");
    }
    s->at = end;
    if (parenthesis && take(s, "/2")) exponent *= 0.5;
    if ((parenthesis && !take(s, ")")) || fabs(exponent) > 8.0 ||
        floor(2.0 * exponent) != 2.0 * exponent)
        return refuse(s, from, s->at, "'%.*s': only whole and half powers up to 16 are units");
    return to_power(s, t, (int)(2.0 * exponent), from);
}

static schuler_status scan_product(scanner *s, term *out)
{
    *out = (term){ 1.0, { 0 } };
    const char *const start = s->at;
    for (int sense = 1;;) {
        const char *const from = s->at;
        term t;
        schuler_status rc = scan_primary(s, &t);
        if (rc == SCHULER_OK) rc = scan_exponent(s, &t, from);
        if (rc != SCHULER_OK) return rc;
        out->si = sense > 0 ? out->si * t.si : out->si / t.si;
        for (int i = 0; i < DIMS; i++) {
            out->exponent2[i] += sense * t.exponent2[i];
            if (out->exponent2[i] > 32 || out->exponent2[i] < -32)
                return refuse(s, start, s->at, "'%.*s': powers up to 16 only");
        }
        if (take(s, "/"))
            sense = -1;
        else if (take(s, "*") || take(s, "\u00b7"))
            sense = 1;
        else
            return SCHULER_OK;
    }
}

schuler_status schuler_unit_parse(const char *text, double *si, schuler_dim *dim,
                                  schuler_error *err)
{
    scanner s = { text, text, 0, err };
    const char *const from = schuler_skip_space(text);
    if (*from == '\0') return schuler_fail(err, SCHULER_ERR_INPUT, NULL, "unit missing");
    term t;
    const schuler_status rc = scan_product(&s, &t);
    if (rc != SCHULER_OK) return rc;
    const char *const rest = schuler_skip_space(s.at), *const end = rest + strlen(rest);
    if (rest != end) return refuse(&s, rest, end, "'%.*s' does not belong to the unit");
    if (!(t.si > 0.0 && isfinite(t.si))) return refuse(&s, from, end, "'%.*s' is out of range");
    *si = t.si;
    const int *const e = t.exponent2;
    *dim = (schuler_dim){ (signed char)e[0], (signed char)e[1], (signed char)e[2],
                          (signed char)e[3], (signed char)e[4], (signed char)e[5] };
    return SCHULER_OK;
}
