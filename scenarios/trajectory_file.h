/* SPDX-License-Identifier: MIT */
/* The two data files of the interface: increments of an IMU, and a trajectory. */
#ifndef SCHULER_SCENARIOS_TRAJECTORY_FILE_H
#define SCHULER_SCENARIOS_TRAJECTORY_FILE_H

#include "core/earth.h"
#include "core/vec.h"
#include "mechanization/mechanization.h"
#include "scenarios/csv.h"

SCHULER_BEGIN_C

/* Column names; they are part of the interface and never change. */
#define SCHULER_IMU_HEADER                                                                         \
    "time_s,dtheta_x_rad,dtheta_y_rad,dtheta_z_rad,dv_x_mps,dv_y_mps,dv_z_mps"
#define SCHULER_TRAJECTORY_HEADER                                                                  \
    "time_s,lat_deg,lon_deg,height_m,vn_mps,ve_mps,vd_mps,roll_deg,pitch_deg,heading_deg"

/* Instantaneous values instead of increments, of body axes: rates, 'schuler truth --rates'. */
#define SCHULER_RATES_HEADER                                                                       \
    "time_s,omega_x_radps,omega_y_radps,omega_z_radps,f_x_mps2,f_y_mps2,f_z_mps2"

enum { SCHULER_TRAJECTORY_COLUMNS = 10, SCHULER_IMU_COLUMNS = 7 };

/* One row of a trajectory file. */
typedef struct {
    double t_s;
    schuler_llh llh;
    schuler_vec3 v_n; /* over ground, north-east-down at that place, m/s */
    double roll_rad, pitch_rad, heading_rad;
} schuler_trajectory_row;

/** The row as vectors and a quaternion. */
SCHULER_API schuler_nav_state schuler_trajectory_state(const schuler_trajectory_row *row);

enum { SCHULER_TRAJECTORY_LINE_MAX = 10 * 32, SCHULER_IMU_LINE_MAX = 7 * 32 };

/** The row's numbers in the order and units of its columns. */
SCHULER_API void schuler_trajectory_values(const schuler_trajectory_row *row,
                                           double values[SCHULER_TRAJECTORY_COLUMNS]);

/** Write numbers as a line, 17 significant digits.
 *  Returned   text     room for 32 characters a number; as below */
SCHULER_API size_t schuler_values_line(char *text, const double *values, int count);

/** Write a row as a line of its file, 17 significant digits, with its newline, without a NUL.
 *  Returned   text     room for ..._LINE_MAX characters; the function returns how many were written
 */
SCHULER_API size_t schuler_trajectory_line(char *text, const schuler_trajectory_row *row);
SCHULER_API size_t schuler_imu_line(char *text, double t_s, const double dtheta_ib_b[3],
                                    const double dv_ib_b[3]);

/** The next row of a trajectory file, as schuler_csv_next; also refuses what is out of range. */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_trajectory_next(schuler_csv *csv,
                                                                     schuler_trajectory_row *row,
                                                                     int *got_row,
                                                                     schuler_error *err);

SCHULER_END_C

#endif
