/* SPDX-License-Identifier: MIT */
#include "core/schema.h"
#include <stdalign.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct block block;
struct block {
    block *next;
    size_t used, size;
    alignas(max_align_t) unsigned char bytes[];
};

struct schuler_arena {
    block *first; /* the one being filled */
};

enum { BLOCK_SIZE = 16384 };

schuler_arena *schuler_arena_create(void)
{
    return calloc(1, sizeof(schuler_arena));
}

void *schuler_arena_alloc(schuler_arena *arena, size_t size)
{
    const size_t unit = alignof(max_align_t);
    if (size > SIZE_MAX / 2) return NULL;
    size = (size + unit - 1) / unit * unit;
    block *b = arena->first;
    if (!b || b->size - b->used < size) {
        const size_t wanted = size > BLOCK_SIZE ? size : BLOCK_SIZE;
        b = calloc(1, sizeof *b + wanted);
        if (!b) return NULL;
        b->size = wanted;
        b->next = arena->first;
        arena->first = b;
    }
    void *memory = b->bytes + b->used;
    b->used += size;
    return memory;
}

const char *schuler_arena_printf(schuler_arena *arena, const char *format, ...)
{
    va_list args, again;
    va_start(args, format);
    va_copy(again, args);
    const int n = vsnprintf(NULL, 0, format, args);
    va_end(args);
    char *text = n >= 0 ? schuler_arena_alloc(arena, (size_t)n + 1) : NULL;
    if (text) vsnprintf(text, (size_t)n + 1, format, again);
    va_end(again);
    return text;
}

void schuler_arena_free(schuler_arena *arena)
{
    if (!arena) return;
    while (arena->first) {
        block *next = arena->first->next;
        free(arena->first);
        arena->first = next;
    }
    free(arena);
}
