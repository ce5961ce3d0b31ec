/* SPDX-License-Identifier: MIT */
/* How fast this machine computes: the real chain on the mission of a scenario, every instruction
 * set in the same run, measurements interleaved so that a machine that slows down slows down all
 * alike. */
#ifndef SCHULER_SCENARIOS_BENCH_H
#define SCHULER_SCENARIOS_BENCH_H

#include "scenarios/simulation.h"

SCHULER_BEGIN_C

/* Sensors: `linear` without noise; with white noise of both triads (6 random numbers a step); with
 * Gauss-Markov and random walk of the bias as well (18); accelerometers `ieee1293` with all their
 * terms, flicker, random walk of the bias, quantization and a second-order bandwidth (6), gyros
 * `linear`; and the same with white noise on both triads, the gyros `spinning_mass` (18). */
enum { SCHULER_BENCH_KINDS = 5, SCHULER_BENCH_LANES = 256, SCHULER_BENCH_SECONDS = 40 };
static const char *const schuler_bench_names[SCHULER_BENCH_KINDS] = { "0 normals", "6 normals",
                                                                      "18 normals", "ieee1293",
                                                                      "heaviest" };

typedef struct {
    double min, median, max;
} schuler_spread;

typedef struct {
    int rounds;
    int has[SCHULER_ISA_COUNT];
    /* Processor time of one thread. Chain: truth, sensors, mechanization, gravity, comparison at
     * 1 Hz. */
    schuler_spread chain_ns[SCHULER_ISA_COUNT][SCHULER_BENCH_KINDS];    /* a lane-step         */
    schuler_spread over_scalar[SCHULER_ISA_COUNT][SCHULER_BENCH_KINDS]; /* ratio within a round */
    schuler_spread truth_ns[SCHULER_ISA_COUNT];                         /* a step              */
    schuler_spread two_threads; /* wall time of one thread over that of two, same work      */
} schuler_bench;

/** Measure on the trajectory of a scenario (its first SCHULER_BENCH_SECONDS for the chain, all of
 *  it for the truth), at its sample rate.
 *  Given    rounds    interleaved repetitions, 1..99
 *           stop      as in schuler_run_options, or NULL
 *  Errors   as schuler_simulate */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_bench_run(const schuler_scenario *scenario,
                                                               int rounds, const volatile int *stop,
                                                               schuler_bench *out,
                                                               schuler_error *err);

SCHULER_END_C

#endif
