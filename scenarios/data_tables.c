/* SPDX-License-Identifier: MIT */
#include "scenarios/data_tables.h"

static const schuler_column imu[] = {
    { "time_s", "s", "end of the interval" },
    { "dtheta_x_rad", "rad", "integral of the inertial angular rate over the interval, body x" },
    { "dtheta_y_rad", "rad", "integral of the inertial angular rate over the interval, body y" },
    { "dtheta_z_rad", "rad", "integral of the inertial angular rate over the interval, body z" },
    { "dv_x_mps", "m s-1", "integral of the specific force over the interval, body x" },
    { "dv_y_mps", "m s-1", "integral of the specific force over the interval, body y" },
    { "dv_z_mps", "m s-1", "integral of the specific force over the interval, body z" },
};

static const schuler_column rates[] = {
    { "time_s", "s", "time" },
    { "omega_x_radps", "rad s-1", "inertial angular rate at that time, body x" },
    { "omega_y_radps", "rad s-1", "inertial angular rate at that time, body y" },
    { "omega_z_radps", "rad s-1", "inertial angular rate at that time, body z" },
    { "f_x_mps2", "m s-2", "specific force at that time, body x" },
    { "f_y_mps2", "m s-2", "specific force at that time, body y" },
    { "f_z_mps2", "m s-2", "specific force at that time, body z" },
};

static const schuler_column trajectory[] = {
    { "time_s", "s", "time" },
    { "lat_deg", "degrees_north", "geodetic latitude, WGS84" },
    { "lon_deg", "degrees_east", "longitude, WGS84" },
    { "height_m", "m", "height above the WGS84 ellipsoid" },
    { "vn_mps", "m s-1", "velocity over ground, north" },
    { "ve_mps", "m s-1", "velocity over ground, east" },
    { "vd_mps", "m s-1", "velocity over ground, down" },
    { "roll_deg", "degree", "roll of the body from north-east-down, turned last of z-y-x" },
    { "pitch_deg", "degree", "pitch of the body from north-east-down, turned second of z-y-x" },
    { "heading_deg", "degree", "heading of the body from north, turned first of z-y-x" },
};

#define TABLE(name, title)                                                                         \
    {                                                                                              \
        title, (int)(sizeof(name) / sizeof((name)[0])), name                                       \
    }

const schuler_table schuler_imu_table =
    TABLE(imu, "Increments of a strapdown IMU, body axes forward-right-down");
const schuler_table schuler_rates_table = TABLE(
    rates, "Angular rate and specific force of a strapdown IMU, body axes forward-right-down");
const schuler_table schuler_trajectory_table =
    TABLE(trajectory, "Trajectory: position, velocity and attitude");
