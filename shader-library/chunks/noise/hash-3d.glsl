// Three numbers in [0, 1) that whole coordinates get, without a pattern to be seen. PCG3D of Jarzynski and Olano,
// Hash Functions for GPU Rendering, JCGT 2020: whole numbers, so it is the same on every GPU.
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
