// The view positions: gray, shaded by the angle to the line of sight; blue for triangles that only
// join two surfaces.
uniform vec4 positions_view;
in vec3 position;
flat in float position_known;
layout(location = 0) out vec4 positions_shown;

void main()
{
    vec3 normal = cross(dFdx(position), dFdy(position));
    vec3 sight = positions_view.y > 0.0 ? vec3(0.0, 0.0, 1.0) : normalize(position);
    float shade = 0.25 + 0.75 * abs(dot(normal, sight)) / max(length(normal), 1e-30);
    positions_shown = vec4(shade * mix(vec3(0.15, 0.25, 0.7), vec3(0.9), position_known), 1.0);
}
