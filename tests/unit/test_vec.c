/* SPDX-License-Identifier: MIT */
#include "check.h"
#include "core/earth.h"
#include "core/vec.h"

/* Rounding of a handful of operations on numbers up to one. */
static const double eps = 1e-15;

static void check_vec(schuler_vec3 got, double x, double y, double z, double tolerance)
{
    CHECK_NEAR(got.v[0], x, tolerance);
    CHECK_NEAR(got.v[1], y, tolerance);
    CHECK_NEAR(got.v[2], z, tolerance);
}

/* Rotation vectors of every size and a few directions. */
static const schuler_vec3 directions[] = {
    { { 1.0, 0.0, 0.0 } },
    { { 0.0, -1.0, 0.0 } },
    { { 0.6, 0.0, -0.8 } },
    { { -0.48, 0.6, 0.64 } },
};
static const double sizes[] = { 1e-300, 1e-150, 1e-20, 1e-9, 1e-4, 2.1e-4, 0.3, 1.5, 3.0, 3.14159 };

static void rotation_vectors_survive_the_way_through_quaternions(void **state)
{
    (void)state;
    for (size_t d = 0; d < 4; d++)
        for (size_t s = 0; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
            const schuler_vec3 phi = schuler_vec3_scale(sizes[s], directions[d]);
            const schuler_vec3 back = schuler_quat_to_rotvec(schuler_quat_from_rotvec(phi));
            check_vec(back, phi.v[0], phi.v[1], phi.v[2], 4.0 * eps * sizes[s]);
        }
}

static void a_zero_rotation_vector_is_the_identity(void **state)
{
    (void)state;
    const schuler_quat q = schuler_quat_from_rotvec((schuler_vec3){ { 0.0, 0.0, 0.0 } });
    assert_true(q.w == 1.0 && q.x == 0.0 && q.y == 0.0 && q.z == 0.0);
    check_vec(schuler_quat_to_rotvec(q), 0.0, 0.0, 0.0, 0.0);
}

static void the_opposite_quaternion_is_the_same_rotation(void **state)
{
    (void)state;
    const schuler_quat q = schuler_quat_from_rotvec((schuler_vec3){ { 0.3, -0.2, 0.1 } });
    const schuler_quat minus = { -q.w, -q.x, -q.y, -q.z };
    check_vec(schuler_quat_to_rotvec(minus), 0.3, -0.2, 0.1, eps);
}

/* Rodrigues' formula, written out here. */
static schuler_vec3 rotate(schuler_vec3 phi, schuler_vec3 x)
{
    const double angle = schuler_vec3_norm(phi);
    const schuler_vec3 axis = schuler_vec3_scale(1.0 / angle, phi);
    const schuler_vec3 once = schuler_vec3_cross(axis, x), twice = schuler_vec3_cross(axis, once);
    return schuler_vec3_add(x, schuler_vec3_add(schuler_vec3_scale(sin(angle), once),
                                                schuler_vec3_scale(1.0 - cos(angle), twice)));
}

static void quaternion_and_matrix_rotate_alike(void **state)
{
    (void)state;
    const schuler_vec3 x = { { 0.2, -0.7, 0.5 } };
    for (size_t d = 0; d < 4; d++)
        for (size_t s = 4; s < sizeof(sizes) / sizeof(sizes[0]); s++) {
            const schuler_vec3 phi = schuler_vec3_scale(sizes[s], directions[d]);
            const schuler_mat3 C = schuler_mat3_from_quat(schuler_quat_from_rotvec(phi));
            const schuler_vec3 expected = rotate(phi, x);
            check_vec(schuler_mat3_apply(&C, x), expected.v[0], expected.v[1], expected.v[2],
                      4.0 * eps);
            check_vec(schuler_mat3_apply_transposed(&C, expected), x.v[0], x.v[1], x.v[2],
                      4.0 * eps);
            const schuler_vec3 back = schuler_quat_to_rotvec(schuler_quat_from_mat3(&C));
            /* The matrix gives a small angle to rounding of one, half a turn to its sign. */
            check_vec(back, phi.v[0], phi.v[1], phi.v[2], 8.0 * eps);
        }
}

static void a_matrix_gives_the_quaternion_with_w_not_negative(void **state)
{
    (void)state;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            schuler_vec3 phi = { { 0.1, 0.1, 0.1 } };
            phi.v[axis] = sign * 2.8; /* the largest component is not w */
            const schuler_mat3 C = schuler_mat3_from_quat(schuler_quat_from_rotvec(phi));
            assert_true(schuler_quat_from_mat3(&C).w > 0.0);
        }
}

