// Linear light from display-referred sRGB (IEC 61966-2-1), per channel.
vec3 linearFromDisplay(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, vec3(lessThanEqual(color, vec3(0.04045))));
}
