/* A stream of choices: random choices that are recorded, or a script of recorded ones. A
 * document made from a stream is simplified by shortening its script: 0 is always the simplest
 * choice, and past the script's end all choices are 0. */
#ifndef MATC_STRESS_CHOICES_H
#define MATC_STRESS_CHOICES_H
#include <stdbool.h>
#include <stdint.h>

enum { MAX_CHOICES = 4096 };

typedef struct {
    uint64_t state;         /* state of the random numbers */
    const uint32_t *script; /* NULL: choices are random */
    int script_count;
    uint32_t made[MAX_CHOICES];
    int count;
} Choices;

/* A separate stream for each pair of numbers. */
void choices_random(Choices *c, uint64_t seed, uint64_t index);
void choices_script(Choices *c, const uint32_t *script, int count);

/* An integer in [0, n). After MAX_CHOICES choices it is 0. */
uint32_t choose(Choices *c, uint32_t n);
/* True in `some` of `of` cases; the simplest choice is false. */
bool chance(Choices *c, uint32_t some, uint32_t of);
/* A number in [0, 1), a multiple of 2^-24. */
double choose_part(Choices *c);
#endif
