/* SPDX-License-Identifier: MIT */
/* One triad: a model and the stages after it, from the truth of a block to measured increments. */
#ifndef SCHULER_SENSORS_CHAIN_H
#define SCHULER_SENSORS_CHAIN_H

#include "core/truth_nodes.h"
#include "sensors/model.h"
#include "sensors/temperature.h"

SCHULER_BEGIN_C

/** All parameters of a triad: the model's, then every stage's. Index = index into the values of a
 *  schuler_lane_spec.
 *  Given      model   must have parameters for the instrument
 *  Returned   out     ended by key NULL;  how many
 *  Errors     -1: more than SCHULER_PARAMS_MAX (a plug-in with too many) */
SCHULER_API int schuler_chain_params(const schuler_sensor_model *model,
                                     schuler_instrument instrument,
                                     schuler_param out[SCHULER_PARAMS_MAX + 1]);

typedef struct {
    const schuler_sensor_model
        *model;     /* as compiled for isa, or a plug-in's for one lane         */
    bool is_plugin; /* it is for one lane: called for each by itself            */
    schuler_instrument instrument;
    schuler_isa isa;
    double dt_s;
    uint64_t seed;
    const schuler_lane_spec *settings;      /* parameters that are no sources; sources 0; copied */
    const bool *given;                      /* per parameter: some lane may have it non-zero, or
                                                 it is a setting that was given                    */
    const schuler_temperature *temperature; /* borrowed; NULL = always the reference temperature */
    double start_s;                         /* time of step 0 for the temperature                */
} schuler_chain_setup;

/* Owned by one thread: it holds what was observed of the present block. */
typedef struct schuler_chain schuler_chain;

/** Errors  SCHULER_ERR_MEMORY; SCHULER_ERR_NUMERIC for input axes that lie in a plane */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_chain_create(schuler_chain **out,
                                                                  const schuler_chain_setup *setup,
                                                                  schuler_error *err);
SCHULER_API void schuler_chain_free(schuler_chain *chain); /* NULL is fine */

/** Bytes of the state of one vector of lanes, a multiple of 64; to be aligned to 64. */
SCHULER_API size_t schuler_chain_state_size(const schuler_chain *chain);
/** Whether blocks need the nodes. */
SCHULER_API bool schuler_chain_needs_nodes(const schuler_chain *chain);

/** Start a vector of lanes; specs has as many as the instruction set has lanes; changed: the
 *  model's say on white noise is put in. */
SCHULER_API void schuler_chain_start(const schuler_chain *chain, void *state,
                                     schuler_lane_spec *specs);

/** Look at a block, once for all lanes.
 *  Given      nodes   may be NULL when they are not needed; both borrowed until the next call */
SCHULER_API void schuler_chain_observe(schuler_chain *chain, const schuler_truth_block *truth,
                                       const schuler_truth_nodes *nodes);

/** Measured increments of one vector of lanes for the block that was observed last.
 *  Returned   out   [axis][step][lane], axes SCHULER_BLOCK * lanes apart, aligned to 64 */
SCHULER_API void schuler_chain_apply(const schuler_chain *chain, void *state, double *out);

/** Samples of a lane, over all axes, that a stage has clipped so far (saturation). */
SCHULER_API double schuler_chain_events(const schuler_chain *chain, const void *state, int lane);

SCHULER_END_C

#endif
