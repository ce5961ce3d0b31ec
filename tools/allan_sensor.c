/* SPDX-License-Identifier: MIT */
/* The sensor file that `schuler allan` writes: what was fitted, as keys of a part. */
#include "tools/allan_report.h"
#include "tools/messages.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

typedef struct {
    int count, column[SCHULER_RECORDING_COLUMNS_MAX];
} triad;

static triad triad_of(const allan_report *r, schuler_instrument instrument)
{
    triad t = { 0 };
    for (int i = 0; i < r->found->columns; i++)
        if (r->recording->column[i].instrument == instrument) t.column[t.count++] = i;
    return t;
}

/* A counter of resolution LSB has Q = LSB/sqrt(12); the key is the LSB. */
static double as_key(int term, double value)
{
    return term == SCHULER_ALLAN_QUANTIZATION ? value * sqrt(12.0) : value;
}

static void put_value(FILE *out, const allan_report *r, const triad *t, int term,
                      const allan_unit *unit)
{
    fputs(t->count > 1 ? "[" : "", out);
    for (int i = 0; i < t->count; i++) {
        const schuler_allan_coefficient *const c = &r->found->column[t->column[i]].fit.term[term];
        const double value = c->state == SCHULER_ALLAN_FITTED ? c->value / unit->si : 0.0;
        fprintf(out, "%s%.4g %s", i ? ", " : "", as_key(term, value), unit->unit);
    }
    fputs(t->count > 1 ? "]\n" : "\n", out);
}

static void put_term(FILE *out, const allan_report *r, const triad *t,
                     schuler_instrument instrument, int term)
{
    const allan_unit unit = allan_unit_of(instrument, (schuler_allan_term)term);
    int fitted = 0;
    for (int i = 0; i < t->count; i++)
        fitted += r->found->column[t->column[i]].fit.term[term].state == SCHULER_ALLAN_FITTED;
    if (!(r->terms >> term & 1)) return;
    fprintf(out, "  # %s%s, %s; %g %% limits:\n", unit.name,
            term == SCHULER_ALLAN_QUANTIZATION ? " (as one count)" : "", unit.unit,
            100.0 * r->level);
    for (int i = 0; i < t->count; i++) {
        const schuler_allan_coefficient *const c = &r->found->column[t->column[i]].fit.term[term];
        char reason[128];
        if (allan_reason(reason, sizeof reason, r, t->column[i], term))
            fprintf(out, "  #   %s: %s\n", r->recording->column[t->column[i]].name, reason);
        else
            fprintf(out, "  #   %s: %.4g to %.4g\n", r->recording->column[t->column[i]].name,
                    as_key(term, c->lower / unit.si), as_key(term, c->upper / unit.si));
    }
    if (!fitted) return;
    fprintf(out, "  %s: ", unit.key);
    put_value(out, r, t, term, &unit);
}

/* Names are single words without a meaning in YAML. */
static void put_name(FILE *out, const char *name)
{
    int count = 0;
    for (; *name && count < 60; name++, count++)
        fputc(isalnum((unsigned char)*name) && isascii((unsigned char)*name) ? *name : '-', out);
}

exit_code allan_put_sensor(FILE *out, const allan_report *r, const char *name)
{
    const double rate_hz = 1.0 / r->found->dt_s;
    char duration[32];
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const int count = triad_of(r, (schuler_instrument)i).count;
        if (count > 1 && count != 3)
            return say_bad_input("--out: one or three columns of %s are needed, not %d",
                                 i == SCHULER_GYRO ? "gyros" : "accelerometers", count);
    }
    allan_time(duration, sizeof duration, (double)r->found->n * r->found->dt_s);
    fprintf(out,
            "# Noise identified by schuler allan " SCHULER_VERSION ": %s at %.6g Hz.\nsensor: ",
            duration, rate_hz);
    put_name(out, name);
    fprintf(out, "\ntitle: identified from %s of data\n", duration);
    if (rate_hz >= 1.0 && rate_hz <= 1e4) fprintf(out, "rate: %.9g Hz\n", rate_hz);
    fputs(
        "notes: >-\n  Noise only. Bias, scale factor and misalignment cannot be seen in data of a "
        "sensor at rest\n  whose place and attitude are not known.\n",
        out);
    for (int i = 0; i < SCHULER_INSTRUMENTS; i++) {
        const schuler_instrument instrument = (schuler_instrument)i;
        const triad t = triad_of(r, instrument);
        fprintf(out, "%s:\n  model: linear\n", schuler_instrument_name(instrument));
        if (t.count == 0) fputs("  # no data\n", out);
        for (int term = 0; t.count > 0 && term < SCHULER_ALLAN_TERMS; term++)
            put_term(out, r, &t, instrument, term);
    }
    return EXIT_DONE;
}
