// Draws hulls for ray marching: the point in object space where a ray leaves, and the ray's origin.
layout(location = 0) in vec3 position;
layout(location = 5) in uint matc_instance;
struct Instance {
    mat4 worldFromLocal;
    mat3 worldNormalFromLocal;
    uint material;
};
layout(std140, binding = 0) readonly buffer Instances {
    Instance matc_instances[];
};
layout(std140, binding = 16) uniform View { // uniform block in the layout that matc writes
    mat4 matc_clipFromWorld;
    mat3 matc_eyeNormalFromWorld;
};
// perspective: the eye in world space, and 1; parallel rays: the direction toward the eye, and 0
uniform vec4 trace_viewer;
out vec3 trace_leaves;
flat out vec4 trace_eye; // trace_viewer in object space
flat out mat4 trace_clipFromLocal;
flat out uint trace_place;

void main()
{
    mat4 worldFromLocal = matc_instances[matc_instance].worldFromLocal;
    trace_leaves = position;
    trace_eye = inverse(worldFromLocal) * trace_viewer;
    trace_clipFromLocal = matc_clipFromWorld * worldFromLocal;
    trace_place = matc_instance;
    gl_Position = matc_clipFromWorld * (worldFromLocal * vec4(position, 1.0));
}