static void quaternions_multiply_like_their_matrices(void **state)
{
    (void)state;
    const schuler_quat p = schuler_quat_from_rotvec((schuler_vec3){ { 0.4, 1.1, -0.3 } });
    const schuler_quat q = schuler_quat_from_rotvec((schuler_vec3){ { -0.9, 0.2, 0.5 } });
    const schuler_mat3 P = schuler_mat3_from_quat(p), Q = schuler_mat3_from_quat(q);
    const schuler_mat3 expected = schuler_mat3_mul(&P, &Q);
    const schuler_mat3 got = schuler_mat3_from_quat(schuler_quat_mul(p, q));
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) CHECK_NEAR(got.m[i][j], expected.m[i][j], 4.0 * eps);
}

static void euler_angles_have_the_signs_of_aviation(void **state)
{
    (void)state;
    const double quarter = 0.5 * SCHULER_PI;
    const schuler_vec3 forward = { { 1.0, 0.0, 0.0 } }, right = { { 0.0, 1.0, 0.0 } };
    const schuler_mat3 east = schuler_mat3_from_euler(0.0, 0.0, quarter);
    check_vec(schuler_mat3_apply(&east, forward), 0.0, 1.0, 0.0, eps);
    const schuler_mat3 nose_up = schuler_mat3_from_euler(0.0, quarter, 0.0);
    check_vec(schuler_mat3_apply(&nose_up, forward), 0.0, 0.0, -1.0, eps);
    const schuler_mat3 right_down = schuler_mat3_from_euler(quarter, 0.0, 0.0);
    check_vec(schuler_mat3_apply(&right_down, right), 0.0, 0.0, 1.0, eps);
}

static void euler_angles_come_back(void **state)
{
    (void)state;
    static const double rolls[] = { -3.1, -1.0, 0.0, 0.4, 3.1 };
    static const double pitches[] = { -1.57, -0.5, 0.0, 1.2, 1.5707 };
    static const double headings[] = { 0.0, 0.1, 3.0, 3.2, 6.28 };
    for (int r = 0; r < 5; r++)
        for (int p = 0; p < 5; p++)
            for (int h = 0; h < 5; h++) {
                const schuler_mat3 C = schuler_mat3_from_euler(rolls[r], pitches[p], headings[h]);
                double roll, pitch, heading;
                schuler_euler_from_mat3(&C, &roll, &pitch, &heading);
                /* Roll and heading are known to rounding over the cosine of pitch. */
                const double tolerance = 4.0 * eps / cos(pitches[p]);
                CHECK_NEAR(roll, rolls[r], tolerance);
                CHECK_NEAR(pitch, pitches[p], 4.0 * eps);
                CHECK_NEAR(heading, headings[h], tolerance);
            }
}

static void straight_up_and_down_give_heading_the_whole_rotation(void **state)
{
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2) {
        const schuler_mat3 C = schuler_mat3_from_euler(0.0, sign * 0.5 * SCHULER_PI, 1.0);
        double roll, pitch, heading;
        schuler_euler_from_mat3(&C, &roll, &pitch, &heading);
        assert_true(roll == 0.0);
        CHECK_NEAR(pitch, sign * 0.5 * SCHULER_PI, eps);
        CHECK_NEAR(heading, 1.0, 2.0 * eps);
    }
}

static void heading_stays_below_a_full_turn(void **state)
{
    (void)state;
    const schuler_mat3 C = schuler_mat3_from_euler(0.0, 0.0, -1e-17);
    double roll, pitch, heading;
    schuler_euler_from_mat3(&C, &roll, &pitch, &heading);
    assert_true(heading == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotation_vectors_survive_the_way_through_quaternions),
        cmocka_unit_test(a_zero_rotation_vector_is_the_identity),
        cmocka_unit_test(the_opposite_quaternion_is_the_same_rotation),
        cmocka_unit_test(quaternion_and_matrix_rotate_alike),
        cmocka_unit_test(a_matrix_gives_the_quaternion_with_w_not_negative),
        cmocka_unit_test(quaternions_multiply_like_their_matrices),
        cmocka_unit_test(euler_angles_have_the_signs_of_aviation),
        cmocka_unit_test(euler_angles_come_back),
        cmocka_unit_test(straight_up_and_down_give_heading_the_whole_rotation),
        cmocka_unit_test(heading_stays_below_a_full_turn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
