/* SPDX-License-Identifier: MIT */
#include "core/units.h"
#include "core/units_private.h"
#include "core/utf8.h"
#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    schuler_dim dim;
    const char *name, *example;
} dim_name;

static const dim_name dim_names[] = {
    { SCHULER_DIM_NONE, "plain number", "100 ppm" },
    { SCHULER_DIM_LENGTH, "length", "100 m" },
    { SCHULER_DIM_TIME, "time", "10 s" },
    { SCHULER_DIM_FREQUENCY, "frequency", "100 Hz" },
    { SCHULER_DIM_ANGLE, "angle", "10 deg" },
    { SCHULER_DIM_RATE, "angular rate", "0.01 deg/h" },
    { SCHULER_DIM_ANGULAR_ACCEL, "angular acceleration", "1 deg/s^2" },
    { SCHULER_DIM_SPEED, "speed", "100 m/s" },
    { SCHULER_DIM_ACCEL, "acceleration", "50 ug" },
    { SCHULER_DIM_JERK, "jerk", "1 m/s^3" },
    { SCHULER_DIM_ARW, "angle random walk", "0.002 deg/sqrt(h)" },
    { SCHULER_DIM_VRW, "velocity random walk", "0.003 m/s/sqrt(h)" },
    { SCHULER_DIM_RRW, "rate random walk", "0.001 deg/h/sqrt(h)" },
    { SCHULER_DIM_ACCEL_RW, "acceleration random walk", "1 ug/sqrt(h)" },
    { SCHULER_DIM_TEMPERATURE, "temperature difference", "10 K" },
};

static const dim_name *find_dim(schuler_dim dim)
{
    for (size_t i = 0; i < sizeof dim_names / sizeof dim_names[0]; i++)
        if (schuler_dim_equal(dim_names[i].dim, dim)) return &dim_names[i];
    return NULL;
}

bool schuler_dim_equal(schuler_dim a, schuler_dim b)
{
    return a.length2 == b.length2 && a.time2 == b.time2 && a.angle2 == b.angle2 &&
           a.temperature2 == b.temperature2 && a.mass2 == b.mass2 && a.magnetic2 == b.magnetic2;
}

const char *schuler_dim_name(schuler_dim dim, const char **example)
{
    const dim_name *found = find_dim(dim);
    if (example) *example = found ? strchr(found->example, ' ') + 1 : "";
    return found ? found->name : "another quantity";
}

const char *schuler_skip_space(const char *text)
{
    return text + strspn(text, " \t");
}

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Bytes of the decimal number at the start of text, 0 when there is none. strtod alone would take
 * "inf", "nan" and hexadecimal too. */
static size_t number_extent(const char *text)
{
    const char *at = text + (*text == '+' || *text == '-');
    size_t digits = strspn(at, "0123456789");
    at += digits;
    if (*at == '.') {
        const size_t decimals = strspn(at + 1, "0123456789");
        digits += decimals;
        at += 1 + decimals;
    }
    if (digits == 0) return 0;
    if (*at == 'e' || *at == 'E') {
        const char *exponent = at + 1 + (at[1] == '+' || at[1] == '-');
        if (is_digit(*exponent)) at = exponent + strspn(exponent, "0123456789");
    }
    return (size_t)(at - text);
}

schuler_status schuler_number_read(const char *text, double *value, const char **end,
                                   schuler_error *err)
{
    const size_t length = number_extent(text);
    if (length == 0) {
        const schuler_place place = { NULL, 0, 1, schuler_utf8_count(text, strlen(text)) };
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "'%.40s' is not a number", text);
    }
    const schuler_place place = { NULL, 0, 1, (int)length };
    char copy[128];
    if (length >= sizeof copy)
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "the number has too many digits");
    memcpy(copy, text, length);
    copy[length] = '\0';
    locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (c == (locale_t)0) return schuler_fail(err, SCHULER_ERR_MEMORY, &place, "out of memory");
    errno = 0;
    const double number = strtod_l(copy, NULL, c);
    const int range = errno == ERANGE;
    freelocale(c);
    if (range)
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "the number %s is out of range", copy);
    *value = number;
    *end = text + length;
    return SCHULER_OK;
}

