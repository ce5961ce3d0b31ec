/* SPDX-License-Identifier: MIT */
/* How errors of the start, of gravity and of the navigator itself carry the position. */
#include "scenarios/growth_text_tables.h"

static const schuler_growth_other others[] = {
    { "initial.position",
      "where the navigator believes to start, less where it does",
      "r = r0",
      "{normal: 10 m}",
      { .process = "a constant of the run",
        .first = "r0",
        .later =
            "r0: it stays. The navigator is level where it is, and only the earth's rate of the "
            "wrong latitude moves it, slowly. The drift does not count it.",
        .depends =
            "Hardly on anything; in height it makes gravity wrong by 0.3 mg for each kilometre, "
            "which a free vertical channel amplifies." } },
    { "initial.velocity",
      "velocity that the navigator believes to start with, less the true one",
      "v = v0",
      "{normal: 0.1 m/s}",
      { .process = "a constant of the run",
        .first = "v0 t",
        .later = "(v0/w) sin w t: bounded, at most 806 s times v0.",
        .depends = "The swing turns with W sin(L) (Foucault). Not on motion." } },
    { "initial.tilt",
      "error of levelling: angles about north and east",
      "computed C_b_n = (I - [phi x]) C_b_n",
      "{normal: 10 arcsec}",
      { .process = "a constant of the run",
        .first = "g phi t^2/2",
        .later =
            "R phi (1 - cos w t): bounded, a swing about R phi (309 m for 10 arcsec), peak twice "
            "that; as the accelerometer bias g phi. The earth's rate turns it into an error of "
            "heading and back in 24 h.",
        .depends =
            "Cancels an accelerometer bias of -g phi: after self-alignment the two are one and "
            "must not be counted as independent. Slowly on latitude." } },
    { "initial.heading",
      "heading that the navigator believes to start with, less the true one",
      "computed minus true",
      "{normal: 1 arcmin}",
      { .process = "a constant of the run",
        .first = "g W cos(L) psi t^3/6 at rest; in motion psi times the distance, across the track",
        .later =
            "R W cos(L) psi (t - sin(w t)/w): the axis that is taken for east sees a part of the "
            "earth's rate, W cos(L) psi, which passes for a turn: a drift, as of a gyro bias. 1 "
            "mrad at 45 deg is "
            "0.0106 deg/h, 0.64 nmi/h.",
        .depends =
            "On cos(L), none at the poles. On motion: psi times the distance made good across "
            "the track, and a velocity error psi dV across each change of velocity." } },
    { "gravity.disturbance",
      "the real world's gravity (truth.gravity) less that of navigation.gravity",
      "real gravity - navigator's gravity, along the true path",
      NULL,
      { .process = "a function of the place: deflection of the vertical xi, and disturbance of "
                   "gravity",
        .first = "g xi t^2/2: an arcsecond acts as an accelerometer bias of 4.8 ug",
        .later =
            "at rest R xi (1 - cos w t), bounded (31 m for each arcsec, peak twice that). In "
            "motion "
            "it changes with the place, over a distance d: a noise of about N = g xi sqrt(2 d/v) "
            "at a speed v, with the root of time.",
        .depends =
            "On the route and the speed, most where the field turns at the pace of the Schuler "
            "swing; on no sensor. A full model on both sides removes it." } },
    { "numerical",
      "what the navigator gets wrong with perfect sensors and a perfect start",
      NULL,
      NULL,
      { .process = "rounding, and truncation of its algorithms",
        .first = "nearly nothing at rest",
        .later =
            "bounded by the Schuler swing where it is an error of velocity; a drift where coning "
            "or quick turns are not followed.",
        .depends = "On motion and vibration against navigation.coning, samples_per_update and the "
                   "rate of the samples." } },
    { "baro.bias",
      "what the barometer reads, less the height (navigation.vertical: baro)",
      "reading = h + b",
      "{normal: 30 m}",
      { .process = "a constant of the run",
        .first = "height: 3 b t/T, T the loop's time constant (navigation.baro_time)",
        .later =
            "height: b. Level: at a speed v a velocity error of b v/R, which swings: b v/(R w) at "
            "most, 3 m for 100 m at 250 m/s.",
        .depends =
            "Level, on the speed; at rest there is Coriolis of the settling alone, a swing of "
            "2 W cos(L) b/w: 4 m for 50 m at 45 deg." } },
    { "baro.scale_factor",
      "relative error of the height over that of the start",
      "reading = h + s (h - h_start)",
      "{normal: 1 %}",
      { .process = "proportional to the climb since the start: a column of air that is warmer or "
                   "colder than the standard one, about 1 % for 3 K",
        .first = "height: follows s (h - h_start) within the loop's time constant",
        .later = "height: s (h - h_start). Level: as baro.bias.",
        .depends = "On the heights flown; nothing in level flight at the height of the start." } },
    { "baro.lag",
      "time constant with which the reading follows the height",
      "d(reading)/dt = (h - reading)/T",
      "1 s",
      { .process = "first order, settled at the start; of the true height alone",
        .first = "height: nothing until a climb begins",
        .later = "height: minus T times the rate of climb, within the loop's time constant; gone "
                 "again in level flight.",
        .depends = "On the rate of climb." } },
    { "baro.noise",
      "white noise of the reading, root of its two-sided density",
      "reading = h + N w",
      "1 m/sqrt(Hz)",
      { .process = "white noise",
        .first = "height: 3 N sqrt(t)/T",
        .later = "height: sqrt(33/16) N/sqrt(T) rms with T the loop's time constant: 0.14 m for 1 "
                 "m/sqrt(Hz) and 100 s.",
        .depends = "On the loop alone." } },
    { "baro.gauss_markov",
      "the weather: pressure that wanders, its sigma in height",
      "dp/dt = -p/T + sigma sqrt(2/T) w",
      "20 m",
      { .process = "first-order Gauss-Markov, correlated over gauss_markov_time",
        .first = "height: as baro.bias, for it has a value at the start",
        .later = "height: follows it, as far as it is slower than the loop; sigma then. Level: as "
                 "baro.bias.",
        .depends = "On the loop: what is quicker than its time constant is averaged out." } },
    { 0 },
};

const schuler_growth_text *schuler_growth_text_of(schuler_instrument instrument, schuler_acts acts)
{
    if (acts == SCHULER_ACTS_NOT || acts > SCHULER_ACTS_RESPONSE) return NULL;
    return instrument == SCHULER_ACCEL ? &growth_text_accel[acts] : &growth_text_gyro[acts];
}

const schuler_growth_other *schuler_growth_others(void)
{
    return others;
}

const char *schuler_growth_source(void)
{
    return "K. R. Britting, Inertial Navigation Systems Analysis, 1971; D. H. Titterton, J. L. "
           "Weston, "
           "Strapdown Inertial Navigation Technology, 2nd ed., ch. 12";
}
