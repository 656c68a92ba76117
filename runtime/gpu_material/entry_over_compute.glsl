
// Compute entry point of a full-screen pass that blends over its target. The target's size need not
// be a multiple of the work group's.
layout(local_size_x = 8, local_size_y = 8) in;
layout(ENTRY_FORMAT) uniform image2D entry_target;
void main()
{
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(entry_target)))) return;
    vec3 through;
    vec3 color = passOver(pixel, through);
    if (color == vec3(0.0) && through == vec3(1.0)) return; // the surface contributes nothing
    vec4 behind = imageLoad(entry_target, pixel);
    imageStore(entry_target, pixel, vec4(color + through * behind.xyz, 1.0));
}
