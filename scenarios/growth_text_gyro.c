/* SPDX-License-Identifier: MIT */
/* How errors of gyros carry the position. */
#include "scenarios/growth_text_tables.h"

const schuler_growth_text growth_text_gyro[GROWTH_TEXTS] = {
    [SCHULER_ACTS_CONSTANT] = { .process = "a constant of the run",
                                .first = "g b t^3/6 from a level axis, g W cos(L) b t^4/24 from "
                                         "the vertical one",
                                .later = "level: R b (t - sin(w t)/w), which drifts at R b on the "
                                         "average, 0.6 nmi/h for each "
                                         "0.01 deg/h, while the velocity swings between 0 and 2 R "
                                         "b. Vertical: R W cos(L) b "
                                         "(t^2/2 - (1 - cos w t)/w^2) by way of the heading. Over "
                                         "many hours the earth's rate "
                                         "turns the drift: the error along the meridian stays "
                                         "within 2 R b/W (24 h mode), "
                                         "the longitude drifts on.",
                                .depends = "On the heading: kept, it adds up; turning the vehicle "
                                           "or indexing the sensors "
                                           "averages it. The vertical axis: on cos(L), none at the "
                                           "poles, and on motion: at a "
                                           "speed v it adds b v t^2/2 across the track." },
    [SCHULER_ACTS_SCALE] = { .process = "in proportion to the rate about its own axis: turns of "
                                        "the vehicle, and the earth's "
                                        "rate always",
                             .first = "a turn by da leaves an angle k da: heading when about the "
                                      "vertical, tilt when about "
                                      "a level axis. At rest a drift of k W cos(L) about north and "
                                      "k W sin(L) about the "
                                      "vertical",
                             .later = "from a turn: as initial.heading or initial.tilt of k da (10 "
                                      "ppm leave 13 arcsec of each "
                                      "full circle). At rest: R k W cos(L) t, 0.009 nmi/h for 10 "
                                      "ppm at the equator.",
                             .depends = "On the angle turned in all: there and back again cancels, "
                                        "circles the same way "
                                        "add up. Roll and pitch come back by themselves. At rest "
                                        "on cos(L) and heading." },
    [SCHULER_ACTS_CROSS] = { .process = "in proportion to the rate about another axis, or to the "
                                        "specific force where it is "
                                        "g-sensitive (or to an angular acceleration)",
                             .first =
                                 "a turn by da about the vertical tilts by M times 2 sin(da/2); at "
                                 "rest a drift of M "
                                 "times the earth's rate, or of G g: then g b t^3/6 with that b",
                             .later = "the tilt swings, R M 2 sin(da/2) (1 - cos w t), and is gone "
                                      "after a whole circle. A "
                                      "constant part drifts as gyro.bias: R M W t, R G g t.",
                             .depends = "On turns, the heading at their ends, and attitude; "
                                        "g-sensitive terms feel gravity "
                                        "always, and acceleration and banked turns. At rest on "
                                        "latitude through the "
                                        "earth's rate." },
    [SCHULER_ACTS_NON_LINEAR] = { .process = "with powers and products of the rate or of the "
                                             "specific force: even ones do not "
                                             "average out, so that vibration and long turns become "
                                             "a drift",
                                  .first = "g m t^3/6 while the motion lasts, m the mean of the "
                                           "term; m t of angle",
                                  .later =
                                      "R m t: drifts as a gyro bias of m that comes and goes with "
                                      "the motion; what a turn "
                                      "leaves is an angle, as initial.heading or initial.tilt.",
                                  .depends = "On rates of turn and on vibration along the axes of "
                                             "the term; at rest only where "
                                             "gravity is on them. On latitude as gyro.bias." },
    [SCHULER_ACTS_WHITE] = { .process = "white noise: the angle walks",
                             .first = "g N t^2.5/sqrt(20) from a level axis, g W cos(L) N "
                                      "t^3.5/sqrt(252) from the vertical "
                                      "one, one sigma",
                             .later = "level: R N sqrt(3t/2 - 2 sin(w t)/w + sin(2 w t)/(4 w)), "
                                      "about 1.22 R N sqrt(t): walks "
                                      "with the root of time. Vertical: about R W cos(L) N "
                                      "sqrt(t^3/3). 0.003 deg/sqrt(h) "
                                      "make 0.25 nmi of each axis in an hour.",
                             .depends = "Neither on heading nor on turns; the vertical axis on "
                                        "cos(L), and on motion: at a "
                                        "speed v it adds N v sqrt(t^3/3) across the track." },
    [SCHULER_ACTS_WANDERING] = { .process =
                                     "a drift that wanders within limits, of standard deviation s "
                                     "and correlated over a "
                                     "time T (flicker: over all times of its bank, s about 2 B)",
                                 .first = "g s t^3/6 from a level axis while t < T",
                                 .later = "slow (T of hours) as a gyro bias of s, R s t; fast as "
                                          "white noise of N = s sqrt(2 T), "
                                          "about 1.22 R N sqrt(t): with the root of time.",
                                 .depends = "On T against the mission; the slow part on heading "
                                            "and latitude as gyro.bias." },
    [SCHULER_ACTS_WALK] = { .process = "a drift that wanders without limit, K sqrt(t) after t",
                            .first = "g K t^3.5/sqrt(252) from a level axis, g W cos(L) K t^4.5/72 "
                                     "from the vertical one, "
                                     "one sigma",
                            .later = "level: about R K sqrt(t^3/3); vertical: about R W cos(L) K "
                                     "sqrt(t^5/20). Grows faster "
                                     "than time.",
                            .depends = "On the heading, as far as it is kept; the vertical axis on "
                                       "cos(L)." },
    [SCHULER_ACTS_RAMP] = { .process = "a drift that grows with the time since the start, r t",
                            .first = "g r t^4/24 from a level axis, g W cos(L) r t^5/120 from the "
                                     "vertical one",
                            .later = "level: R r (t^2/2 - (1 - cos w t)/w^2); vertical: about R W "
                                     "cos(L) r t^3/6. Grows "
                                     "with the square of time and more.",
                            .depends =
                                "On the heading, which turns it; the vertical axis on cos(L)." },
    [SCHULER_ACTS_PERIODIC] = { .process = "a sinusoid of amplitude A and frequency f, its phase "
                                           "drawn for each run",
                                .first = "up to g A t^3/6 while f t is small, then g A t^2/(4 pi "
                                         "f): a tilt of up to A/(2 pi f) "
                                         "is left",
                                .later = "fast: (R A/(2 pi f)) (1 - cos w t), bounded as a tilt; "
                                         "slow: drifts as a gyro bias "
                                         "until it turns round; at the Schuler frequency, 0.197 "
                                         "mHz, it resonates: R A t/2.",
                                .depends =
                                    "On f against 0.197 mHz. Turning the vehicle shifts it to f "
                                    "plus and minus the rate "
                                    "of turn: what turns with the heading can become constant." },
    [SCHULER_ACTS_TRANSIENT] = { .process = "dies away after switch-on (time constant tau), or "
                                            "follows the temperature",
                                 .first = "g b t^3/6 from a level axis while t < tau",
                                 .later = "R b tau (1 - cos w t) once it has died away, if tau is "
                                          "short against 84 min: the tilt "
                                          "b tau that it left behind, or that error of heading. A "
                                          "slow one drifts as a gyro bias.",
                                 .depends =
                                     "On the temperature's course and on the time from switch-on "
                                     "to alignment; on the "
                                     "heading, which turns it; the vertical axis on cos(L)." },
    [SCHULER_ACTS_COUNTS] = { .process =
                                  "whole counts q, the rest carried: no angle is lost, only late",
                              .first = "at most g q t^2/2: the angle is off by less than a count",
                              .later = "about (R q/sqrt(12)) (1 - cos w t), from the rest at the "
                                       "start: bounded, 9 m for each "
                                       "arcsec; and as a velocity random walk of g q sqrt(dt/12), "
                                       "dt the interval of the "
                                       "samples.",
                              .depends = "On nothing when the input is busy; with a constant input "
                                         "the rest goes round and "
                                         "round instead of being random." },
    [SCHULER_ACTS_RESPONSE] = { .process = "what the instrument does not follow: lag, delay, "
                                           "limits, steps, a dead band",
                                .first = "while the vehicle turns at a rate r the attitude is "
                                         "behind by d r for a lag or delay "
                                         "d; what saturation clips or a dead band swallows is "
                                         "lost, as an angle",
                                .later = "a lag is made up when the turn ends; what the specific "
                                         "force did meanwhile, d r f t, "
                                         "stays as a velocity error and swings. A lost angle acts "
                                         "as initial.tilt or "
                                         "initial.heading.",
                                .depends = "On quick motion: turns, coning, peaks beyond the "
                                           "range. At rest a dead band or "
                                           "coarse steps can swallow the earth's rate: a drift of "
                                           "up to W." },
};
