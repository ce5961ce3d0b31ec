/* SPDX-License-Identifier: MIT */
#include "sensors/spectrum.h"
#include "core/earth.h"
#include <kiss_fftr.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

int schuler_spectrum_segment(int64_t n)
{
    int segment = SCHULER_SEGMENT_MIN;
    if (n < segment) return 0;
    while (segment < 1 << 18 && 2 * segment <= n / 8) segment *= 2;
    return segment;
}

typedef struct {
    kiss_fftr_cfg fft;
    double *window;
    float *in;
    kiss_fft_cpx *out;
} workspace;

static void drop(workspace *w)
{
    kiss_fftr_free(w->fft);
    free(w->window);
    free(w->in);
    free(w->out);
}

static int prepare(workspace *w, int segment)
{
    const size_t n = (size_t)segment;
    w->fft = kiss_fftr_alloc(segment, 0, NULL, NULL);
    w->window = malloc(n * sizeof(*w->window));
    w->in = malloc(n * sizeof(*w->in));
    w->out = malloc((n / 2 + 1) * sizeof(*w->out));
    if (!w->fft || !w->window || !w->in || !w->out) return 0;
    for (int k = 0; k < segment; k++)
        w->window[k] = 0.5 - 0.5 * cos(2.0 * SCHULER_PI * k / segment);
    return 1;
}

/* Adds |X|^2 of one segment. It is divided by its largest value first, which single precision needs
 * for rates of 1e-8 rad/s whose squares are summed. */
static void add_segment(workspace *w, const double *y, int segment, double *power)
{
    double mean = 0.0, largest = 0.0;
    for (int k = 0; k < segment; k++) mean += y[k];
    mean /= segment;
    for (int k = 0; k < segment; k++) largest = fmax(largest, fabs(y[k] - mean));
    if (!(largest > 0.0)) return;
    for (int k = 0; k < segment; k++) w->in[k] = (float)(w->window[k] * ((y[k] - mean) / largest));
    kiss_fftr(w->fft, w->in, w->out);
    for (int k = 0; k <= segment / 2; k++) {
        const double re = (double)w->out[k].r * largest, im = (double)w->out[k].i * largest;
        power[k] += re * re + im * im;
    }
}

schuler_status schuler_spectrum_welch(const double *y, int64_t n, double dt_s, double scale,
                                      int segment, double *density, const volatile int *stop)
{
    if (segment < SCHULER_SEGMENT_MIN || segment > SCHULER_SEGMENT_MAX || segment % 2 ||
        segment > n)
        return SCHULER_ERR_INPUT;
    workspace w = { 0 };
    schuler_status status = SCHULER_OK;
    if (!prepare(&w, segment)) {
        drop(&w);
        return SCHULER_ERR_MEMORY;
    }
    const int bins = segment / 2 + 1;
    int64_t segments = 0;
    memset(density, 0, (size_t)bins * sizeof(*density));
    for (int64_t first = 0; first + segment <= n; first += segment / 2, segments++) {
        if (stop && *stop) {
            status = SCHULER_ERR_INTERRUPTED;
            break;
        }
        add_segment(&w, y + first, segment, density);
    }
    /* The sum of the squared Hann window is 3/8 of its length. */
    const double unit = scale * scale * dt_s / (0.375 * segment * (double)segments);
    for (int k = 0; k < bins && segments > 0; k++) density[k] *= unit;
    drop(&w);
    return status;
}

int schuler_spectrum_log_bins(const double *density, int bins, double step_hz, int per_decade,
                              schuler_spectrum_point *out, int max)
{
    int count = 0;
    for (int k = 1, past; k < bins && count < max; k = past) {
        const double next = ceil((double)k * pow(10.0, 1.0 / per_decade));
        past = next < bins ? (int)next : bins;
        if (past <= k) past = k + 1;
        double sum = 0.0;
        for (int i = k; i < past; i++) sum += density[i];
        out[count++] = (schuler_spectrum_point){ step_hz * 0.5 * (double)(k + past - 1),
                                                 sum / (past - k), past - k };
    }
    return count;
}
