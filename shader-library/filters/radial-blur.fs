/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Zoom blur",
  "DESCRIPTION": "Blurs an image away from a point, as if the camera had zoomed during the exposure.",
  "CREDIT": "Scrim. Effect named in the mixed-reality rendering framework with osgART, figure 12",
  "CATEGORIES": ["Blur", "Radial blur", "Speed", "Motion"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to blur." },
    { "NAME": "center", "TYPE": "point2D", "LABEL": "Center", "DOC": "Point that stays sharp: (0, 0) is the bottom left of the image, (1, 1) the top right.", "MIN": [0.0, 0.0], "MAX": [1.0, 1.0], "DEFAULT": [0.5, 0.5], "HANDLE": "center" },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the zoom: with 0.2, each pixel is blurred over a fifth of its distance to the center.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.2, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

// One sample per pixel of the blur, up to a limit for phones; longer blurs are sampled more coarsely.
const int MAX_SAMPLES = 64;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

void main() {
  vec2 middle = center * RENDERSIZE;
  vec2 from = isf_FragNormCoord * RENDERSIZE - middle;
  float samples = clamp(ceil(amount * length(from)), 1.0, float(MAX_SAMPLES));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < MAX_SAMPLES; i++) {
    if (float(i) >= samples) break;
    float part = (float(i) + 0.5) / samples;
    sum += readLayer((middle + from * (1.0 - amount * part)) / RENDERSIZE);
  }
  vec4 result = sum / samples;
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
