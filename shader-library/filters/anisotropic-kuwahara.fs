/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes an image look painted, with strokes that follow its shapes: long and thin along hair and edges, round elsewhere.",
  "CREDIT": "Scrim. J. E. Kyprianidis, H. Kang and J. Döllner 2009, Computer Graphics Forum 28, 1955; weights: J. E. Kyprianidis et al. 2010, GPU Pro, 247",
  "CATEGORIES": ["Style", "Painterly", "Oil", "Brush", "Kuwahara", "Watercolor"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to filter." },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Brush size", "DOC": "Radius of a round stroke, in pixels of the layer. The cost grows with its square.", "MIN": 2.0, "MAX": 8.0, "DEFAULT": 6.0, "UNIT": "px" },
    { "NAME": "stretch", "TYPE": "float", "LABEL": "Stretch", "DOC": "How elongated strokes are along edges, up to four times as long as wide. 0 keeps them round.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "sharpness", "TYPE": "float", "LABEL": "Sharpness", "DOC": "Contrast between strokes: low values give soft strokes, high values hard edges.", "MIN": 1.0, "MAX": 12.0, "DEFAULT": 8.0 }
  ],
  "PASSES": [
    { "TARGET": "tensor", "FLOAT": true, "SCRIM_HALF": true },
    { "TARGET": "across", "FLOAT": true, "SCRIM_HALF": true },
    { "TARGET": "smoothed", "FLOAT": true, "SCRIM_HALF": true },
    { }
  ]
}*/

// The stroke extends to twice the radius along an edge.
const int REACH = 16;
const int SECTORS = 8;

// Standard deviation of the smoothing of directions, and the radius of its kernel.
const float SMOOTH_PX = 2.0;
const int SMOOTH_REACH = 6;

// Scales squares of small differences above the smallest steps of 16-bit floats.
const float SCALE = 1000.0;

// Half of the angle by which neighboring sectors overlap: 3 pi / 16.
const float SHARED = 0.58904862;
const float STEPS = 255.0;

// Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readOffset(vec2 offsetPx) {
  vec4 color = IMG_NORM_PIXEL(inputImage, isf_FragNormCoord + offsetPx / RENDERSIZE);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

// The structure tensor from Sobel derivatives: xx, yy and xy.
vec4 structure() {
  vec4 leftUp = readOffset(vec2(-1.0, 1.0));
  vec4 rightUp = readOffset(vec2(1.0, 1.0));
  vec4 leftDown = readOffset(vec2(-1.0, -1.0));
  vec4 rightDown = readOffset(vec2(1.0, -1.0));
  vec4 x = (rightUp + 2.0 * readOffset(vec2(1.0, 0.0)) + rightDown - leftUp - 2.0 * readOffset(vec2(-1.0, 0.0)) - leftDown) / 4.0;
  vec4 y = (leftUp + 2.0 * readOffset(vec2(0.0, 1.0)) + rightUp - leftDown - 2.0 * readOffset(vec2(0.0, -1.0)) - rightDown) / 4.0;
  return vec4(SCALE * vec3(dot(x, x), dot(y, y), dot(x, y)), 1.0);
}

float bell(int i) {
  return exp(-0.5 * float(i * i) / (SMOOTH_PX * SMOOTH_PX));
}

// The weight of a point of the unit disk in the sector along +x: a polynomial that falls to 0 at its sides.
float along(vec2 v, float zeta, float eta) {
  float z = max(v.x + zeta - eta * v.y * v.y, 0.0);
  return z * z;
}

vec4 paint(vec3 tensor) {
  float mean = 0.5 * (tensor.x + tensor.y);
  float spread = length(vec2(0.5 * (tensor.x - tensor.y), tensor.z));
  float anisotropy = mean > 0.0 ? stretch * spread / mean : 0.0;
  // The direction along the edge, perpendicular to the gradient.
  float angle = 0.5 * atan(2.0 * tensor.z, tensor.x - tensor.y + (spread > 0.0 ? 0.0 : 1.0)) + 1.57079633;
  float longer = radius * (1.0 + anisotropy);
  float shorter = radius / (1.0 + anisotropy);
  vec2 way = vec2(cos(angle), sin(angle));

  float zeta = 2.0 / radius;
  float sine = sin(SHARED);
  float eta = (zeta + cos(SHARED)) / (sine * sine);
  vec4 sums[SECTORS];
  vec4 squares[SECTORS];
  float weights[SECTORS];
  for (int k = 0; k < SECTORS; k++) {
    sums[k] = vec4(0.0);
    squares[k] = vec4(0.0);
    weights[k] = 0.0;
  }
  for (int j = -REACH; j <= REACH; j++) {
    for (int i = -REACH; i <= REACH; i++) {
      vec2 offset = vec2(float(i), float(j));
      vec2 v = vec2(dot(offset, way) / longer, dot(offset, vec2(-way.y, way.x)) / shorter);
      float far = dot(v, v);
      if (far >= 1.0) continue;
      vec4 color = readOffset(offset);
      float share[SECTORS];
      float whole = 0.0;
      vec2 turned = v;
      for (int k = 0; k < SECTORS; k++) {
        share[k] = along(turned, zeta, eta);
        whole += share[k];
        // Rotate by an eighth of a turn.
        turned = 0.70710678 * vec2(turned.x + turned.y, turned.y - turned.x);
      }
      // The weight is 0 at the edge of the stroke, so pixels enter and leave smoothly.
      float falloff = exp(-2.0 * far) * (1.0 - far * far) / whole;
      for (int k = 0; k < SECTORS; k++) {
        float weight = share[k] * falloff;
        sums[k] += color * weight;
        squares[k] += color * color * weight;
        weights[k] += weight;
      }
    }
  }
  vec4 sum = vec4(0.0);
  float whole = 0.0;
  for (int k = 0; k < SECTORS; k++) {
    vec4 average = sums[k] / weights[k];
    vec4 variance = max(squares[k] / weights[k] - average * average, 0.0);
    float weight = 1.0 / (1.0 + pow(STEPS * sqrt(dot(variance, vec4(1.0))), sharpness));
    sum += average * weight;
    whole += weight;
  }
  return sum / whole;
}

void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = structure();
  } else if (PASSINDEX < 3) {
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -SMOOTH_REACH; i <= SMOOTH_REACH; i++) {
      vec2 next = vec2(float(i)) / RENDERSIZE;
      vec4 read = PASSINDEX == 1 ? IMG_NORM_PIXEL(tensor, isf_FragNormCoord + vec2(next.x, 0.0)) : IMG_NORM_PIXEL(across, isf_FragNormCoord + vec2(0.0, next.y));
      sum += bell(i) * read;
      weights += bell(i);
    }
    gl_FragColor = sum / weights;
  } else {
    vec4 result = paint(IMG_NORM_PIXEL(smoothed, isf_FragNormCoord).xyz);
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
