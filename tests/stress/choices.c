/* Random numbers by splitmix64. */
#include "choices.h"
#include <string.h>

static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

void choices_random(Choices *c, uint64_t seed, uint64_t index)
{
    uint64_t state = seed;
    c->state = next(&state) ^ index * 0xD1342543DE82EF95u;
    next(&c->state);
    c->script = NULL;
    c->script_count = c->count = 0;
}

void choices_script(Choices *c, const uint32_t *script, int count)
{
    c->script = script;
    c->script_count = count;
    c->count = 0;
}

uint32_t choose(Choices *c, uint32_t n)
{
    if (n < 2 || c->count == MAX_CHOICES)
        return 0;
    uint32_t value = 0;
    if (!c->script)
        value = (uint32_t)((next(&c->state) >> 32) * n >> 32);
    else if (c->count < c->script_count)
        value = c->script[c->count] < n ? c->script[c->count] : n - 1;
    return c->made[c->count++] = value;
}

bool chance(Choices *c, uint32_t some, uint32_t of) { return choose(c, of) >= of - some; }

double choose_part(Choices *c) { return choose(c, 1 << 24) / (double)(1 << 24); }
