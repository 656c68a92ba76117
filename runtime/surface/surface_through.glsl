// What every surface model lets through: the share of the light behind it that passes, straight on. Nothing is refracted.
vec3 surfaceThrough(Surface s)
{
#ifdef SURFACE_HAS_transparency
    return s.transparency;
#else
    return vec3(0.0);
#endif
}
