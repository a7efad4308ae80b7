/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Tone map",
  "DESCRIPTION": "Makes a display layer of a scene layer: compresses light of any brightness into what a screen can show. AgX and filmic curves soften bright colors to white, Khronos Neutral keeps the colors of products, ACES adds contrast.",
  "CREDIT": "Scrim. AgX: T. Sobotka, fit by B. Wrensch 2023. ACES: S. Hill's fit of the RRT and ODT. Neutral: Khronos PBR Neutral Tone Mapper 2024. Transfer function: IEC 61966-2-1",
  "CATEGORIES": ["Light", "HDR", "Convert", "Encoding", "Color space", "AgX", "ACES", "Filmic", "Khronos Neutral", "Exposure", "Highlights"],
  "SCRIM_ENCODING": "scene to display",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The scene layer to convert." },
    { "NAME": "curve", "TYPE": "long", "LABEL": "Curve", "DOC": "How bright light is compressed. Clip cuts off what is brighter than white.", "VALUES": [0, 1, 2, 3, 4], "LABELS": ["AgX", "Khronos Neutral", "ACES", "Filmic", "Clip"], "DEFAULT": 0 },
    { "NAME": "stops", "TYPE": "float", "LABEL": "Exposure", "DOC": "Exposure in stops before compression: 1 doubles the light, -1 halves it.", "MIN": -10.0, "MAX": 10.0, "DEFAULT": 0.0, "STEP": 0.1 },
    { "NAME": "film", "TYPE": "curve", "LABEL": "Filmic curve", "DOC": "The curve of “Filmic”, for each channel: from 10 stops below middle gray on the left to 6.5 stops above it on the right; the height is the value on the screen.", "DEFAULT": [0.0, 0.0, 0.3, 0.05, 0.606, 0.46, 0.8, 0.85, 1.0, 1.0] }
  ]
}*/

const int AGX = 0;
const int NEUTRAL = 1;
const int ACES = 2;
const int FILMIC = 3;

// Middle gray, and the stops around it that AgX and the filmic curve cover.
const float GRAY = 0.18;
const float STOPS_BELOW = 10.0;
const float STOPS_ABOVE = 6.5;
const float DARKEST = 1e-10;

// Display-referred sRGB from linear light (IEC 61966-2-1), per channel.
vec3 displayFromLinear(vec3 color) {
  return mix(1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, color * 12.92, vec3(lessThanEqual(color, vec3(0.0031308))));
}

// 0 at the darkest stop, 1 at the brightest.
vec3 positionInStops(vec3 light) {
  return clamp((log2(max(light, DARKEST) / GRAY) + STOPS_BELOW) / (STOPS_BELOW + STOPS_ABOVE), 0.0, 1.0);
}

// Matrices are column-major: each vec3 is where one channel goes.
const mat3 REC2020_FROM_SRGB = mat3(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0113, 0.8956);
const mat3 SRGB_FROM_REC2020 = mat3(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);
const mat3 AGX_INSET = mat3(
  0.856627153315983, 0.137318972929847, 0.11189821299995,
  0.0951212405381588, 0.761241990602591, 0.0767994186031903,
  0.0482516061458583, 0.101439036467562, 0.811302368396859
);
const mat3 AGX_OUTSET = mat3(
  1.1271005818144368, -0.1413297634984383, -0.14132976349843826,
  -0.11060664309660323, 1.157823702216272, -0.11060664309660294,
  -0.016493938717834573, -0.016493938717834257, 1.2519364065950405
);

// The sigmoid of AgX's base look, as a polynomial of sixth degree.
vec3 agxContrast(vec3 x) {
  return ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232);
}

vec3 agx(vec3 light) {
  vec3 shaped = AGX_OUTSET * agxContrast(positionInStops(AGX_INSET * (REC2020_FROM_SRGB * light)));
  return SRGB_FROM_REC2020 * pow(max(shaped, 0.0), vec3(2.2));
}

const mat3 ACES_INPUT = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
const mat3 ACES_OUTPUT = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
// The fit maps a diffuse white of 1 to 0.8; three.js and Filament brighten by this.
const float ACES_BRIGHTENING = 1.0 / 0.6;

vec3 aces(vec3 light) {
  vec3 v = ACES_INPUT * (light * ACES_BRIGHTENING);
  vec3 above = v * (v + 0.0245786) - 0.000090537;
  vec3 below = v * (0.983729 * v + 0.4329510) + 0.238081;
  return ACES_OUTPUT * (above / below);
}

// Colors below this keep their value; the toe removes the 4 % of light that surfaces reflect at normal incidence.
const float REFLECTED = 0.04;
const float NEUTRAL_START = 0.8 - REFLECTED;
const float NEUTRAL_WHITENING = 0.15;

vec3 neutral(vec3 light) {
  float least = min(light.r, min(light.g, light.b));
  vec3 color = light - (least < 2.0 * REFLECTED ? least - 6.25 * least * least : REFLECTED);
  float peak = max(color.r, max(color.g, color.b));
  if (peak < NEUTRAL_START) return color;
  float room = 1.0 - NEUTRAL_START;
  float newPeak = 1.0 - room * room / (peak + room - NEUTRAL_START);
  float white = 1.0 - 1.0 / (NEUTRAL_WHITENING * (peak - newPeak) + 1.0);
  return mix(color * (newPeak / peak), vec3(newPeak), white);
}

vec3 filmic(vec3 light) {
  vec3 at = positionInStops(light);
  // Other hosts do not support curves.
#ifdef SCRIM
  return vec3(CURVE(film, at.r), CURVE(film, at.g), CURVE(film, at.b));
#else
  return at;
#endif
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec3 light = color.rgb * exp2(stops);
  vec3 shown;
  if (curve == FILMIC) {
    shown = filmic(light);
  } else {
    vec3 mapped = curve == AGX ? agx(light) : curve == NEUTRAL ? neutral(light) : curve == ACES ? aces(light) : light;
    shown = displayFromLinear(clamp(mapped, 0.0, 1.0));
  }
  gl_FragColor = vec4(shown, color.a);
}
