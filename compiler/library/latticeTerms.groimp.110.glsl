// needs: latticeRandom
// Value plus gradient terms of a face's four corners; d is the offset from the first corner.
vec4 latticeTerms(vec4 hash, vec3 d) {
    return vec4(dot(latticeRandom(hash.x), vec4(0.5, d)),
                dot(latticeRandom(hash.y), vec4(0.5, d - vec3(1.0, 0.0, 0.0))),
                dot(latticeRandom(hash.z), vec4(0.5, d - vec3(0.0, 1.0, 0.0))),
                dot(latticeRandom(hash.w), vec4(0.5, d - vec3(1.0, 1.0, 0.0))));
}
