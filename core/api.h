/* SPDX-License-Identifier: MIT */
#ifndef SCHULER_CORE_API_H
#define SCHULER_CORE_API_H

#if defined(SCHULER_BUILDING)
#define SCHULER_API __attribute__((visibility("default")))
#else
#define SCHULER_API
#endif

/* A result that must not be dropped: mostly the status of something that can fail. */
#define SCHULER_NODISCARD __attribute__((warn_unused_result))

#ifdef __cplusplus
#define SCHULER_BEGIN_C extern "C" {
#define SCHULER_END_C   }
#else
#define SCHULER_BEGIN_C
#define SCHULER_END_C
#endif

#endif
