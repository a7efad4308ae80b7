// What a white matt surface with this normal shows: Lambert's law over all lights, and the surroundings.
vec3 diffuseLight(const in vec3 normal) {
  vec3 sum = AMBIENT;
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    sum += light.radiance * (max(dot(normal, light.towards), 0.0) * light.lit / 3.14159265);
  }
  return sum;
}
