// needs: latticeRandom
// Values and gradients of a face's four corners, from GroIMP's random table.
void latticeNumbers(vec4 hash, out vec4 value, out vec4 x, out vec4 y, out vec4 z) {
    mat4 corner = mat4(latticeRandom(hash.x), latticeRandom(hash.y), latticeRandom(hash.z), latticeRandom(hash.w));
    value = vec4(corner[0].x, corner[1].x, corner[2].x, corner[3].x);
    x = vec4(corner[0].y, corner[1].y, corner[2].y, corner[3].y);
    y = vec4(corner[0].z, corner[1].z, corner[2].z, corner[3].z);
    z = vec4(corner[0].w, corner[1].w, corner[2].w, corner[3].w);
}
