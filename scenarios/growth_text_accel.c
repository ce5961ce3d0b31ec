/* SPDX-License-Identifier: MIT */
/* How errors of accelerometers carry the position. */
#include "scenarios/growth_text_tables.h"

const schuler_growth_text growth_text_accel[GROWTH_TEXTS] = {
    [SCHULER_ACTS_CONSTANT] = { .process = "a constant of the run",
                                .first = "b t^2/2",
                                .later = "(b/w^2) (1 - cos w t): bounded. The growing position "
                                         "error tilts the computed "
                                         "vertical until gravity balances the bias, so that the "
                                         "error swings about b R/g "
                                         "(637 m for 100 ug) and back to zero every 84.4 min, peak "
                                         "twice that. An offset, no "
                                         "drift.",
                                .depends = "Only the level part acts, the vertical one moves "
                                           "nothing sideways. The swing "
                                           "turns with W sin(L) (Foucault). The bias turns with "
                                           "the vehicle: each turn "
                                           "excites a new swing. A navigator that has levelled "
                                           "itself by the same sensors "
                                           "starts with a tilt of b/g that cancels the bias until "
                                           "the heading changes; after "
                                           "half a turn it counts twice." },
    [SCHULER_ACTS_SCALE] = { .process = "in proportion to the specific force along its own axis; "
                                        "at rest a level axis "
                                        "feels none",
                             .first = "k dV t after a change dV of the velocity along the axis: a "
                                      "velocity error of k dV",
                             .later =
                                 "(k dV/w) sin w (t - t0): bounded, at most 806 s times k dV. "
                                 "Speeding up and "
                                 "slowing down again cancel when the one soon follows the other.",
                             .depends = "On changes of velocity, not on distance; not on latitude. "
                                        "The vertical axis "
                                        "joins in when the vehicle banks or pitches: in a turn the "
                                        "horizontal error is k "
                                        "times the acceleration to the centre, g tan(bank). An "
                                        "axis that leans by an "
                                        "angle a from the horizontal has k g sin(a) as a bias." },
    [SCHULER_ACTS_CROSS] = { .process = "in proportion to the specific force along another axis "
                                        "(or to an angular "
                                        "motion): gravity is always there",
                             .first = "M g t^2/2 where a level axis leans toward the vertical; M "
                                      "dV t after a change of "
                                      "velocity across the axis",
                             .later = "(M g/w^2) (1 - cos w t), bounded as a bias of M g (10 "
                                      "arcsec: 48 ug), and "
                                      "(M dV/w) sin w (t - t0) for each change of velocity.",
                             .depends = "On attitude: the part from gravity turns with the vehicle "
                                        "as a bias does, and "
                                        "self-alignment cancels it at constant heading. Between "
                                        "level axes only changes "
                                        "of velocity count. Not on latitude." },
    [SCHULER_ACTS_NON_LINEAR] = { .process = "with powers and products of the specific force (or "
                                             "of the angular rate): even "
                                             "ones do not average out, so that vibration and long "
                                             "acceleration become a bias",
                                  .first = "m t^2/2 while the motion lasts, m the mean of the "
                                           "term, such as K2 times the mean "
                                           "square of the specific force",
                                  .later =
                                      "(m/w^2) (1 - cos w t), bounded as a bias of m that comes "
                                      "and goes with the motion; "
                                      "odd terms act as a scale factor that grows with the input.",
                                  .depends = "On vibration, turns and accelerations along the axes "
                                             "of the term; at rest only "
                                             "where gravity is on them. Not on latitude." },
    [SCHULER_ACTS_WHITE] = { .process = "white noise: the velocity walks",
                             .first = "N t^1.5/sqrt(3), one sigma of each level axis",
                             .later = "(N/w) sqrt(t/2 - sin(2 w t)/(4 w)), about (N/w) sqrt(t/2): "
                                      "walks with the root of "
                                      "time. 0.02 m/s/sqrt(h) make 11 m in an hour.",
                             .depends = "Neither on motion nor on heading nor on latitude." },
    [SCHULER_ACTS_WANDERING] = { .process =
                                     "a bias that wanders within limits, of standard deviation s "
                                     "and correlated over a "
                                     "time T (flicker: over all times of its bank, s about 2 B)",
                                 .first = "s t^2/2 while t < T",
                                 .later = "slow (T of hours) as a bias of s, within 2 s/w^2; fast "
                                          "(T of minutes) as white noise "
                                          "of N = s sqrt(2 T), with the root of time; in between "
                                          "it keeps the Schuler swing "
                                          "going.",
                                 .depends = "On T against 84 min. Turning the vehicle turns the "
                                            "slow part. Not on latitude." },
    [SCHULER_ACTS_WALK] = { .process = "a bias that wanders without limit, K sqrt(t) after t",
                            .first = "K t^2.5/sqrt(20), one sigma of each level axis",
                            .later = "(K/w^2) sqrt(3t/2 - 2 sin(w t)/w + sin(2 w t)/(4 w)), about "
                                     "1.22 (K/w^2) sqrt(t): "
                                     "walks with the root of time.",
                            .depends =
                                "Not on motion as long as the heading is kept; not on latitude." },
    [SCHULER_ACTS_RAMP] = { .process = "a bias that grows with the time since the start, r t",
                            .first = "r t^3/6",
                            .later = "(r/w^2) (t - sin(w t)/w): follows the bias, so drifts at "
                                     "r/w^2 on the average.",
                            .depends = "On the heading, which turns it. Not on latitude." },
    [SCHULER_ACTS_PERIODIC] = { .process = "a sinusoid of amplitude A and frequency f, its phase "
                                           "drawn for each run",
                                .first = "up to A t^2/2 while f t is small, then A t/(2 pi f): the "
                                         "velocity is left off by up "
                                         "to A/(2 pi f)",
                                .later = "fast: A/(2 pi f w) sin w t, bounded as an error of "
                                         "velocity; slow (period of many "
                                         "hours): follows A/w^2; at the Schuler frequency, 0.197 "
                                         "mHz, it resonates: A t/(2 w).",
                                .depends =
                                    "On f against 0.197 mHz. Turning the vehicle shifts it to f "
                                    "plus and minus the rate "
                                    "of turn: what turns with the heading can become constant." },
    [SCHULER_ACTS_TRANSIENT] = { .process = "dies away after switch-on (time constant tau), or "
                                            "follows the temperature",
                                 .first = "b t^2/2 while t < tau",
                                 .later = "(b tau/w) sin w t once it has died away, if tau is "
                                          "short against 84 min: the velocity "
                                          "error b tau that it left behind. A slow one is followed "
                                          "as a bias, b/w^2.",
                                 .depends = "On the temperature's course and on the time from "
                                            "switch-on to alignment; on the "
                                            "heading, which turns it. Not on latitude." },
    [SCHULER_ACTS_COUNTS] = { .process = "whole counts q, the rest carried: no velocity is lost, "
                                         "only late",
                              .first = "at most q t: the velocity is off by less than a count",
                              .later = "about (q/(sqrt(12) w)) sin w t, from the rest at the "
                                       "start: bounded; and a noise "
                                       "q sqrt(dt t/12) on top, dt the interval of the samples, "
                                       "that is far below.",
                              .depends = "On nothing when the input is busy; with a constant input "
                                         "the rest goes round and "
                                         "round instead of being random." },
    [SCHULER_ACTS_RESPONSE] = { .process = "what the instrument does not follow: lag, delay, "
                                           "limits, steps, a dead band",
                                .first = "d dV for a lag or delay d and a change dV of the "
                                         "velocity; what saturation clips or "
                                         "a dead band swallows is lost, as a velocity error dV",
                                .later = "a lag is made up when the motion ends; in turns and in "
                                         "vibration it pairs late "
                                         "velocity with attitude in time, a bias of d times the "
                                         "rate of turn times the "
                                         "specific force. A lost dV swings as (dV/w) sin w t.",
                                .depends = "On quick motion: vibration, sculling, the ends of "
                                           "turns, peaks beyond the range. "
                                           "None at rest, except what a dead band or coarse steps "
                                           "make of small inputs." },
};
