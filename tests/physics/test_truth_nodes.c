/* SPDX-License-Identifier: MIT */
/* Specific force and rate at instants: against the motion itself, and against the increments. */
#include "core/truth_nodes.h"
#include "flights.h"

static const char gravity_name[] = "wgs84";

/* f_ib_b = C_e_b (a_e + 2 omega_ie x v_e - g_e), omega_ib_b = omega_eb_b + C_e_b omega_ie_e. */
static void instant(const schuler_path *path, const schuler_gravity_table *gravity, double t_s,
                    double f[3], double omega[3])
{
    const schuler_motion m = schuler_path_at(path, t_s);
    const schuler_vec3 omega_ie = { { 0.0, 0.0, SCHULER_OMEGA_IE_RADPS } };
    const schuler_vec3 g_e = schuler_gravity_at(gravity, m.r_e);
    const schuler_mat3 C_b_e = schuler_mat3_from_quat(m.q_b_e);
    const schuler_vec3 turning = schuler_vec3_cross(omega_ie, m.v_e);
    const schuler_vec3 f_e =
        schuler_vec3_sub(schuler_vec3_add(m.a_e, schuler_vec3_scale(2.0, turning)), g_e);
    const schuler_vec3 f_b = schuler_mat3_apply_transposed(&C_b_e, f_e);
    const schuler_vec3 earth_b = schuler_mat3_apply_transposed(&C_b_e, omega_ie);
    for (int i = 0; i < 3; i++) {
        f[i] = f_b.v[i];
        omega[i] = m.omega_eb_b.v[i] + earth_b.v[i];
    }
}

static void nodes_are_the_motion_at_their_instants(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    static const double rates_hz[] = { 100.0, 400.0, 1.0 };
    for (size_t r = 0; r < 3; r++) {
        const double dt_s = 1.0 / rates_hz[r];
        schuler_truth *truth = flight_truth(&path, dt_s, gravity_name, gravity_name);
        const int64_t steps = schuler_truth_steps(truth);
        for (int64_t first = -8; first + SCHULER_BLOCK < steps; first += steps / 53 + 1) {
            schuler_truth_nodes q;
            schuler_truth_nodes_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &q);
            double weights = 0.0, f[3], omega[3];
            for (int j = 0; j < q.nodes; j++) {
                weights += q.weight[j];
                for (int k = 0; k < SCHULER_BLOCK; k += 5) {
                    const double t_s = ((double)(first + k) + q.fraction[j]) * dt_s;
                    instant(&path, schuler_truth_nav_gravity(truth), t_s, f, omega);
                    /* The time of a node is rounded to 1e-13 s of 1e3 s, jerk is up to 10 m/s^3; the
                     * rounding of metres in ECEF makes 1e-9 m/s^2 of gravity's 1e-6 per metre. */
                    for (int i = 0; i < 3; i++) {
                        CHECK_NEAR(q.f_ib_b[i][j][k], f[i], 1e-10);
                        CHECK_NEAR(q.omega_ib_b[i][j][k], omega[i], 1e-12);
                    }
                }
            }
            CHECK_NEAR(weights, 1.0, 1e-15);
            for (int k = 0; k <= SCHULER_BLOCK; k++) {
                instant(&path, schuler_truth_nav_gravity(truth), (double)(first + k) * dt_s, f,
                        omega);
                for (int i = 0; i < 3; i++) CHECK_NEAR(q.omega_end_b[i][k], omega[i], 1e-12);
            }
        }
        schuler_truth_free(truth);
    }
    schuler_path_free(&path);
}

/* Everywhere: what is summed in another order differs only where a sum crosses a power of two. */
static void nodes_are_the_same_bits_at_any_width(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    schuler_truth *truth = flight_truth(&path, 0.01, gravity_name, gravity_name);
    static schuler_truth_nodes one, other;
    for (int64_t first = 0; first + SCHULER_BLOCK < schuler_truth_steps(truth);
         first += SCHULER_BLOCK) {
        schuler_truth_nodes_compute(truth, SCHULER_ISA_SCALAR, first, SCHULER_BLOCK, &one);
        for (int isa = 0; isa < SCHULER_ISA_COUNT; isa++) {
            if (!schuler_isa_available((schuler_isa)isa)) continue;
            other = one;
            schuler_truth_nodes_compute(truth, (schuler_isa)isa, first, SCHULER_BLOCK, &other);
            assert_memory_equal(&one, &other, sizeof one);
        }
    }
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

/* The increments are made from the same nodes, but for steps that hold a joint: there the jerk
 * jumps by 3 m/s^3 at most, which three nodes see to 3 m/s^3 dt^2 / 10. */
static void increments_are_the_sum_over_the_nodes(void **state)
{
    (void)state;
    schuler_path path = flight_of_all_manoeuvres();
    const double dt_s = 0.01;
    schuler_truth *truth = flight_truth(&path, dt_s, gravity_name, gravity_name);
    int exact = 0, all = 0;
    for (int64_t first = 0; first + SCHULER_BLOCK < schuler_truth_steps(truth);
         first += SCHULER_BLOCK) {
        schuler_truth_block b;
        schuler_truth_nodes q;
        schuler_truth_block_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &b);
        schuler_truth_nodes_compute(truth, schuler_isa_best(), first, SCHULER_BLOCK, &q);
        for (int k = 0; k < SCHULER_BLOCK; k++)
            for (int i = 0; i < 3; i++, all++) {
                double f = 0.0, omega = 0.0;
                for (int j = 0; j < q.nodes; j++) {
                    f += q.weight[j] * q.f_ib_b[i][j][k];
                    omega += q.weight[j] * q.omega_ib_b[i][j][k];
                }
                const double off = fabs(f * dt_s - b.dv_ib_b[i][k]);
                CHECK_NEAR(f * dt_s, b.dv_ib_b[i][k], 3.0 * dt_s * dt_s / 10.0);
                CHECK_NEAR(omega * dt_s, b.dtheta_ib_b[i][k], 3.0 * dt_s * dt_s / 10.0);
                exact += off < 1e-15;
            }
    }
    assert_true(exact > all - all / 100);
    schuler_truth_free(truth);
    schuler_path_free(&path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_are_the_motion_at_their_instants),
        cmocka_unit_test(nodes_are_the_same_bits_at_any_width),
        cmocka_unit_test(increments_are_the_sum_over_the_nodes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
