// What programs of rays are given, and what they tell: the depth, and what finds the place again, a and b (trace_patch.glsl), the patch and the instance.
layout(std430, binding = 5) readonly buffer TraceNodes {
    vec4 trace_nodes[];
};
in vec3 trace_leaves;               // where the ray leaves what is drawn, in the object's space
flat in vec4 trace_eye;             // whence it comes: the eye and 1, or the direction toward it and 0
flat in mat4 trace_clipFromLocal;
flat in uint trace_place;
layout(location = 0) out uvec4 trace_seen;

// From the eye to where the ray leaves; of parallel rays the direction.
vec3 traceWay() { return trace_eye.w > 0.0 ? trace_leaves - trace_eye.xyz : -trace_eye.xyz; }

// It meets the patch there. In clip space.
vec4 traceMeet(int number, vec2 at, vec3 place)
{
    vec4 clip = trace_clipFromLocal * vec4(place, 1.0);
    gl_FragDepth = clip.z / clip.w;
    trace_seen = uvec4(floatBitsToUint(at), uint(number), trace_place + 1u);
    return clip;
}
