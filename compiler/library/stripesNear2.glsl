// needs:
// Box-filtered square waves for edge < 1/2, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q
// in [0, 1]. From the distance to the nearest transition, without cancellation: error 1e-7 at any
// width. An edge <= 1e-6 gives the point value; a transition belongs to its upper side.
vec2 stripesNear2(vec2 q, vec2 edges) {
    vec2 side = 1.0 - 2.0 * step(0.5, q);
    vec2 distance = min(min(q, 1.0 - q), abs(q - 0.5));
    return side * max(min(2.0 * distance / max(edges, 1.0e-6), 1.0), step(edges, vec2(1.0e-6)));
}
