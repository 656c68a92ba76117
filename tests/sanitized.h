/* Thinning of cases under sanitizers. Sanitizers look for faults of memory and arithmetic, which
 * a few points find as well as many: there a test takes every SANITIZED_STEP-th point, and every
 * SANITIZED_SHARE-th combination of options. The plain build compares all values; a test that
 * includes this header is run by both builds (cmake/tests.cmake). */
#ifndef MATC_TEST_SANITIZED_H
#define MATC_TEST_SANITIZED_H
#if defined(__SANITIZE_ADDRESS__)
enum { SANITIZED = 1, SANITIZED_STEP = 10, SANITIZED_SHARE = 4 };
#else
enum { SANITIZED = 0, SANITIZED_STEP = 1, SANITIZED_SHARE = 1 };
#endif
#endif
