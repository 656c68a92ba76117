/* Takes a share of many similar cases: one of `shares`, if TESTS_SHARE in the environment is a
 * number, which says where to begin. ./setup test under CI sets the commit's number, so that
 * `shares` successive commits cover all cases; without the variable all cases are taken. With 3
 * shares and TESTS_SHARE=1 the cases 2, 5 and 8 are taken. */
#ifndef MATC_TEST_SHARE_H
#define MATC_TEST_SHARE_H
#include <stdbool.h>
#include <stdlib.h>

static inline bool share_takes(int number, int shares)
{
    const char *share = getenv("TESTS_SHARE");
    return !share || (number + atoi(share)) % shares == 0;
}
#endif
