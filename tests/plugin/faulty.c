/* SPDX-License-Identifier: MIT */
/* A plug-in that is right as it stands. Macros of the compiler's command line, members that come later
 * and so win, make it wrong. */
#include "sensors/plugin.h"
#include "sensors/setup.h"

#pragma GCC diagnostic ignored "-Woverride-init"

#ifndef SOURCE /* members of the first parameter, the second one and of the model */
#define SOURCE .components = 3
#endif
#ifndef SETTING
#define SETTING .components = 1
#endif
#ifndef MEMBERS
#define MEMBERS .needs_view = 0
#endif
#ifndef MODELS
#define MODELS &MODEL_NAME(faulty)
#endif
#ifndef ROWS
#define ROWS 0
#endif

static const schuler_param params[ROWS + 4] = {
    [0 ... ROWS] = { .key = "mine",
                     .number = 1000,
                     .components = 3,
                     .min = -1,
                     .max = 1,
                     .acts = SCHULER_ACTS_CONSTANT,
                     .doc = "a source",
                     .example = "1",
                     .formula = "y = x",
                     SOURCE },
    [ROWS + 1] = { .key = "other",
                   .components = 1,
                   .min = 1,
                   .max = 2,
                   .def = 1,
                   .doc = "a setting",
                   .example = "1",
                   SETTING },
};

static int setup(void *state, const schuler_model_setup *s)
{
    *(int *)state = s->lanes;
    return 1;
}

static void apply(void *state, const schuler_model_block *b)
{
    (void)state;
    for (int i = 0; i < 3 * b->stride; i++) b->out[i] = b->own[i];
}

MODEL(faulty) = {
    .name = "faulty",
    .summary = "none",
    .source = "none",
    .params = { [SCHULER_ACCEL] = params },
    .state_size = 64,
    .setup = setup,
    .apply = apply,
    MEMBERS,
};

#ifdef SYMBOL
const int SYMBOL = 1;
#else
SCHULER_PLUGIN(MODELS);
#endif
