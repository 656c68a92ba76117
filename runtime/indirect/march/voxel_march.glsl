// A ray through the slice map as Thiedemann 2009, 4.4 and 5.3.3, has it: by even steps, at each of
// which one voxel is looked up. Behind voxel_map.glsl.
//
// Places j = 1 to `steps` lie at (j + jitter) / steps of the ray, jitter from 0 to 1 and one for
// all of a pixel's rays, so that the last is up to a step past its end. What is thinner than a step
// may lie between two of them; the first that is in a full voxel is what the ray meets. It begins
// where the caller says: in the thesis 0.025 towards the camera.
//
//     8 steps along 16 voxels, jitter 0.5: places at 3, 5, .. 17 voxels; a wall of one voxel is met
//         by every second ray
bool voxelMarch(vec3 from, vec3 way, int steps, float jitter, out float t)
{
    for (int j = 1; j <= steps; j++) {
        t = (float(j) + jitter) / float(steps);
        if (voxelAt(from + t * way)) return true;
    }
    return false;
}
