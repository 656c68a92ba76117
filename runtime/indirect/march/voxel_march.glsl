// Ray marching through the slice map (Thiedemann 2009, 4.4 and 5.3.3): one voxel lookup per even
// step. Preceded by voxel_map.glsl.
//
// Sample j = 1 to `steps` lies at (j + jitter) / steps of the ray. The jitter, from 0 to 1, is the
// same for all rays of a pixel, so the last sample may be up to a step past the ray's end. Surfaces
// thinner than a step may be missed; the first sample in a full voxel is the hit. The caller
// chooses the start: in the thesis 0.025 towards the camera.
//
//     8 steps along 16 voxels, jitter 0.5: samples at 3, 5, .. 17 voxels; a wall of one voxel is
//         hit by every second ray
bool voxelMarch(vec3 from, vec3 way, int steps, float jitter, out float t)
{
    for (int j = 1; j <= steps; j++) {
        t = (float(j) + jitter) / float(steps);
        if (voxelAt(from + t * way)) return true;
    }
    return false;
}
