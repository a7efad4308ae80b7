// Display-referred sRGB from linear light (IEC 61966-2-1), per channel.
vec3 displayFromLinear(vec3 color) {
  return mix(1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, color * 12.92, vec3(lessThanEqual(color, vec3(0.0031308))));
}
