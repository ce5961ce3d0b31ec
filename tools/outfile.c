/* SPDX-License-Identifier: MIT */
#include "tools/outfile.h"
#include "tools/messages.h"
#include "tools/page.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

enum { BUFFER = 1 << 20 };

static exit_code cannot_write(const outfile *o)
{
    return say_failure("cannot write %s: %s", o->target, strerror(errno));
}

exit_code outfile_open(outfile *o, const char *path)
{
    *o = (outfile){ 0 };
    struct stat info;
    const bool exists = stat(path, &info) == 0;
    /* A link shall go on pointing to the file; /dev/null shall stay a device. */
    o->target = exists ? realpath(path, NULL) : strdup(path);
    if (!o->target) return say_failure("cannot write %s: %s", path, strerror(errno));
    if (exists && !S_ISREG(info.st_mode)) {
        o->file = fopen(path, "we");
    } else {
        if (asprintf(&o->partial, "%s.partial-%ld", o->target, (long)getpid()) < 0) {
            o->partial = NULL;
            outfile_drop(o);
            return say_failure("out of memory");
        }
        o->file = fopen(o->partial, "wxe");
    }
    if (o->file) {
        setvbuf(o->file, NULL, _IOFBF, BUFFER);
        return EXIT_DONE;
    }
    const exit_code code = cannot_write(o);
    free(o->partial); /* not ours to remove */
    o->partial = NULL;
    outfile_drop(o);
    return code;
}

/* An earlier write failed and its errno is gone; most often the disk is full. */
int outfile_reason(const outfile *o)
{
    struct statvfs space;
    return fstatvfs(fileno(o->file), &space) == 0 && space.f_bavail == 0 ? ENOSPC : EIO;
}

exit_code outfile_complete(outfile *o)
{
    if (!o->file) return EXIT_DONE;
    int reason = 0;
    if (fflush(o->file) == EOF) reason = errno;
    if (!reason && ferror(o->file)) reason = outfile_reason(o);
    if (fclose(o->file) == EOF && !reason) reason = errno;
    o->file = NULL;
    if (reason) {
        errno = reason;
        return cannot_write(o);
    }
    o->complete = true;
    return EXIT_DONE;
}

exit_code outfile_publish(outfile *o)
{
    const exit_code code = outfile_complete(o);
    if (code != EXIT_DONE || !o->complete || !o->partial) return code;
    if (rename(o->partial, o->target) != 0) return cannot_write(o);
    free(o->partial);
    o->partial = NULL;
    return EXIT_DONE;
}

void outfile_drop(outfile *o)
{
    if (o->file) fclose(o->file);
    if (o->partial) unlink(o->partial);
    free(o->partial);
    free(o->target);
    *o = (outfile){ 0 };
}

exit_code outfile_write(const char *path, void (*put)(FILE *, const void *), const void *what)
{
    if (strcmp(path, "-") == 0) {
        page p;
        page_open(&p);
        if (p.out) put(p.out, what);
        return page_show(&p);
    }
    outfile file = { 0 };
    exit_code code = outfile_open(&file, path);
    if (code == EXIT_DONE) {
        put(file.file, what);
        code = outfile_publish(&file);
    }
    outfile_drop(&file);
    return code;
}
