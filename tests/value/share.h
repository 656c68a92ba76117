/* A share of many like cases: one of `shares`, if TESTS_SHARE in the environment is a number, which
 * says where to begin. ./setup test under CI gives the number of the commit, so that as many
 * commits take all; without it all are taken. Of 3 shares from the first on, the cases 2, 5 and 8
 * are taken. */
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
