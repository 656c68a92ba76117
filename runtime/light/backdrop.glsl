// Backdrop radiance, linear, of pixels without a surface: tiles, or a glow, by the formulas of
// scene.def. A position is the center of a sample in the picture.
layout(std140) uniform Backdrop {
    vec4 backdrop_place; // the tile's corner in the picture, and the picture's size
    float backdrop_tile; // edge of a checker tile; 0: the backdrop is a glow
    float backdrop_share; // factor that exposure will cancel
};
#define BACKDROP

vec3 backdropAt(ivec2 pixel)
{
    vec2 place = vec2(pixel) + 0.5 + backdrop_place.xy;
    if (backdrop_tile > 0.0) {
        ivec2 tile = ivec2(floor(place / backdrop_tile));
        return vec3((tile.x + tile.y & 1) != 0 ? 0.13286832 : 0.31854678); // sRGB's 0.4 and 0.6
    }
    vec2 p = (2.0 * place - backdrop_place.zw) / min(backdrop_place.z, backdrop_place.w) -
        vec2(0.0, 0.1);
    return mix(vec3(0.034, 0.036, 0.040), vec3(0.150, 0.155, 0.165), exp(-1.6 * dot(p, p)));
}
