// The normal of a surface with a height field, in meters, whose gradient along the local axes of the object is `slope`.
// Mikkelsen, Bump Mapping Unparametrized Surfaces on the GPU, 2010: uses screen-space derivatives instead of tangents.
vec3 perturbNormal(const in Surface s, const in vec3 slope) {
  vec3 alongX = dFdx(s.position);
  vec3 alongY = dFdy(s.position);
  vec3 first = cross(alongY, s.normal);
  vec3 second = cross(s.normal, alongX);
  float area = dot(alongX, first);
  vec3 uphill = sign(area) * (dot(slope, dFdx(s.rest)) * first + dot(slope, dFdy(s.rest)) * second);
  return normalize(abs(area) * s.normal - uphill);
}
