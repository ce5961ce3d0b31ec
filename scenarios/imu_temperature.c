/* SPDX-License-Identifier: MIT */
/* The key `temperature` of `imu`: a profile over the mission, or a warm-up. */
#include "scenarios/part.h"
#include <string.h>

typedef struct {
    schuler_place place;
    double at_s, is_K;
} profile_point;

typedef struct {
    schuler_place place;
    double from_K, to_K, time_s;
} warm_up;

typedef struct {
    schuler_place place;
    double reference_K;
    schuler_list profile;
    warm_up warm_up;
} section;

/* The last argument is the doc; further members may follow. */
#define QUANTITY(STRUCT, MEMBER, KEY, DIM_, EXAMPLE, ...)                                          \
    {                                                                                              \
        .key = KEY, .kind = SCHULER_FIELD_QUANTITY, .offset = offsetof(STRUCT, MEMBER),            \
        .dim = SCHULER_DIM_##DIM_, .example = EXAMPLE, .doc = __VA_ARGS__                          \
    }

static const schuler_field point_fields[] = {
    QUANTITY(profile_point, at_s, "at", TIME, "10 min", "time from the start of the mission",
             .required = true),
    QUANTITY(profile_point, is_K, "is", TEMPERATURE, "45 degC", "temperature then",
             .required = true),
    { .key = NULL },
};
static const schuler_object point_object = {
    .name = "profile",
    .doc = "one point; straight lines join them",
    .size = sizeof(profile_point),
    .fields = point_fields,
};

static const schuler_field warm_up_fields[] = {
    QUANTITY(warm_up, from_K, "from", TEMPERATURE, "20 degC", "temperature at the start"),
    QUANTITY(warm_up, to_K, "to", TEMPERATURE, "60 degC", "temperature in the end"),
    QUANTITY(warm_up, time_s, "time", TIME, "10 min", "time constant", .min = 1e-3, .max = 1e9),
    { .key = NULL },
};
static const schuler_object warm_up_object = {
    .name = "warm_up",
    .doc = "T = to - (to - from) exp(-t/time)",
    .size = sizeof(warm_up),
    .fields = warm_up_fields,
};

static const schuler_field fields[] = {
    QUANTITY(section, reference_K, "reference", TEMPERATURE, "25 degC",
             "temperature at which the coefficients of the sensors are measured", .required = true),
    { .key = "profile",
      .kind = SCHULER_FIELD_LIST,
      .offset = offsetof(section, profile),
      .object = &point_object,
      .doc = "temperature over the mission" },
    { .key = "warm_up",
      .kind = SCHULER_FIELD_OBJECT,
      .offset = offsetof(section, warm_up),
      .object = &warm_up_object,
      .doc = "instead of a profile" },
    { .key = NULL },
};
static const schuler_object object = {
    .name = "temperature",
    .doc = "temperature of the instruments; K and degC are one scale here: use one of them",
    .size = sizeof(section),
    .fields = fields,
};

static bool take_profile(schuler_reading *r, const schuler_list *list, schuler_temperature *out)
{
    const profile_point *const points = list->items;
    double *const at_s = schuler_reading_alloc(r, list->count * sizeof *at_s);
    double *const is_K = schuler_reading_alloc(r, list->count * sizeof *is_K);
    if (!at_s || !is_K) return false;
    for (size_t i = 0; i < list->count; i++) {
        if (i > 0 && !(points[i].at_s > points[i - 1].at_s)) {
            schuler_diagnose(
                r->d, SCHULER_ERR_INPUT, &points[i].place,
                "imu.temperature.profile: the times must increase from point to point");
            return false;
        }
        at_s[i] = points[i].at_s;
        is_K[i] = points[i].is_K;
    }
    out->count = list->count;
    out->at_s = at_s;
    out->is_K = is_K;
    return true;
}

bool schuler_temperature_read(schuler_reading *r, const schuler_node *node,
                              schuler_temperature *out)
{
    section s;
    if (schuler_schema_read(node, "imu.temperature", &object, &s, r->arena, r->d) != SCHULER_OK)
        return false;
    const bool has_warm_up = schuler_node_find(node, "warm_up") != NULL;
    *out = (schuler_temperature){ .reference_K = s.reference_K };
    if (has_warm_up == (s.profile.count > 0)) {
        schuler_diagnose(r->d, SCHULER_ERR_INPUT, schuler_node_place(node),
                         "'imu.temperature' needs either 'profile' or 'warm_up', for example: "
                         "profile: [{at: 0 s, is: 20 degC}, {at: 10 min, is: 45 degC}]");
        return false;
    }
    if (!has_warm_up) return take_profile(r, &s.profile, out);
    static const char *const needed[] = { "from", "to", "time" };
    for (int i = 0; i < 3; i++)
        if (!schuler_node_find(schuler_node_find(node, "warm_up"), needed[i])) {
            schuler_diagnose(r->d, SCHULER_ERR_INPUT, &s.warm_up.place,
                             "'imu.temperature.warm_up' needs the key '%s', for example: %s",
                             needed[i], warm_up_fields[i].example);
            return false;
        }
    out->start_K = s.warm_up.from_K;
    out->end_K = s.warm_up.to_K;
    out->time_s = s.warm_up.time_s;
    return true;
}
