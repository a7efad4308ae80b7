// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}
