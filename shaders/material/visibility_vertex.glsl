// Vertex stage: the ambient visibility of both sides, for the fragments. Its directions turn as normals do.
#if AMBIENT_VISIBILITY
vec4 visibilityInView(vec4 visibility) {
  vec3 n = vec3(visibility);
#if INSTANCING
  mat3 instance = mat3(instanceMatrix);
  n = instance * (n / vec3(dot(instance[0], instance[0]), dot(instance[1], instance[1]), dot(instance[2], instance[2])));
#endif
  n = normalMatrix * n;
  return vec4(dot(n, n) > 0.0 ? normalize(n) : vec3(0.0), visibility.w);
}
#endif
