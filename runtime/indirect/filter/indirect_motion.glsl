// Draws the visible pixels of a moved object: the id of its motion in the block History, from 1 on.
// The vertex program is shadow_depth.glsl; a fragment is visible if its depth equals that of the
// surface's own program, up to rounding.
uniform sampler2D motion_depth;
uniform float motion_number;
layout(location = 0) out uint motion_seen;

void main()
{
    float depth = texelFetch(motion_depth, ivec2(gl_FragCoord.xy), 0).x;
    if (abs(gl_FragCoord.z - depth) > 1e-4 * depth + 2e-7) discard;
    motion_seen = uint(motion_number);
}
