/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Blurs an image around a point, as if the camera had rotated during the exposure.",
  "CREDIT": "Scrim. Effect named in the mixed-reality rendering framework with osgART, figure 12",
  "CATEGORIES": ["Blur", "Radial blur", "Rotation", "Motion"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to blur." },
    { "NAME": "center", "TYPE": "point2D", "LABEL": "Center", "DOC": "Point that stays sharp: (0, 0) is the bottom left of the image, (1, 1) the top right.", "MIN": [0.0, 0.0], "MAX": [1.0, 1.0], "DEFAULT": [0.5, 0.5], "HANDLE": "center" },
    { "NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DOC": "Angle of the rotation, half of it in each direction.", "MIN": 0.0, "MAX": 1.5707963, "DEFAULT": 0.17453293, "IDENTITY": 0.0, "UNIT": "rad", "HANDLE": "angle" }
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
  float samples = clamp(ceil(angle * length(from)), 1.0, float(MAX_SAMPLES));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < MAX_SAMPLES; i++) {
    if (float(i) >= samples) break;
    float turn = angle * ((float(i) + 0.5) / samples - 0.5);
    float c = cos(turn);
    float s = sin(turn);
    sum += readLayer((middle + vec2(c * from.x - s * from.y, s * from.x + c * from.y)) / RENDERSIZE);
  }
  vec4 result = sum / samples;
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
