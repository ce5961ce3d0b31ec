/* SPDX-License-Identifier: MIT */
/* How speed, height, heading and the rest change in time: smooth trapezoids and polynomials, all
 * closed forms. Private to core.
 *
 * The rate of a change rises along the smoothstep 10 x^3 - 15 x^4 + 6 x^5 (first and second
 * derivative zero at both ends), holds, and falls the same way. A change too small for the plateau
 * gets a lower plateau and keeps the ramps. Durations are whole ticks, so that sums of them are
 * exact in double and a joint of two pieces is the same instant for both; the rate takes up the
 * rounding, so that every change is reached exactly. */
#ifndef SCHULER_CORE_PROFILE_H
#define SCHULER_CORE_PROFILE_H

#include <stddef.h>

/* 2^-30 s: sums stay exact in double up to 97 days. */
#define SCHULER_TICKS_PER_S 1073741824.0
/* Largest slope of the smoothstep: the peak derivative of a ramp from 0 to R in T is 1.875 R/T. */
#define SCHULER_SMOOTHSTEP_SLOPE 1.875

/** Nearest whole number of ticks, s. */
double schuler_tick(double t_s);

/* A time in two parts: whole ticks, where something begins, and what has passed since. Their sum
 * would round at 1e-14 s after some days, which a sharp ramp at the end of a long change shows. */
typedef struct {
    double joint_s;
    long double after_s;
} schuler_instant;

typedef struct {
    double change;    /* in all                            */
    long double rate; /* of the plateau, per second, signed; in double the parts would not add up */
    double ramp_s, plateau_s;
} schuler_trapezoid;

/** The quickest trapezoid of a change whose rate stays within rate_limit (> 0), with ramps of
 * ramp_s. A zero change takes no time. */
schuler_trapezoid schuler_trapezoid_make(double change, double rate_limit, double ramp_s);
double schuler_trapezoid_duration(const schuler_trapezoid *z);
/** Change so far, and rate, at t after the start; constant outside. */
long double schuler_trapezoid_value(const schuler_trapezoid *z, schuler_instant t);
long double schuler_trapezoid_rate(const schuler_trapezoid *z, schuler_instant t);

enum { SCHULER_CURVE_POINTS = 16 };

/* A polynomial of time in Bernstein form. Its control points are the value at the start, what is
 * given, and the last of it; the first and the last count three times, so that the first two
 * derivatives are zero at both ends. The curve stays between the lowest and the highest of them. */
typedef struct {
    size_t count; /* of the points given; 0: no curve */
    double to[SCHULER_CURVE_POINTS];
    double duration_s;
} schuler_curve;

/* One quantity in a phase of the motion: its value at the start and one change. */
typedef struct {
    double from;
    double start_s; /* of the change, after the start of the phase */
    schuler_trapezoid trapezoid;
    schuler_curve curve; /* instead, over the whole phase */
} schuler_channel;

long double schuler_channel_value(const schuler_channel *c, schuler_instant t);
long double schuler_channel_rate(const schuler_channel *c, schuler_instant t);
/** Value after the change. */
double schuler_channel_end(const schuler_channel *c);

/* A stretch of motion. */
typedef struct {
    double duration_s;
    schuler_channel speed;      /* m/s: over ground at altitude, or along the flight path        */
    schuler_channel height;     /* ellipsoidal, m; not read when along_path                      */
    schuler_channel path_angle; /* of the flight path above the horizon, rad; when along_path    */
    schuler_channel heading;    /* of the horizontal velocity, rad; right = positive             */
    /* Of the body relative to the flight path (which banks in a turn): turned in this order, rad. */
    schuler_channel yaw, pitch, roll;
    int along_path; /* 1: speed and path_angle make the height; 0: speed and height the path angle */
    int banked;     /* 1: turns are coordinated; 0: flat                                         */
} schuler_phase;

enum { SCHULER_PHASE_CHANNELS = 7, SCHULER_PHASE_JOINTS = 2 + 4 * SCHULER_PHASE_CHANNELS };
/** The instants between which a phase is one analytic function: 0, ..., duration; ascending,
 *  distinct.
 *  Returned   joints_s;  the function's value is how many (2 or more) */
int schuler_phase_joints(const schuler_phase *phase, double joints_s[SCHULER_PHASE_JOINTS]);

#endif
