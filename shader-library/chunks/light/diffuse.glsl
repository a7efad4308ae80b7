// Radiance of a white matte surface with this normal: Lambert's law for all lights, plus the environment.
vec3 diffuseLight(const in vec3 normal) {
  vec3 sum = IRRADIANCE(normal);
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    sum += light.radiance * (max(dot(normal, light.towards), 0.0) * light.lit);
  }
  return sum / 3.14159265;
}
