#include <noise/hash-3d>

// Value noise: three smooth random numbers in [0, 1) at a point, from hashed corners of a unit grid and Perlin's fade curve of 2002.
vec3 valueNoise3d(const in vec3 point) {
  vec3 cell = floor(point);
  vec3 f = point - cell;
  vec3 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec3 near = mix(
    mix(hash3d(cell), hash3d(cell + vec3(1.0, 0.0, 0.0)), t.x),
    mix(hash3d(cell + vec3(0.0, 1.0, 0.0)), hash3d(cell + vec3(1.0, 1.0, 0.0)), t.x), t.y);
  vec3 far = mix(
    mix(hash3d(cell + vec3(0.0, 0.0, 1.0)), hash3d(cell + vec3(1.0, 0.0, 1.0)), t.x),
    mix(hash3d(cell + vec3(0.0, 1.0, 1.0)), hash3d(cell + vec3(1.0, 1.0, 1.0)), t.x), t.y);
  return mix(near, far, t.z);
}
