/* SPDX-License-Identifier: MIT */
#include "tools/messages.h"
#include "tools/outfile.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Everything that a result consists of; nothing else is ever removed. */
static const char *const files[] = { "budget.csv", "errors.csv", "result.json", "result.nc",
                                     "scenario.yaml" };
enum { FILES = sizeof(files) / sizeof(files[0]) };

static bool is_result_file(const char *name)
{
    for (int i = 0; i < FILES; i++)
        if (strcmp(files[i], name) == 0) return true;
    return false;
}

/* Empty, or an earlier result and nothing besides. */
static exit_code check_replaceable(const char *path)
{
    DIR *dir = opendir(path);
    if (!dir)
        return errno == ENOTDIR ? say_bad_input("-o %s: there is a file of that name", path)
                                : say_failure("-o %s: %s", path, strerror(errno));
    exit_code code = EXIT_DONE;
    for (struct dirent *entry; code == EXIT_DONE && (entry = readdir(dir));) {
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        if (!is_result_file(entry->d_name))
            code =
                say_bad_input("-o %s: the directory holds '%s', which is not of a result; give an "
                              "empty or a new one",
                              path, entry->d_name);
    }
    closedir(dir);
    return code;
}

static void remove_directory(const char *path)
{
    for (int i = 0; i < FILES; i++) {
        char *file;
        if (asprintf(&file, "%s/%s", path, files[i]) < 0) continue;
        unlink(file);
        free(file);
    }
    rmdir(path);
}

exit_code outdir_open(outdir *d, const char *path)
{
    *d = (outdir){ 0 };
    struct stat info;
    const bool exists = stat(path, &info) == 0;
    if (exists) {
        const exit_code code = check_replaceable(path);
        if (code != EXIT_DONE) return code;
    }
    d->target = exists ? realpath(path, NULL) : strdup(path);
    if (!d->target) return say_failure("-o %s: %s", path, strerror(errno));
    for (size_t n = strlen(d->target); n > 1 && d->target[n - 1] == '/'; n--)
        d->target[n - 1] = '\0';
    if (asprintf(&d->partial, "%s.partial-%ld", d->target, (long)getpid()) < 0) {
        d->partial = NULL;
        outdir_drop(d);
        return say_failure("out of memory");
    }
    if (mkdir(d->partial, 0777) == 0) return EXIT_DONE;
    const exit_code code = say_failure("cannot make the directory %s: %s", path, strerror(errno));
    free(d->partial); /* not ours to remove */
    d->partial = NULL;
    outdir_drop(d);
    return code;
}

exit_code outdir_file(const outdir *d, outfile *o, const char *name)
{
    char *path;
    if (asprintf(&path, "%s/%s", d->partial, name) < 0) return say_failure("out of memory");
    const exit_code code = outfile_open(o, path);
    free(path);
    return code;
}

/* Both names change owner at once where the file system can do that; else one after the other. */
static int exchange(const char *partial, const char *target)
{
    if (renameat2(AT_FDCWD, partial, AT_FDCWD, target, RENAME_EXCHANGE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return -1;
    char *old;
    if (asprintf(&old, "%s.old", partial) < 0) return -1;
    int status = rename(target, old);
    if (status == 0) {
        status = rename(partial, target);
        if (rename(old, status == 0 ? partial : target) != 0) status = -1;
    }
    free(old);
    return status;
}

exit_code outdir_publish(outdir *d)
{
    if (!d->partial) return EXIT_DONE;
    const bool replace = access(d->target, F_OK) == 0;
    if ((replace ? exchange(d->partial, d->target) : rename(d->partial, d->target)) != 0)
        return say_failure("cannot write %s: %s", d->target, strerror(errno));
    if (replace) remove_directory(d->partial);
    free(d->partial);
    d->partial = NULL;
    return EXIT_DONE;
}

void outdir_drop(outdir *d)
{
    if (d->partial) remove_directory(d->partial);
    free(d->partial);
    free(d->target);
    *d = (outdir){ 0 };
}
