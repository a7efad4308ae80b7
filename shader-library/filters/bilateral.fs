/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Smooths areas and keeps edges. Neighboring pixels count less with distance and with color difference. Use it to remove noise or to simplify an image.",
  "CREDIT": "Scrim. C. Tomasi and R. Manduchi 1998, Bilateral Filtering for Gray and Color Images, with the color distance of OpenCV",
  "CATEGORIES": ["Blur", "Smooth", "Denoise", "Edge-preserving", "Skin"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to smooth." },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DOC": "Radius of the filter, in whole pixels of the layer: twice the standard deviation. The cost grows with its square.", "MIN": 0.0, "MAX": 10.0, "DEFAULT": 6.0, "IDENTITY": 0.0, "STEP": 1.0, "UNIT": "px" },
    { "NAME": "colorRange", "TYPE": "float", "LABEL": "Color range", "DOC": "Color difference up to which pixels count as one area, summed over red, green and blue: 0.1 smooths noise, 1 begins to blur edges.", "MIN": 0.01, "MAX": 2.0, "DEFAULT": 0.2, "UNIT": "ratio" }
  ]
}*/

const int MAX_RADIUS = 10;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

void main() {
  vec4 middle = readLayer(isf_FragNormCoord);
  float reach = floor(radius + 0.5);
  float sigmaPx = max(0.5 * reach, 0.5);
  float range = max(colorRange, 0.01);
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int y = -MAX_RADIUS; y <= MAX_RADIUS; y++) {
    if (abs(float(y)) > reach) continue;
    for (int x = -MAX_RADIUS; x <= MAX_RADIUS; x++) {
      vec2 offset = vec2(float(x), float(y));
      float squared = dot(offset, offset);
      // A disk, as in OpenCV.
      if (squared > reach * reach) continue;
      vec4 color = readLayer(isf_FragNormCoord + offset / RENDERSIZE);
      float difference = dot(abs(color - middle), vec4(1.0)) / range;
      float weight = exp(-0.5 * (squared / (sigmaPx * sigmaPx) + difference * difference));
      sum += weight * color;
      total += weight;
    }
  }
  vec4 result = sum / total;
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
