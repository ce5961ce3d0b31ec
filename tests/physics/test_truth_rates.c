/* SPDX-License-Identifier: MIT */
/* What a perfect IMU senses at an instant: in closed form at rest, against the increments in motion. */
#include "core/geographic.h"
#include "core/truth.h"
#include "flights.h"

static schuler_path at_rest(schuler_llh place, double heading_rad)
{
    const schuler_static_spec spec = { .start = { .lat_rad = place.lat_rad,
                                                  .lon_rad = place.lon_rad,
                                                  .h_m = place.h_m,
                                                  .heading_rad = heading_rad },
                                       .for_s = 60.0 };
    return flight_build("static", &spec);
}

/* Body axes turned by the heading h alone: omega = (cos L cos h, -cos L sin h, -sin L) Omega, f = -g. The
 * place is rounded to 1e-9 m, gravity fitted to 1e-10 m/s^2. */
static void at_rest_it_is_earth_rate_and_gravity(void **state)
{
    (void)state;
    const double heading_rad = 0.5;
    const schuler_llh place = { 0.8, 0.1, 300.0 };
    schuler_path path = at_rest(place, heading_rad);
    schuler_truth *const truth = flight_truth(&path, 0.01, "wgs84", "wgs84");
    schuler_vec3 omega, f;
    schuler_truth_rates(truth, 12.3, &omega, &f);
    const double W = SCHULER_OMEGA_IE_RADPS;
    CHECK_NEAR(omega.v[0], W * cos(place.lat_rad) * cos(heading_rad), 1e-18);
    CHECK_NEAR(omega.v[1], -W * cos(place.lat_rad) * sin(heading_rad), 1e-18);
    CHECK_NEAR(omega.v[2], -W * sin(place.lat_rad), 1e-18);
    schuler_field_model *field = NULL;
    assert_int_equal(schuler_field_open(&field, "wgs84", NULL), SCHULER_OK);
    const schuler_vec3 g_e = schuler_field_gravity(field, schuler_ecef_from_llh(place));
    schuler_field_close(field);
    CHECK_NEAR(schuler_vec3_norm(f), schuler_vec3_norm(g_e), 1e-10);
    CHECK_NEAR(f.v[2], -schuler_vec3_norm(g_e), 1e-6); /* the deflection above the ellipsoid */
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* Increments are integrals of the rates: three Gauss-Legendre nodes are of sixth order, so 1e-13 rad and
 * 1e-12 m/s in a hundredth of a second. The real world's gravity is not the navigator's. */
static void increments_are_their_integrals(void **state)
{
    static const double node[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
    static const double weight[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    (void)state;
    const double dt_s = 0.01;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *const truth = flight_truth(&path, dt_s, "grs80", "wgs84");
    const int64_t steps = schuler_truth_steps(truth);
    for (int64_t first = 0; first + SCHULER_BLOCK < steps; first += steps / 53 + 1) {
        schuler_truth_block block;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &block);
        for (int k = 0; k < SCHULER_BLOCK; k += 5) {
            double dtheta[3] = { 0.0 }, dv[3] = { 0.0 };
            for (int j = 0; j < 3; j++) {
                schuler_vec3 omega, f;
                schuler_truth_rates(truth, ((double)(first + k) + node[j]) * dt_s, &omega, &f);
                for (int i = 0; i < 3; i++) {
                    dtheta[i] += weight[j] * dt_s * omega.v[i];
                    dv[i] += weight[j] * dt_s * f.v[i];
                }
            }
            for (int i = 0; i < 3; i++) {
                CHECK_NEAR(dtheta[i], block.dtheta_ib_b[i][k], 1e-13);
                CHECK_NEAR(dv[i], block.dv_ib_b[i][k], 1e-12);
            }
        }
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* At rest the difference of two worlds is that of their gravities. */
static void all_of_the_real_worlds_gravity_is_felt(void **state)
{
    (void)state;
    schuler_field_model *field = NULL;
    if (schuler_field_open(&field, "egm96", NULL) != SCHULER_OK) {
        print_message("egm96 is not installed: skipped\n");
        skip();
    }
    const schuler_llh place = { 0.8, 0.1, 300.0 };
    const schuler_vec3 g_e = schuler_field_gravity(field, schuler_ecef_from_llh(place));
    schuler_field_close(field);
    schuler_path path = at_rest(place, 0.5);
    schuler_truth *const truth = flight_truth(&path, 0.01, "egm96", "wgs84");
    schuler_vec3 omega, f;
    schuler_truth_rates(truth, 30.0, &omega, &f);
    CHECK_NEAR(schuler_vec3_norm(f), schuler_vec3_norm(g_e), 1e-9);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_rest_it_is_earth_rate_and_gravity),
        cmocka_unit_test(increments_are_their_integrals),
        cmocka_unit_test(all_of_the_real_worlds_gravity_is_felt),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
