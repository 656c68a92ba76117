/* Most tests as one program (cmake -DMATC_TESTS_JOINED=ON): joined NAME ARGUMENTS... runs the
 * main of NAME.c, which is called NAME_main here. JOINED_TESTS, a file that cmake writes, has a
 * row for each test: TEST(name, void) or TEST(name, ARGUMENTS), by the parameters of its main. */
#include <stdio.h>
#include <string.h>

#define ARGUMENTS              int count, char **arguments
#define TEST(name, parameters) int name##_main(parameters);
#include JOINED_TESTS
#undef TEST

/* Exactly one of the two is set. */
typedef struct Test {
    const char *name;
    int (*plain)(void);
    int (*with)(ARGUMENTS);
} Test;
#undef ARGUMENTS
#define IS_void                .plain
#define IS_ARGUMENTS           .with
#define TEST(name, parameters) {#name, IS_##parameters = name##_main},
static const Test tests[] = {
#include JOINED_TESTS
};

int main(int count, char **arguments)
{
    for (size_t i = 0; count > 1 && i < sizeof tests / sizeof *tests; i++) {
        const Test *test = &tests[i];
        if (strcmp(test->name, arguments[1]) == 0)
            return test->plain ? test->plain() : test->with(count - 1, arguments + 1);
    }
    fprintf(stderr, "usage: joined NAME ARGUMENTS...\n");
    return 2;
}
