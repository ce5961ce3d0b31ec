/* SPDX-License-Identifier: MIT */
/* What is added to any trajectory: vibration, sway, sea, gusts, the place of the IMU in the vehicle,
 * its indexing. Each kind is one file in core/overlays/: a table of its keys and a function that adds
 * them up here. They move the truth itself, so coning, sculling and rectification arise as they do in
 * a vehicle.
 *
 * The vehicle of the trajectory has axes b0. Overlays displace it by d and turn it by Euler angles
 * (yaw, pitch, roll), both sums of sinusoids, to the axes v. The IMU sits at lever + u there, u being
 * vibration, and is turned to the axes b by two gimbals. Position and attitude of the path that results
 * are those of the IMU:
 *
 *     r = r0 + C_b0_e (d + C_v_b0 (lever + u))        C_b_e = C_b0_e C_v_b0 C_b_v
 *
 * Private to core. */
#ifndef SCHULER_CORE_OVERLAY_H
#define SCHULER_CORE_OVERLAY_H

#include "core/overlay_gimbal.h"
#include "core/overlays.h"
#include "core/vec.h"

/* d: forward, right, down of b0, m. Angles: roll, pitch, yaw, rad. u: forward, right, down of v, m. */
enum {
    OVERLAY_SURGE,
    OVERLAY_SWAY,
    OVERLAY_HEAVE,
    OVERLAY_ROLL,
    OVERLAY_PITCH,
    OVERLAY_YAW,
    OVERLAY_SHAKE_X,
    OVERLAY_SHAKE_Y,
    OVERLAY_SHAKE_Z,
    OVERLAY_CHANNELS
};

/* One sinusoid in all channels: in_phase cos(2 pi f t) + in_quadrature sin(2 pi f t). */
typedef struct {
    long double frequency_Hz;
    double in_phase[OVERLAY_CHANNELS], in_quadrature[OVERLAY_CHANNELS];
} overlay_line;

/* When it acts: fading in over ramp_s from from_s on and out again before to_s, whole ticks. A ramp of 0
 * at the very start or end of the mission acts at once. */
typedef struct {
    double from_s, to_s, ramp_s;
} overlay_window;

typedef struct {
    overlay_window window;
    overlay_line *lines; /* owned */
    size_t count;
} overlay_group;

typedef struct schuler_overlay {
    double duration_s; /* of the trajectory */
    size_t index;      /* of the overlay being added, in the list */
    overlay_group *groups;
    size_t count;
    schuler_vec3 lever_m;
    overlay_gimbal gimbals[2]; /* outer, inner */
    int has_gimbals;
} schuler_overlay;

struct schuler_overlay_kind {
    const schuler_object *object; /* its name is the key in `overlays` */
    const char *source;
    /** Add what the keys say.
     *  Errors  SCHULER_ERR_INPUT, SCHULER_ERR_MEMORY; in d */
    schuler_status (*add)(const void *spec, schuler_overlay *o, schuler_diagnostics *d);
};

/* The keys every oscillating overlay has. */
typedef struct {
    double from_s, for_s, ramp_s; /* for_s NAN: to the end */
} schuler_overlay_times;

/** A new group of zeroed lines for the window that keys give; NULL with a diagnostic when the window is
 *  not in the mission or does not hold its ramps, or out of memory. */
overlay_group *schuler_overlay_group(schuler_overlay *o, const schuler_overlay_times *times,
                                     size_t lines, const schuler_place *place,
                                     schuler_diagnostics *d);

/** How much of an overlay acts at t: 0..1, and its rate. */
void schuler_overlay_envelope(const overlay_window *w, double duration_s, long double t_s,
                              double *envelope, double *rate_ps);

#endif
