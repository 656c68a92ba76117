// Objects that moved since rays were kept, drawn where they are visible: the number of their motion
// in the block History, from 1 on. Vertices are shadow_depth.glsl's; a pixel is visible if it has
// the depth that the surfaces' own programs left, up to rounding.
uniform sampler2D motion_depth;
uniform float motion_number;
layout(location = 0) out uint motion_seen;

void main()
{
    float depth = texelFetch(motion_depth, ivec2(gl_FragCoord.xy), 0).x;
    if (abs(gl_FragCoord.z - depth) > 1e-4 * depth + 2e-7) discard;
    motion_seen = uint(motion_number);
}
