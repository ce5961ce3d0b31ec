/* SPDX-License-Identifier: MIT */
/* Any bytes as a file of increments, after its header: rows, faults, or an error with a place. The first byte
 * says whether gaps are bridged. */
#include "scenarios/increments.h"
#include "scenarios/trajectory_file.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char header[] = SCHULER_IMU_HEADER "\n";
    if (size < 1) return 0;
    const int fd = memfd_create("increments", 0);
    char path[64];
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    if (fd < 0 || write(fd, header, sizeof header - 1) < 0 || write(fd, data + 1, size - 1) < 0)
        abort();
    static schuler_increments in; /* large */
    schuler_faults faults = { 0 };
    schuler_error error = { 0 };
    in = (schuler_increments){ .bridge = data[0] & 1, .faults = &faults };
    schuler_status status = schuler_increments_open(&in, path, 0.0, &error);
    while (status == SCHULER_OK && in.n > 0) {
        in.used = in.n;
        status = schuler_increments_more(&in, &error);
    }
    schuler_increments_judge(&in);
    schuler_increments_close(&in);
    close(fd);
    /* What is refused says what and where. */
    if (status != SCHULER_OK && (!error.message[0] || error.place.file != path)) abort();
    return 0;
}
