// A hash of integer coordinates: three numbers in [0, 1). PCG3D of Jarzynski and Olano,
// Hash Functions for GPU Rendering, JCGT 2020: integer arithmetic, so the result is the same on every GPU.
vec3 hash3d(const in vec3 cell) {
  uvec3 v = uvec3(ivec3(floor(cell) + 0.5)) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0;
}
