#include "compiler/library/reference.h"

REFERENCE(leopard)
{
    (void)context;
    double mean = (sin(args[0]) + sin(args[1]) + sin(args[2])) / 3;
    result[0] = mean * mean;
}
