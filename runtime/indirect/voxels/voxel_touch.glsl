// A triangle of a mesh that is not closed, seen along one axis: the voxel is full in which it meets
// the line through the pixel's middle. VOXEL_CUT: unless its material is cut away there, so that
// surfaceMain() discards it.
layout(r32ui) uniform uimage2DArray voxel_surface;
uniform int voxel_axis;

void main()
{
#ifdef VOXEL_CUT
    surfaceMain();
#endif
    int size = imageSize(voxel_surface).x;
    ivec3 seen = clamp(ivec3(gl_FragCoord.xy, gl_FragCoord.z * float(size)), 0, size - 1); // the axis is the last
    ivec3 at = voxel_axis == 0 ? seen.zxy : voxel_axis == 1 ? seen.yzx : seen;
    imageAtomicOr(voxel_surface, ivec3(at.xy, at.z >> 5), 1u << uint(at.z & 31));
}
