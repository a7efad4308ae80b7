// The layer that the current pass evens out.
vec4 readStage(vec2 uv) {
  if (PASSINDEX == 3) return readLayer(uv);
  if (PASSINDEX == 4) return IMG_NORM_PIXEL(areas1, uv);
  if (PASSINDEX == 5) return IMG_NORM_PIXEL(areas2, uv);
  return IMG_NORM_PIXEL(areas3, uv);
}
