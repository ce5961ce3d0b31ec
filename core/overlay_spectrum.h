/* SPDX-License-Identifier: MIT */
/* A spectrum realised as a sum of sinusoids, so that every derivative stays exact: one line in each of
 * equal steps of log frequency, with the power of its band, somewhere in it, at a random phase. The lines
 * are not harmonics of one, so the motion does not repeat. Private to core. */
#ifndef SCHULER_CORE_OVERLAY_SPECTRUM_H
#define SCHULER_CORE_OVERLAY_SPECTRUM_H

#include <stddef.h>
#include <stdint.h>

typedef struct {
    double low_Hz, high_Hz;
    /* One-sided density at f, unit^2/Hz. */
    double (*density)(const void *user, double f_Hz);
    const void *user;
} overlay_spectrum;

/* Which of all realisations. */
typedef struct {
    uint64_t seed;
    size_t overlay; /* in the list */
    unsigned use;   /* several spectra of one overlay */
} overlay_luck;

typedef struct {
    long double frequency_Hz;
    double amplitude, phase_rad; /* amplitude cos(2 pi f t + phase) */
} overlay_sinusoid;

/** Line i of n. */
overlay_sinusoid schuler_spectrum_line(const overlay_spectrum *s, size_t i, size_t n,
                                       overlay_luck luck);

#endif
