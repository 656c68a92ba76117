/* A share of many like cases: of every SHARES numbers one, if TESTS_SHARE in the environment is a number, which says where to begin. ./setup test under
 * CI gives the number of the commit, so that three commits take all; without it all are taken. Of shares from 1 on, 2, 5 and 8 are taken. */
#ifndef MATC_TEST_SHARE_H
#define MATC_TEST_SHARE_H
#include <stdbool.h>
#include <stdlib.h>

enum { SHARES = 3 };

static inline bool share_takes(int number)
{
    const char *share = getenv("TESTS_SHARE");
    return !share || (number + atoi(share)) % SHARES == 0;
}
#endif
