/* SPDX-License-Identifier: MIT */
/* Increments and reference of a vehicle at rest, in closed form, written to files and navigated. */
#ifndef SCHULER_TESTS_RECORDED_AT_REST_H
#define SCHULER_TESTS_RECORDED_AT_REST_H

#include "check.h"
#include "core/gravity.h"
#include "mechanization/mechanization.h"
#include "scenarios/navigate.h"
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static const double dt_s = 0.02;
static const schuler_llh place = { 45.0 * SCHULER_RAD_PER_DEG, 7.0 * SCHULER_RAD_PER_DEG, 300.0 };

typedef struct {
    char folder[64], imu[96], reference[96];
} files;

/* What is added to the true increments, as rates: rad/s and m/s^2, body = north-east-down here. */
typedef struct {
    double t0_s;
    int steps, every;    /* reference rows every so many steps */
    const char *gravity; /* of the world and of the navigator; NULL: wgs84 */
    double gyro[3], accel[3];
    int reverse; /* 1: accel changes sign half-way */
} recording;

static inline int make_folder(void **state)
{
    files *f = calloc(1, sizeof(*f));
    if (!f) return -1;
    snprintf(f->folder, sizeof(f->folder), "/tmp/test_navigate.XXXXXX");
    if (!mkdtemp(f->folder)) return -1;
    snprintf(f->imu, sizeof(f->imu), "%s/imu.csv", f->folder);
    snprintf(f->reference, sizeof(f->reference), "%s/reference.csv", f->folder);
    *state = f;
    return 0;
}

static inline int remove_folder(void **state)
{
    files *f = *state;
    unlink(f->imu);
    unlink(f->reference);
    rmdir(f->folder);
    free(f);
    return 0;
}

static inline void record(const files *f, const recording *r)
{
    const char *gravity = r->gravity ? r->gravity : "wgs84";
    /* Gravity by the navigator's own table, so that only what is added makes an error. */
    schuler_field_model *field = NULL;
    schuler_gravity_table table;
    assert_int_equal(schuler_field_open(&field, gravity, NULL), SCHULER_OK);
    assert_int_equal(schuler_gravity_fit(&table, field, NULL), SCHULER_OK);
    const schuler_mat3 C_n_e = schuler_C_n_e(place.lat_rad, place.lon_rad);
    const schuler_vec3 r_e = schuler_ecef_from_llh(place);
    const schuler_vec3 g_e = schuler_field_has_disturbance(field)
                                 ? schuler_field_gravity(field, r_e)
                                 : schuler_gravity_at(&table, r_e);
    const schuler_vec3 g_n = schuler_mat3_apply_transposed(&C_n_e, g_e);
    schuler_field_close(field);
    const double omega_n[3] = { SCHULER_OMEGA_IE_RADPS * cos(place.lat_rad), 0.0,
                                -SCHULER_OMEGA_IE_RADPS * sin(place.lat_rad) };
    FILE *imu = fopen(f->imu, "w"), *reference = fopen(f->reference, "w");
    assert_non_null(imu);
    assert_non_null(reference);
    fputs(SCHULER_IMU_HEADER "\n", imu);
    fputs(SCHULER_TRAJECTORY_HEADER "\n", reference);
    for (int k = 0; k <= r->steps; k++) {
        const double t_s = r->t0_s + k * dt_s;
        char line[SCHULER_TRAJECTORY_LINE_MAX];
        double dtheta[3], dv[3];
        for (int i = 0; i < 3; i++) {
            dtheta[i] = (omega_n[i] + r->gyro[i]) * dt_s;
            dv[i] =
                (-g_n.v[i] + (r->reverse && 2 * k > r->steps ? -r->accel[i] : r->accel[i])) * dt_s;
        }
        if (k > 0) fwrite(line, 1, schuler_imu_line(line, t_s, dtheta, dv), imu);
        const schuler_trajectory_row row = { .t_s = t_s, .llh = place };
        if (k % r->every == 0) fwrite(line, 1, schuler_trajectory_line(line, &row), reference);
    }
    fclose(imu);
    fclose(reference);
}

static inline schuler_status count_row(void *user, const schuler_trajectory_row *row)
{
    (void)row;
    ++*(int *)user;
    return SCHULER_OK;
}

static inline schuler_status navigate(const files *f, const char *gravity,
                                      schuler_vertical vertical, schuler_navigate_result *out,
                                      schuler_error *err)
{
    int rows = 0;
    const schuler_navigate_options options = {
        .imu_file = f->imu,
        .reference_file = f->reference,
        .frame = schuler_mechanization_find("ecef"),
        .gravity = gravity,
        .vertical = vertical,
        .row = count_row,
        .user = &rows,
    };
    const schuler_status status = schuler_navigate(&options, out, err);
    if (status == SCHULER_OK) assert_int_equal(rows, out->rows);
    return status;
}

#endif
