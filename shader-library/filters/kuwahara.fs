/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes an image look painted: areas become flat strokes and edges stay sharp. Each pixel takes the mean color of the neighboring region with the least variance.",
  "CREDIT": "Scrim. M. Kuwahara et al. 1976. Weights: G. Papari et al. 2007, IEEE Trans. Image Processing 16, 2449, in the form of J. E. Kyprianidis et al. 2009",
  "CATEGORIES": ["Style", "Painterly", "Oil", "Smooth", "Watercolor"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to filter." },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Brush size", "DOC": "Size of the regions, in whole pixels of the layer. The cost grows with its square.", "MIN": 0.0, "MAX": 8.0, "DEFAULT": 5.0, "IDENTITY": 0.0, "STEP": 1.0, "UNIT": "px" },
    { "NAME": "sharpness", "TYPE": "float", "LABEL": "Sharpness", "DOC": "Contrast between strokes: low values give soft strokes, high values hard edges.", "MIN": 1.0, "MAX": 12.0, "DEFAULT": 8.0 }
  ]
}*/

const int MAX_RADIUS = 8;

// Deviations are in 8-bit steps, as in the paper: below one step all regions have the same weight.
const float STEPS = 255.0;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// The weighted mean of the square with this pixel in one corner, and the weight.
vec4 painted(vec2 side, int reach, out float weight) {
  vec4 sum = vec4(0.0);
  vec4 squares = vec4(0.0);
  for (int y = 0; y <= MAX_RADIUS; y++) {
    if (y > reach) break;
    for (int x = 0; x <= MAX_RADIUS; x++) {
      if (x > reach) break;
      vec4 color = readLayer(isf_FragNormCoord + side * vec2(float(x), float(y)) / RENDERSIZE);
      sum += color;
      squares += color * color;
    }
  }
  float count = float((reach + 1) * (reach + 1));
  vec4 mean = sum / count;
  vec4 variance = max(squares / count - mean * mean, 0.0);
  float deviation = STEPS * sqrt(dot(variance, vec4(1.0)));
  weight = 1.0 / (1.0 + pow(deviation, sharpness));
  return mean * weight;
}

void main() {
  int reach = int(floor(radius + 0.5));
  vec4 weights;
  vec4 sum = painted(vec2(1.0, 1.0), reach, weights.x);
  sum += painted(vec2(-1.0, 1.0), reach, weights.y);
  sum += painted(vec2(-1.0, -1.0), reach, weights.z);
  sum += painted(vec2(1.0, -1.0), reach, weights.w);
  vec4 result = sum / dot(weights, vec4(1.0));
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
