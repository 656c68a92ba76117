// Returns the start offset of marched rays, and of sample points: the key `offset`; otherwise the
// smallest at which rays do not hit the flat surface that they leave, given the resolution of the
// depth buffer (pixel centers) or of the voxels (voxelStart).
float indirectLift(vec3 point, vec3 normal)
{
#ifdef INDIRECT_VOXELS
    vec3 place = voxelPlace(point), up = voxelDirection(normal);
    return indirect_reach.y > 0.0 ? indirect_reach.y
        : distance(voxelStart(place, normalize(up)), place) / length(up);
#else
    return indirect_reach.y + indirect_reach.z * indirectPixelSize(point);
#endif
}
