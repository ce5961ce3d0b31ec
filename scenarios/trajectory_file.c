/* SPDX-License-Identifier: MIT */
/* Lines of the data files, written and read. */
#include "scenarios/trajectory_file.h"
#include "scenarios/digits.h"

schuler_nav_state schuler_trajectory_state(const schuler_trajectory_row *row)
{
    const schuler_mat3 C_n_e = schuler_C_n_e(row->llh.lat_rad, row->llh.lon_rad);
    const schuler_mat3 C_b_n =
        schuler_mat3_from_euler(row->roll_rad, row->pitch_rad, row->heading_rad);
    const schuler_mat3 C_b_e = schuler_mat3_mul(&C_n_e, &C_b_n);
    return (schuler_nav_state){ .r_e = schuler_ecef_from_llh(row->llh),
                                .v_e = schuler_mat3_apply(&C_n_e, row->v_n),
                                .q_b_e = schuler_quat_from_mat3(&C_b_e) };
}

size_t schuler_values_line(char *text, const double *values, int count)
{
    char *p = text;
    for (int i = 0; i < count; i++) {
        p += schuler_digits(p, values[i]);
        *p++ = i + 1 < count ? ',' : '\n';
    }
    return (size_t)(p - text);
}

void schuler_trajectory_values(const schuler_trajectory_row *row,
                               double values[SCHULER_TRAJECTORY_COLUMNS])
{
    values[0] = row->t_s;
    values[1] = row->llh.lat_rad / SCHULER_RAD_PER_DEG;
    values[2] = row->llh.lon_rad / SCHULER_RAD_PER_DEG;
    values[3] = row->llh.h_m;
    for (int i = 0; i < 3; i++) values[4 + i] = row->v_n.v[i];
    values[7] = row->roll_rad / SCHULER_RAD_PER_DEG;
    values[8] = row->pitch_rad / SCHULER_RAD_PER_DEG;
    values[9] = row->heading_rad / SCHULER_RAD_PER_DEG;
}

size_t schuler_trajectory_line(char *text, const schuler_trajectory_row *row)
{
    double values[SCHULER_TRAJECTORY_COLUMNS];
    schuler_trajectory_values(row, values);
    return schuler_values_line(text, values, SCHULER_TRAJECTORY_COLUMNS);
}

size_t schuler_imu_line(char *text, double t_s, const double dtheta_ib_b[3],
                        const double dv_ib_b[3])
{
    const double values[SCHULER_IMU_COLUMNS] = {
        t_s, dtheta_ib_b[0], dtheta_ib_b[1], dtheta_ib_b[2], dv_ib_b[0], dv_ib_b[1], dv_ib_b[2],
    };
    return schuler_values_line(text, values, SCHULER_IMU_COLUMNS);
}

/* What a column may hold. Heights are those where gravity is known. */
static const struct {
    const char *what, *unit;
    double min, max;
} limits[SCHULER_TRAJECTORY_COLUMNS] = {
    { "time", "s", -1e12, 1e12 },      { "latitude", "deg", -90.0, 90.0 },
    { "longitude", "deg", -360, 360 }, { "height", "m", -1000.0, 50000.0 },
    { "velocity", "m/s", -1e4, 1e4 },  { "velocity", "m/s", -1e4, 1e4 },
    { "velocity", "m/s", -1e4, 1e4 },  { "roll", "deg", -360.0, 360.0 },
    { "pitch", "deg", -90.0, 90.0 },   { "heading", "deg", -360.0, 360.0 },
};

schuler_status schuler_trajectory_next(schuler_csv *csv, schuler_trajectory_row *row, int *got_row,
                                       schuler_error *err)
{
    double x[SCHULER_TRAJECTORY_COLUMNS];
    const schuler_status status = schuler_csv_next(csv, x, got_row, err);
    if (status != SCHULER_OK || !*got_row) return status;
    for (int i = 0; i < SCHULER_TRAJECTORY_COLUMNS; i++)
        if (x[i] < limits[i].min || x[i] > limits[i].max)
            return schuler_csv_refuse(csv, i, err, "%s %g %s is outside %g .. %g %s",
                                      limits[i].what, x[i], limits[i].unit, limits[i].min,
                                      limits[i].max, limits[i].unit);
    *row = (schuler_trajectory_row){
        .t_s = x[0],
        .llh = { x[1] * SCHULER_RAD_PER_DEG, x[2] * SCHULER_RAD_PER_DEG, x[3] },
        .v_n = { { x[4], x[5], x[6] } },
        .roll_rad = x[7] * SCHULER_RAD_PER_DEG,
        .pitch_rad = x[8] * SCHULER_RAD_PER_DEG,
        .heading_rad = x[9] * SCHULER_RAD_PER_DEG,
    };
    return SCHULER_OK;
}
