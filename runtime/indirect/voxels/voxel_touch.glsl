// A triangle of an open mesh, viewed along one axis: fills the voxel in which the line through the
// pixel's center hits the triangle. VOXEL_CUT: alpha-tested; surfaceMain() discards the fragment
// where the material is cut away.
layout(r32ui) uniform uimage2DArray voxel_surface;
uniform int voxel_axis;

void main()
{
#ifdef VOXEL_CUT
    surfaceMain();
#endif
    int size = imageSize(voxel_surface).x;
    // z is the axis of the view
    ivec3 seen = clamp(ivec3(gl_FragCoord.xy, gl_FragCoord.z * float(size)), 0, size - 1);
    ivec3 at = voxel_axis == 0 ? seen.zxy : voxel_axis == 1 ? seen.yzx : seen;
    imageAtomicOr(voxel_surface, ivec3(at.xy, at.z >> 5), 1u << uint(at.z & 31));
}
