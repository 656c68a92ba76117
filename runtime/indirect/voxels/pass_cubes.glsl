// The pass cubes: full voxels as the camera sees them, colored by the component of the map that
// holds them: 32 voxels red, 32 green, 32 blue, 32 gray.
uniform vec4 cubes_ray, cubes_view;                    // uniforms of view_space.h
// the camera's axes and position, in voxels
uniform vec4 cubes_right, cubes_up, cubes_back, cubes_eye;
uniform int cubes_level;

vec3 cubesDirection(vec3 eye)
{
    return eye.x * cubes_right.xyz + eye.y * cubes_up.xyz + eye.z * cubes_back.xyz;
}

vec4 passPixel(ivec2 pixel)
{
    const vec3 colors[4] = vec3[4](vec3(0.9, 0.25, 0.2), vec3(0.3, 0.75, 0.25),
        vec3(0.25, 0.4, 0.9), vec3(0.75));
    const float shades[4] = float[4](0.55, 0.75, 1.0, 0.3);
    bool orthographic = cubes_view.y > 0.0;
    vec2 place = (vec2(2 * pixel + 1) - cubes_ray.zw) * cubes_ray.xy;
    vec3 from = cubes_eye.xyz + cubesDirection(orthographic ? vec3(place, 0.0) : vec3(0.0));
    vec3 along = normalize(cubesDirection(vec3(orthographic ? vec2(0.0) : place, -1.0)));
    VoxelHit hit = voxelWalk(from, along, 1e9, cubes_level, false);
    return hit.way < 0.0 ? vec4(0.0) : vec4(colors[hit.at.z >> 5 & 3] * shades[hit.axis], 1.0);
}
