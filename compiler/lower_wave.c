/* Waveforms, from the `build` column of waves.def. */
#include "lower.h"

#define K(x)             number(l, x)
#define UNARY(op, a)     ir_unary(l->ir, OP_##op, a)
#define BINARY(op, a, b) ir_binary(l->ir, OP_##op, a, b)
#define MUL(a, b)        mul(l, a, b)
#define SUB(a, b)        sub(l, a, b)
#define CLAMP(a, b, c)   ir_ternary(l->ir, OP_clamp, a, K(b), K(c))
#define CALL(name, a)    ir_call(l->ir, FN_##name, (Ref[]){a}, 1)

Ref lower_wave(Lower *l, const Wave *wave, Ref v)
{
    if (!wave)
        return v;
    switch (wave->kind) {
#define WAVE(name, reference, build, doc)                                                                              \
    case WAVE_##name:                                                                                                  \
        return build;
#include "grammar/waves.def"
#undef WAVE
    case WAVE_Chain:
        break;
    }
    Ref first = lower_wave(l, wave->first, v);
    Ref scaled = mul(l, first, param_value(l, &wave->factor, TYPE_float));
    return lower_wave(l, wave->second, add(l, scaled, param_value(l, &wave->shift, TYPE_float)));
}