/* "50 ug" for the number written and the unit that is usual here. */
static const char *proposal(char *out, size_t size, const char *number, size_t length,
                            const char *example)
{
    const char *unit = strchr(example, ' ');
    if (!unit || length + strlen(unit) >= size) return example;
    memcpy(out, number, length);
    memcpy(out + length, unit, strlen(unit) + 1);
    return out;
}

/* The number alone where a unit is needed, or text that is no number at all. */
static schuler_status not_a_number(const char *text, const char *example, schuler_error *err)
{
    const schuler_place place = { NULL, 0, 1, schuler_utf8_count(text, strlen(text)) };
    if (*text == '\0')
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "value missing; write for example '%s'",
                            example);
    if (strncmp(text, "\u00b1", 2) == 0)
        return schuler_fail(err, SCHULER_ERR_INPUT, &place,
                            "'%.40s': write {uniform: %s} for limits or {normal: %s} for 1 sigma",
                            text, example, example);
    return schuler_fail(err, SCHULER_ERR_INPUT, &place,
                        "'%.40s' is not a number with a unit, such as '%s'", text, example);
}

static schuler_status wrong_dimension(const char *unit, schuler_dim found, schuler_dim wanted,
                                      const char *example, const schuler_place *place,
                                      schuler_error *err)
{
    char is[80];
    const dim_name *const known = find_dim(found), *const name = find_dim(wanted);
    if (schuler_dim_equal(found, (schuler_dim)SCHULER_DIM_NONE))
        snprintf(is, sizeof is, "has no dimension");
    else if (known)
        snprintf(is, sizeof is, "is a unit of %s", known->name);
    else
        snprintf(is, sizeof is, "is of another dimension");
    return schuler_fail(err, SCHULER_ERR_INPUT, place,
                        "'%.40s' %s, but %s%s is expected (such as '%s')", unit, is,
                        schuler_dim_equal(wanted, (schuler_dim)SCHULER_DIM_NONE) ? "a " : "",
                        name ? name->name : "another", example);
}

schuler_status schuler_quantity_read(const char *text, schuler_dim dim, const char *example,
                                     schuler_quantity *out, schuler_error *err)
{
    const dim_name *const usual = find_dim(dim);
    if (!example || !strchr(example, ' ')) example = usual ? usual->example : "1";
    text = schuler_skip_space(text);
    if (number_extent(text) == 0) return not_a_number(text, example, err);
    double number;
    const char *end;
    schuler_status rc = schuler_number_read(text, &number, &end, err);
    if (rc != SCHULER_OK) return rc;
    char buffer[160];
    example = proposal(buffer, sizeof buffer, text, (size_t)(end - text), example);
    const char *const unit = schuler_skip_space(end);
    double unit_si = 1.0;
    schuler_dim found = SCHULER_DIM_NONE;
    schuler_place place = { NULL, 0, 1, (int)(end - text) };
    if (*unit == '\0' && !schuler_dim_equal(dim, (schuler_dim)SCHULER_DIM_NONE))
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "unit missing; write for example '%s'",
                            example);
    if (*unit == ',' && is_digit(unit[1]))
        return schuler_fail(err, SCHULER_ERR_INPUT, &place,
                            "write the decimal mark as a point, for example '1.5'");
    const int offset = (int)(unit - text);
    if (*unit != '\0') rc = schuler_unit_parse(unit, &unit_si, &found, err);
    if (rc != SCHULER_OK) {
        if (err) err->place.column += offset;
        return rc;
    }
    place = (schuler_place){ NULL, 0, offset + 1, schuler_utf8_count(unit, strlen(unit)) };
    if (!schuler_dim_equal(found, dim))
        return wrong_dimension(unit, found, dim, example, &place, err);
    const double si = number * unit_si;
    place = (schuler_place){ NULL, 0, 1, schuler_utf8_count(text, strlen(text)) };
    if (!isfinite(si) || (si == 0.0) != (number == 0.0))
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "'%.40s' is out of range", text);
    *out = (schuler_quantity){ si, unit_si, unit };
    return SCHULER_OK;
}

schuler_status schuler_quantity_parse(const char *text, schuler_dim dim, double *si,
                                      schuler_error *err)
{
    schuler_quantity quantity;
    const schuler_status rc = schuler_quantity_read(text, dim, NULL, &quantity, err);
    if (rc == SCHULER_OK)
        *si = quantity.si;
    else if (err)
        err->place.column += (int)(schuler_skip_space(text) - text);
    return rc;
}
