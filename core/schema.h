/* SPDX-License-Identifier: MIT */
/* One table per object: what keys it has, of which kind and dimension, which are needed, what they
 * mean. The reader, range checks, error messages and help are all made from these tables. */
#ifndef SCHULER_CORE_SCHEMA_H
#define SCHULER_CORE_SCHEMA_H

#include "core/document.h"
#include "core/units.h"
#include <stdbool.h>
#include <stdint.h>

SCHULER_BEGIN_C

typedef enum {
    SCHULER_FIELD_QUANTITY, /* double, SI; number with unit of dim                               */
    SCHULER_FIELD_QUANTITIES, /* schuler_quantity_list; one scalar counts as a list of one       */
    SCHULER_FIELD_NUMBER,  /* double without unit                                               */
    SCHULER_FIELD_INTEGER, /* int64_t                                                           */
    SCHULER_FIELD_TEXT,    /* const char *, borrowed from the document                          */
    SCHULER_FIELD_CHOICE,  /* const char *, one of choices (points into choices)                */
    SCHULER_FIELD_VALUE,  /* schuler_value of 1, 2, 3, 6 or 9 components: fixed or drawn          */
    SCHULER_FIELD_OBJECT, /* the object's struct in place                                      */
    SCHULER_FIELD_LIST,   /* schuler_list of object structs                                    */
    SCHULER_FIELD_VARIANTS, /* schuler_variant_list: items are single-key maps {name: {...}}     */
    SCHULER_FIELD_TEXTS,    /* schuler_text_list; one scalar counts as a list of one             */
    SCHULER_FIELD_NODE,     /* const schuler_node *, not read further here                       */
} schuler_field_kind;

typedef struct schuler_field schuler_field;

/* The struct of every object begins with a schuler_place, filled by the reader. */
typedef struct schuler_object {
    const char *name; /* for messages and help                                     */
    const char *doc;
    size_t size;                 /* of the struct                                             */
    const schuler_field *fields; /* ended by one with key NULL                                */
} schuler_object;

struct schuler_field {
    const char *key;
    schuler_field_kind kind;
    size_t offset; /* of the member in the object's struct                      */
    bool required;
    schuler_dim dim;     /* QUANTITY, QUANTITIES, VALUE                               */
    int components;      /* VALUE: how many, [V, ...] must have as many; QUANTITIES: at most */
    double def;          /* QUANTITY, NUMBER, INTEGER: when absent. NAN = "not given"  */
    double min, max;     /* inclusive, SI; both 0 = any                               */
    const char *example; /* as one would write it: "2 m/s^2"                          */
    const char *doc;     /* one line                                                  */
    const char *const
        *choices; /* CHOICE: NULL-terminated; the first is the default unless required */
    const schuler_object *object; /* OBJECT, LIST                                              */
    const schuler_object *const *variants; /* VARIANTS: NULL-terminated, name = the key         */
};

typedef struct {
    void *items; /* array of the object's struct */
    size_t count;
} schuler_list;

typedef struct {
    const schuler_object *which;
    void *spec; /* that object's struct */
} schuler_variant;

typedef struct {
    schuler_variant *items;
    size_t count;
} schuler_variant_list;

typedef struct {
    const char **items;
    schuler_place *places;
    size_t count;
} schuler_text_list;

typedef struct {
    double *items; /* SI */
    size_t count;
} schuler_quantity_list;

/* A physical value: V, [V, V, V], {normal: V}, {uniform: V} or {uniform: [V, V]}; in catalog files
 * also {value: V}, and with any map form `source: NAME`, `note: TEXT`, `qualifier: TEXT`,
 * `assumed: true`, and `per: unit` (or run). V may be a list in the map forms too (per component). */
typedef enum { SCHULER_DRAW_FIXED, SCHULER_DRAW_NORMAL, SCHULER_DRAW_UNIFORM } schuler_draw;

enum { SCHULER_VALUE_MAX = 9 };

typedef struct {
    bool given;
    schuler_draw draw;
    double a[SCHULER_VALUE_MAX]; /* fixed: the value; normal: sigma; uniform: lower end; SI      */
    double b[SCHULER_VALUE_MAX]; /* uniform: upper end                                           */
    schuler_place place;
    const char *text;   /* as the user wrote it, for tables: "0.0035 deg/h", "±1 mg"; owned by the
                           reader's arena */
    const char *source; /* catalog: key into the file's sources, or NULL                        */
    const char *note;   /* or NULL                                                              */
    const char *qualifier; /* what the sheet says it is: "typical", "maximum", "1 sigma"; or NULL */
    bool per_unit; /* drawn once per unit (specimen), not per run                          */
    bool assumed;  /* not a published figure of this part                                  */
} schuler_value;

/** true when every component is exactly zero (a source that does nothing). */
SCHULER_API bool schuler_value_is_zero(const schuler_value *v, int components);

/** Root mean square of a component over its draws. */
SCHULER_API double schuler_value_rms(const schuler_value *v, int component);

typedef struct schuler_arena schuler_arena; /* what a reader allocates, freed at once */
SCHULER_API schuler_arena *schuler_arena_create(void);
SCHULER_API void *schuler_arena_alloc(schuler_arena *arena,
                                      size_t size); /* zeroed, NULL on failure */
SCHULER_API const char *schuler_arena_printf(schuler_arena *arena, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
SCHULER_API void schuler_arena_free(schuler_arena *arena);

/** Read a node into an object's struct.
 *  Given      node     a map;  what  its path for messages ("imu.gyro");  object  its table
 *  Returned   spec     object->size bytes, all members set (defaults where absent)
 *             d        every mistake: unknown key with the nearest one, missing key with its
 *                      example, wrong kind, unit missing, wrong dimension, out of range
 *  Errors     SCHULER_ERR_INPUT when d gained errors; SCHULER_ERR_MEMORY */
SCHULER_API SCHULER_NODISCARD schuler_status schuler_schema_read(const schuler_node *node,
                                                                 const char *what,
                                                                 const schuler_object *object,
                                                                 void *spec, schuler_arena *arena,
                                                                 schuler_diagnostics *d);
/** Read one value by itself (sensor parameters are read this way). */
SCHULER_API SCHULER_NODISCARD schuler_status
schuler_schema_read_value(const schuler_node *node, const char *what, const schuler_field *field,
                          schuler_value *out, schuler_arena *arena, schuler_diagnostics *d);

SCHULER_END_C

#endif
