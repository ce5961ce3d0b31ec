/* SPDX-License-Identifier: MIT */
/* Any bytes give a scenario or errors that have a message and a place within the file.
 * Deterministic, so that what fails once fails again. */
#include "scenario_text.h"

/* Numbers of a 64-bit xorshift (Marsaglia, J. Stat. Soft. 8(14), 2003: shifts 13, 7, 17). */
static uint64_t next(uint64_t *x)
{
    *x ^= *x << 13;
    *x ^= *x >> 7;
    *x ^= *x << 17;
    return *x;
}

static size_t below(uint64_t *x, size_t n)
{
    return (size_t)(next(x) % n);
}

static const char *const pieces[] = {
    "{",
    "}",
    "[",
    "]",
    ": ",
    "- ",
    "\n",
    "\t",
    "'",
    "\"",
    "&a ",
    "*a",
    "!!x ",
    "|\n",
    "? ",
    "#",
    "---\n",
    "%",
    "0",
    "-1",
    "1e999",
    "nan",
    "ug",
    "deg/h",
    "sqrt(",
    "^-9",
    "normal",
    "uniform",
    "value",
    "source",
    "\0",
    "\xff",
    "\u00b5",
    "\r",
    "99999999999999999999",
    "use",
    "kind",
    "imu",
    "{}",
    "[]",
    "linear",
    "\\x00",
    ",",
    "m/s",
    "~",
    "true",
    "noise_density",
    "sided",
};
enum { PIECES = sizeof pieces / sizeof pieces[0], ROOM = 4096 };

/* A few changes of one kind each: a byte, a cut, a repeat, a digit, a piece of syntax. */
static size_t mutate(char *text, size_t length, uint64_t *x)
{
    for (size_t changes = 1 + below(x, 3); changes > 0; changes--) {
        const size_t at = below(x, length), rest = (length - at) / 4;
        const size_t n = 1 + below(x, 1 + (next(x) % 8 != 0 && rest > 3 ? 3 : rest));
        const char *piece = pieces[below(x, PIECES)];
        const size_t size = *piece ? strlen(piece) : 1;
        switch (next(x) % 6) {
        case 0:
            text[at] = (char)next(x);
            break;
        case 1:
            if (length - n < 8) break;
            memmove(text + at, text + at + n, length - at - n);
            length -= n;
            break;
        case 2:
            if (length + n > ROOM) break;
            memmove(text + at + n, text + at, length - at);
            length += n;
            break;
        case 3:
        case 4: /* another digit, which mostly leaves a good file */
            for (size_t k = at; k < length; k++)
                if (text[k] >= '0' && text[k] <= '9') {
                    text[k] = (char)('0' + below(x, 10));
                    break;
                }
            break;
        default:
            if (length + size > ROOM) break;
            memmove(text + at + size, text + at, length - at);
            memcpy(text + at, piece, size);
            length += size;
        }
    }
    return length;
}

static void check_errors(const loaded *l)
{
    for (size_t i = 0; i < l->d.kept; i++) {
        const schuler_error *e = &l->d.items[i];
        assert_true(e->message[0] != '\0');
        assert_true(e->place.file != NULL);
        assert_true(e->place.line >= 0 && e->place.column >= 0 && e->place.width >= 0);
        assert_true(e->is_warning || e->status != SCHULER_OK);
        assert_true(strlen(e->excerpt) < SCHULER_EXCERPT_MAX);
    }
}

static void check_values(const schuler_scenario *s)
{
    assert_true(isfinite(s->path.duration_s) && s->path.duration_s > 0.0);
    assert_true(s->report_s > 0.0 && s->report_s <= s->path.duration_s);
    assert_true(s->imu.rate_hz >= 1.0 && s->imu.rate_hz <= 1e4);
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        assert_non_null(s->imu.triad[i].model);
        for (int k = 0; k < SCHULER_PARAMS_MAX; k++)
            for (int c = 0; c < SCHULER_VALUE_MAX; c++)
                assert_true(isfinite(s->imu.triad[i].values[k].a[c]) &&
                            isfinite(s->imu.triad[i].values[k].b[c]));
    }
}

static void mutate_often(const char *text, uint64_t seed, int rounds)
{
    loaded l;
    make_folder(&l);
    char *changed = malloc(ROOM);
    assert_non_null(changed);
    int good = 0, bad = 0;
    for (int i = 0; i < rounds; i++) {
        uint64_t x = seed + (uint64_t)i * UINT64_C(0x9e3779b97f4a7c15);
        memcpy(changed, text, strlen(text));
        const size_t length = i > 0 ? mutate(changed, strlen(text), &x) : strlen(text);
        write_file(l.dir, "s.yaml", changed, length);
        l.rc = schuler_scenario_load(&l.s, l.path, NULL, &l.d);
        assert_int_equal(l.rc == SCHULER_OK, l.s != NULL);
        assert_int_equal(l.rc == SCHULER_OK, l.d.errors == 0);
        check_errors(&l);
        if (l.s) check_values(l.s);
        good += l.s != NULL;
        bad += l.s == NULL;
        schuler_scenario_free(l.s);
        l.s = NULL;
        if (i == 0) assert_int_equal(bad, 0); /* the text itself is good */
        schuler_diagnostics_free(&l.d);
    }
    free(changed);
    /* The loop is worth something only when both outcomes occur. */
    assert_true(good > rounds / 20);
    assert_true(bad > rounds / 3);
    unload(&l);
}

static void a_scenario_survives_mutation(void **state)
{
    (void)state;
    mutate_often(
        "scenario: \"mutation\"  # a comment that may take a hit\nseed: 42\nruns: 10\n"
        "truth: {gravity: wgs84}\n" TRAJECTORY "imu:\n  use: hg9900\n  rate: 100 Hz\n"
        "  accel:\n    model: linear\n    bias: {normal: [25 ug, 30 ug, 35 ug]}\n"
        "    noise_density: 2 ug/sqrt(Hz)\n    sided: one\n  gyro:\n"
        "    bias: {uniform: [-0.003 deg/h, 0.003 deg/h]}\n    gauss_markov: 0.001 \u00b0/h\n"
        "    gauss_markov_time: 10 min\ninitial:\n  position: {normal: 10 m}\n"
        "  tilt: [1 arcsec, 2 arcsec]\nnavigation: {frame: ecef, coning: previous}\n"
        "errors:\n  without:\n    - gyro.bias\n    - initial\n"
        "requirement: {drift: 1 nmi/h, statistic: CEP}\nreport: {every: 1 min}\n",
        1, 4000);
}

static void manoeuvres_survive_mutation(void **state)
{
    (void)state;
    mutate_often(
        "scenario: x\nimu: {use: ln200}\ntrajectory:\n  kind: segments\n"
        "  start: {lat: 45 deg, lon: 7 deg, height: 100 m, heading: 45 deg, speed: 0 m/s}\n"
        "  segments:\n    - hold: {for: 10 s}\n    - accelerate: {to: 100 m/s, at: 2 m/s^2}\n"
        "    - climb: {to: 300 m, at: 10 m/s}\n    - turn: {by: 90 deg, bank: 25 deg}\n"
        "    - cruise: {for: 1 min}\n",
        2, 400);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scenario_survives_mutation),
        cmocka_unit_test(manoeuvres_survive_mutation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
