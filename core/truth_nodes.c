/* SPDX-License-Identifier: MIT */
/* Instantaneous truth at the nodes of a quadrature in every step. */
#include "core/truth_nodes.h"
#include "core/truth_private.h"

/* Three-point Gauss-Legendre in each part of a step. */
static int parts_of(const schuler_truth *truth)
{
    enum { PARTS_MAX = SCHULER_NODES_MAX / SCHULER_NODES };
    const int wanted = truth->parts > truth->densest ? truth->parts : truth->densest;
    return wanted < PARTS_MAX ? wanted : PARTS_MAX;
}

static void place_nodes(int parts, schuler_truth_nodes *out)
{
    static const double node[SCHULER_NODES] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
    static const double weight[SCHULER_NODES] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };
    out->nodes = parts * SCHULER_NODES;
    for (int j = 0; j < out->nodes; j++) {
        out->fraction[j] = (j / SCHULER_NODES + node[j % SCHULER_NODES]) / parts;
        out->weight[j] = weight[j % SCHULER_NODES] / parts;
    }
}

/* One instant, wherever it lies. */
static void at_instant(const schuler_truth *truth, const schuler_truth_lanes *lanes, double t_s,
                       int at, schuler_columns *f, schuler_columns *omega)
{
    const schuler_piece *const piece = &truth->path->pieces[schuler_path_find(truth->path, t_s)];
    schuler_truth_run run;
    schuler_truth_prepare(truth, piece, &run);
    double s = (t_s - piece->t0_s) * 2.0 / piece->duration_s - 1.0;
    s = s < -SCHULER_PIECE_REACH  ? -SCHULER_PIECE_REACH
        : s > SCHULER_PIECE_REACH ? SCHULER_PIECE_REACH
                                  : s;
    run.s0 = s;
    run.ds = 0.0;
    lanes->points(&run, 0.0, 0.0, at, 1, f, omega);
}

/* Every step of a block at the same part of it. */
static void at_fraction(const schuler_truth *truth, const schuler_truth_lanes *lanes, int64_t first,
                        int n, double fraction, schuler_columns *f, schuler_columns *omega)
{
    size_t p = schuler_path_find(truth->path, (double)first * truth->dt_s);
    for (int i = 0; i < n;) {
        schuler_truth_run run;
        double index;
        const int whole = schuler_truth_next_run(truth, &p, first + i, n - i, &run, &index);
        if (whole > 0)
            lanes->points(&run, index, fraction, i, whole, f, omega);
        else
            at_instant(truth, lanes, ((double)(first + i) + fraction) * truth->dt_s, i, f, omega);
        i += whole > 0 ? whole : 1;
    }
}

void schuler_truth_nodes_compute(const schuler_truth *truth, schuler_isa isa, int64_t first, int n,
                                 schuler_truth_nodes *out)
{
    const schuler_truth_lanes *const lanes = schuler_truth_lanes_for(isa);
    schuler_columns f, omega;
    place_nodes(parts_of(truth), out);
    for (int j = 0; j < out->nodes; j++) {
        at_fraction(truth, lanes, first, n, out->fraction[j], &f, &omega);
        for (int a = 0; a < 3; a++)
            for (int i = 0; i < n; i++) {
                out->f_ib_b[a][j][i] = f.v[a][i];
                out->omega_ib_b[a][j][i] = omega.v[a][i];
            }
    }
    at_instant(truth, lanes, (double)first * truth->dt_s, 0, &f, &omega);
    for (int a = 0; a < 3; a++) out->omega_end_b[a][0] = omega.v[a][0];
    at_fraction(truth, lanes, first, n, 1.0, &f, &omega);
    for (int a = 0; a < 3; a++)
        for (int i = 0; i < n; i++) out->omega_end_b[a][i + 1] = omega.v[a][i];
}
