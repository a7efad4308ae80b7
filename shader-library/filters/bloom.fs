/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Adds a glow around bright areas, as a camera lens does. The glow is added in linear light.",
  "CREDIT": "Scrim. Transfer function: IEC 61966-2-1. Luma weights: Rec. ITU-R BT.709",
  "CATEGORIES": ["Light", "Glow", "Blur", "Lens", "Shine"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_ENCODING": "either",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer that glows." },
    { "NAME": "level", "TYPE": "float", "LABEL": "Level", "DOC": "Areas brighter than this glow: luminance in linear light, from 0 to 1.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DOC": "Standard deviation of the glow, in pixels of the layer; the glow extends to three times this distance.", "MIN": 1.0, "MAX": 60.0, "DEFAULT": 12.0, "UNIT": "px" },
    { "NAME": "strength", "TYPE": "float", "LABEL": "Strength", "DOC": "Strength of the glow. 0 changes nothing.", "MIN": 0.0, "MAX": 4.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ],
  "PASSES": [
    { "TARGET": "bright", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Extracts the light above the level, at half size." },
    { "TARGET": "across", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Blurs along x." },
    { "TARGET": "glow", "FLOAT": true, "SCRIM_HALF": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Blurs along y." },
    { "DESCRIPTION": "Adds the glow." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// Three standard deviations contain 99.7 % of the weight: 60 px x 3 at half size.
const float REACH = 3.0;
const int MAX_REACH = 90;

// Linear light from display-referred sRGB (IEC 61966-2-1), per channel.
vec3 linearFromDisplay(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, vec3(lessThanEqual(color, vec3(0.04045))));
}

// Display-referred sRGB from linear light (IEC 61966-2-1), per channel.
vec3 displayFromLinear(vec3 color) {
  return mix(1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, color * 12.92, vec3(lessThanEqual(color, vec3(0.0031308))));
}

// Linear light, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 lightAt(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifdef SCRIM_SCENE
  return color;
#else
#ifdef SCRIM
  if (color.a > 0.0) color.rgb /= color.a;
#endif
  return vec4(linearFromDisplay(min(color.rgb, 1.0)) * color.a, color.a);
#endif
}

// The light above the level, with the same hue.
vec3 brightAt(vec2 uv) {
  vec3 light = lightAt(uv).rgb;
  float luminance = dot(light, LUMA_709);
  return light * (max(luminance - level, 0.0) / max(luminance, 0.0001));
}

vec3 lightOf(vec2 uv) {
  return PASSINDEX == 1 ? IMG_NORM_PIXEL(bright, uv).rgb : IMG_NORM_PIXEL(across, uv).rgb;
}

// The weight of a pixel in a Gaussian blur, relative to the center. `sigma` is the standard deviation, in pixels.
float weight(int distancePx, float sigma) {
  float x = float(distancePx) / sigma;
  return exp(-0.5 * x * x);
}

// One linearly filtered sample between two pixels weighs both, so half as many samples are needed.
vec3 blurred(vec2 stepUv) {
  float sigma = 0.5 * max(radius, 1.0);
  int reach = int(ceil(REACH * sigma));
  vec3 sum = lightOf(isf_FragNormCoord);
  float total = 1.0;
  for (int i = 1; i <= MAX_REACH; i += 2) {
    if (i > reach) break;
    float near = weight(i, sigma);
    float far = i < reach ? weight(i + 1, sigma) : 0.0;
    float both = near + far;
    vec2 offset = stepUv * (float(i) + far / both);
    sum += both * (lightOf(isf_FragNormCoord + offset) + lightOf(isf_FragNormCoord - offset));
    total += 2.0 * both;
  }
  return sum / total;
}

void main() {
  if (PASSINDEX == 0) {
    // The mean of the four pixels below this one.
    vec2 apart = 0.25 / RENDERSIZE;
    vec3 sum = brightAt(isf_FragNormCoord + apart) + brightAt(isf_FragNormCoord - apart);
    sum += brightAt(isf_FragNormCoord + vec2(apart.x, -apart.y)) + brightAt(isf_FragNormCoord + vec2(-apart.x, apart.y));
    gl_FragColor = vec4(0.25 * sum, 1.0);
  } else if (PASSINDEX == 1) {
    gl_FragColor = vec4(blurred(vec2(1.0 / RENDERSIZE.x, 0.0)), 1.0);
  } else if (PASSINDEX == 2) {
    gl_FragColor = vec4(blurred(vec2(0.0, 1.0 / RENDERSIZE.y)), 1.0);
  } else {
    vec4 light = lightAt(isf_FragNormCoord);
    vec3 added = strength * IMG_NORM_PIXEL(glow, isf_FragNormCoord).rgb;
#ifdef SCRIM_SCENE
    // Light that is added covers nothing.
    gl_FragColor = vec4(light.rgb + added, light.a);
#else
    // Where the layer is transparent, the alpha of the glow is its brightest channel.
    vec3 shown = displayFromLinear(min(added, 1.0));
    float alpha = light.a + (1.0 - light.a) * max(shown.r, max(shown.g, shown.b));
    vec3 straight = displayFromLinear(min((light.rgb + added) / max(alpha, 0.0001), 1.0));
#ifdef SCRIM
    gl_FragColor = vec4(straight * alpha, alpha);
#else
    gl_FragColor = vec4(straight, alpha);
#endif
#endif
  }
}
