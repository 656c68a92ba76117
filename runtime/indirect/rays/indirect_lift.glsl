// How far off its surface a point's rays begin by even steps, and places of its half ball: as the
// key `offset` says; else where nothing that is flat is met by its own rays, by what they are
// looked for in: depth, which is that of pixels' middles, or voxels (voxelStart).
float indirectLift(vec3 point, vec3 normal)
{
#ifdef INDIRECT_VOXELS
    vec3 place = voxelPlace(point), up = voxelDirection(normal);
    return indirect_reach.y > 0.0 ? indirect_reach.y : distance(voxelStart(place, normalize(up)), place) / length(up);
#else
    return indirect_reach.y + indirect_reach.z * indirectPixelSize(point);
#endif
}
