/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Blurs an image with a Gaussian kernel, in two passes. The radius is the standard deviation, as in CSS blur(); the kernel extends to three times this distance.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Blur", "Soften", "Smooth"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_ENCODING": "either",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to blur." },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DOC": "Standard deviation of the blur, in pixels of the layer. 0 changes nothing.", "MIN": 0.0, "MAX": 60.0, "DEFAULT": 8.0, "IDENTITY": 0.0, "UNIT": "px" }
  ],
  "PASSES": [{ "TARGET": "across", "DESCRIPTION": "Blurs along x." }, { "DESCRIPTION": "Blurs along y." }]
}*/

// Three standard deviations contain 99.7 % of the weight. 60 px × 3: the loop needs a constant limit.
const float REACH = 3.0;
const int MAX_REACH = 180;

// With a smaller sigma only the center pixel counts; larger ones are safe to divide by.
const float MIN_SIGMA = 0.1;

// The blur uses premultiplied colors, so that transparent pixels do not darken edges. Scrim passes premultiplied colors
// (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 tap(vec2 uv) {
  if (PASSINDEX == 1) return IMG_NORM_PIXEL(across, uv);
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// One linearly filtered sample between two pixels weighs both, so half as many samples are needed. The weights of pixels at increasing
// distances are products of a ratio that shrinks by the same factor from pixel to pixel, which takes no exponential per pixel (Turkowski,
// "Incremental Computation of the Gaussian", GPU Gems 3, chapter 40).
vec4 blurred(vec2 stepUv) {
  float sigma = max(radius, MIN_SIGMA);
  int reach = int(ceil(REACH * sigma));
  float ratio = exp(-0.5 / (sigma * sigma));
  float shrink = ratio * ratio;
  float weight = 1.0;
  vec4 sum = tap(isf_FragNormCoord);
  float total = 1.0;
  for (int i = 1; i <= MAX_REACH; i += 2) {
    if (i > reach) break;
    float near = weight * ratio;
    weight = near * ratio * shrink;
    ratio *= shrink * shrink;
    float far = i < reach ? weight : 0.0;
    float both = near + far;
    vec2 offset = stepUv * (float(i) + far / both);
    sum += both * (tap(isf_FragNormCoord + offset) + tap(isf_FragNormCoord - offset));
    total += 2.0 * both;
  }
  return sum / total;
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = blurred(vec2(1.0 / RENDERSIZE.x, 0.0));
  } else {
    vec4 result = blurred(vec2(0.0, 1.0 / RENDERSIZE.y));
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
