/* SPDX-License-Identifier: MIT */
#include "sensors/plugins.h"
#include "sensors/plugin.h"
#include "sensors/plugin_check.h"
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
    void *handle;
    char *path;
    size_t models;
} plugin;

struct schuler_plugins {
    size_t count, model_count;
    plugin *plugins;
    const schuler_sensor_model **models; /* of one after the other, NULL-terminated */
};

static schuler_status fail(schuler_error *err, const char *path, const char *message)
{
    const schuler_place place = { path, 0, 0, 0 };
    return schuler_fail(err, SCHULER_ERR_INPUT, &place, "%s", message);
}

/* All segments are there: the loader would map what is missing of a file that is cut off. */
static bool is_whole(int fd, off_t size, const ElfW(Ehdr) * head)
{
    for (int i = 0; i < head->e_phnum; i++) {
        ElfW(Phdr) segment;
        const off_t at = (off_t)(head->e_phoff + (size_t)i * sizeof segment);
        if (pread(fd, &segment, sizeof segment, at) != (ssize_t)sizeof segment) return false;
        if (segment.p_type == PT_LOAD &&
            (segment.p_offset > (size_t)size || segment.p_filesz > (size_t)size - segment.p_offset))
            return false;
    }
    return true;
}

/* What is seen from outside. */
static schuler_status look_at(const char *path, schuler_error *err)
{
    struct stat about;
    ElfW(Ehdr) head;
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) return fail(err, path, errno == ENOENT ? "no such plug-in" : strerror(errno));
    const char *message = NULL;
    if (fstat(fd, &about) != 0 || !S_ISREG(about.st_mode))
        message = "not a file, so not a plug-in";
    else if (pread(fd, &head, sizeof head, 0) != (ssize_t)sizeof head ||
             memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 || head.e_type != ET_DYN)
        message = "not a shared object, so not a plug-in";
    else if (head.e_phentsize == sizeof(ElfW(Phdr)) && !is_whole(fd, about.st_size, &head))
        message = "a shared object that is cut off";
    close(fd);
    return message ? fail(err, path, message) : SCHULER_OK;
}

/* The file's table of this interface; NULL after an error. */
static const schuler_plugin_table *find_table(void *handle, const char *path, schuler_error *err)
{
    const schuler_place place = { path, 0, 0, 0 };
    const schuler_plugin_table *const table = dlsym(handle, "schuler_plugin");
    if (!table) {
        (void)fail(err, path, "a shared object, but no plug-in: it has no symbol 'schuler_plugin'");
    } else if (table->api != SCHULER_MODEL_API) {
        schuler_fail(err, SCHULER_ERR_INPUT, &place,
                     "a plug-in for interface %d; this is schuler %s with interface %d: compile it "
                     "against this one",
                     table->api, SCHULER_VERSION_TEXT, SCHULER_MODEL_API);
    } else if (!table->models) {
        (void)fail(err, path, "a plug-in without models");
    } else {
        return table;
    }
    return NULL;
}

/* Room for one more plug-in of so many models. */
static bool grow(schuler_plugins *set, size_t models)
{
    plugin *const plugins = realloc(set->plugins, (set->count + 1) * sizeof *plugins);
    if (plugins) set->plugins = plugins;
    const schuler_sensor_model **const all =
        realloc(set->models, (set->model_count + models + 1) * sizeof *all);
    if (all) set->models = all;
    return plugins && all;
}

static schuler_status add(schuler_plugins *set, void *handle, const char *path, schuler_error *err)
{
    const schuler_plugin_table *const table = find_table(handle, path, err);
    if (!table) return SCHULER_ERR_INPUT;
    const schuler_status status =
        schuler_plugin_check(path, table->models, schuler_plugins_models(set), err);
    if (status != SCHULER_OK) return status;
    plugin it = { .handle = handle, .path = strdup(path) };
    while (table->models[it.models]) it.models++;
    if (!it.path || !grow(set, it.models)) {
        free(it.path);
        return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    }
    for (size_t i = 0; i <= it.models; i++) set->models[set->model_count + i] = table->models[i];
    set->model_count += it.models;
    set->plugins[set->count++] = it;
    return SCHULER_OK;
}

static schuler_status load(schuler_plugins *set, const char *path, schuler_error *err)
{
    const schuler_status seen = look_at(path, err);
    if (seen != SCHULER_OK) return seen;
    char *file = NULL; /* a name without a slash would be looked for elsewhere */
    if (asprintf(&file, "%s%s", strchr(path, '/') ? "" : "./", path) < 0)
        return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    void *const handle = dlopen(file, RTLD_NOW | RTLD_LOCAL);
    free(file);
    if (!handle) {
        const schuler_place place = { path, 0, 0, 0 };
        const char *const reason = dlerror();
        return schuler_fail(err, SCHULER_ERR_INPUT, &place, "cannot be loaded: %s",
                            reason ? reason : "for no known reason");
    }
    const schuler_status status = add(set, handle, path, err);
    if (status != SCHULER_OK) dlclose(handle);
    return status;
}

schuler_status schuler_plugins_load(schuler_plugins **set, const char *path, schuler_error *err)
{
    schuler_plugins *const loaded = *set ? *set : calloc(1, sizeof *loaded);
    if (!loaded) return schuler_fail(err, SCHULER_ERR_MEMORY, NULL, "out of memory");
    const schuler_status status = load(loaded, path, err);
    if (status == SCHULER_OK)
        *set = loaded;
    else if (!*set)
        schuler_plugins_free(loaded);
    return status;
}

void schuler_plugins_free(schuler_plugins *set)
{
    if (!set) return;
    for (size_t i = 0; i < set->count; i++) {
        dlclose(set->plugins[i].handle);
        free(set->plugins[i].path);
    }
    free(set->plugins);
    free(set->models);
    free(set);
}

const schuler_sensor_model *const *schuler_plugins_models(const schuler_plugins *set)
{
    static const schuler_sensor_model *const none[] = { NULL };
    return set && set->model_count ? set->models : none;
}

const char *schuler_plugins_path(const schuler_plugins *set, const schuler_sensor_model *model)
{
    size_t at = 0;
    for (size_t i = 0; set && i < set->count; i++)
        for (size_t k = 0; k < set->plugins[i].models; k++)
            if (set->models[at++] == model) return set->plugins[i].path;
    return NULL;
}
