/* Bounded forms of functions whose precision GLSL does not specify. The references are C's
 * functions. */
#include "compiler/library/reference.h"

REFERENCE(sineBounded) { (void)context, result[0] = sin(args[0]); }
REFERENCE(cosineBounded) { (void)context, result[0] = cos(args[0]); }
REFERENCE(tangentBounded) { (void)context, result[0] = tan(args[0]); }
REFERENCE(arcsineBounded) { (void)context, result[0] = asin(clamp(args[0], -1, 1)); }
REFERENCE(arccosineBounded) { (void)context, result[0] = acos(clamp(args[0], -1, 1)); }
REFERENCE(arctangentBounded) { (void)context, result[0] = atan(args[0]); }
REFERENCE(angleBounded)
{
    (void)context, result[0] = args[0] == 0 && args[1] == 0 ? 0 : atan2(args[0], args[1]);
}
REFERENCE(powerCompensated) { (void)context, result[0] = pow(args[0], args[1]); }
