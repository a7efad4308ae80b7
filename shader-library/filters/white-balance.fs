/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Blends between two color temperatures, such as warm lamplight and cold morning light, by hand or automatically back and forth. The blend is linear in mired (the inverse of the temperature), which looks even.",
  "CREDIT": "Scrim. Planckian locus: Kang et al. 2002, J. Korean Physical Society 41, 865. Adaptation: Bradford, as in ICC.1:2022 annex E. Even steps: D. B. Judd 1933, J. Optical Society of America 23, 7",
  "CATEGORIES": ["Color", "White balance", "Warm", "Cold", "Cool", "Temperature", "Animation"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to recolor. It is assumed to be lit with 6500 K." },
    { "NAME": "warm", "TYPE": "float", "LABEL": "Warm", "DOC": "Color temperature of the warm light.", "MIN": 1700.0, "MAX": 15000.0, "DEFAULT": 3200.0, "STEP": 50.0, "UNIT": "K" },
    { "NAME": "cold", "TYPE": "float", "LABEL": "Cold", "DOC": "Color temperature of the cold light.", "MIN": 1700.0, "MAX": 15000.0, "DEFAULT": 9500.0, "STEP": 50.0, "UNIT": "K" },
    { "NAME": "balance", "TYPE": "float", "LABEL": "Warm to cold", "DOC": "Mix of the two color temperatures: 0 is “Warm”, 1 is “Cold”.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "swing", "TYPE": "float", "LABEL": "Swing", "DOC": "Period of the automatic movement to the other light and back, in seconds. It starts at “Warm to cold”. 0 turns it off.", "MIN": 0.0, "MAX": 120.0, "DEFAULT": 0.0, "UNIT": "s" }
  ]
}*/

const float NEUTRAL_K = 6500.0;
const float TURN = 6.2831853;

// Linear sRGB to XYZ (IEC 61966-2-1) followed by XYZ to the Bradford cone space, column by column; and the inverse.
const mat3 CONES_FROM_LINEAR = mat3(0.42266086, 0.05561593, 0.02135054, 0.49137816, 0.96159832, 0.08764776, 0.02738893, 0.02318695, 0.98071055);
const mat3 LINEAR_FROM_CONES = mat3(2.53818388, -0.14578260, -0.04222865, -1.29334181, 1.11646529, -0.07162372, -0.04030699, -0.02232524, 1.02254160);
const mat3 CONES_FROM_XYZ = mat3(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);

// Linear light from display-referred sRGB (IEC 61966-2-1), per channel.
vec3 linearFromDisplay(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, vec3(lessThanEqual(color, vec3(0.04045))));
}

// Display-referred sRGB from linear light (IEC 61966-2-1), per channel.
vec3 displayFromLinear(vec3 color) {
  return mix(1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, color * 12.92, vec3(lessThanEqual(color, vec3(0.0031308))));
}

// Chromaticity (CIE 1931 x, y) of a black body, 1667 K to 25000 K.
vec2 planckianLocus(float kelvin) {
  float t = 1000.0 / kelvin;
  float x = kelvin <= 4000.0
    ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
    : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
  float y = kelvin <= 2222.0
    ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
    : kelvin <= 4000.0
      ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
      : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  return vec2(x, y);
}

// Cone responses (LMS) to white light of luminance 1 with this color temperature, in kelvin.
vec3 conesOfWhite(float kelvin) {
  vec2 xy = planckianLocus(kelvin);
  return CONES_FROM_XYZ * vec3(xy.x / xy.y, 1.0, (1.0 - xy.x - xy.y) / xy.y);
}

// A cosine between 0 and 1 that starts at the balance.
float place() {
  if (swing <= 0.0) return balance;
  float begin = acos(clamp(1.0 - 2.0 * balance, -1.0, 1.0));
  return 0.5 - 0.5 * cos(begin + TURN * TIME / swing);
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float kelvin = 1.0 / mix(1.0 / warm, 1.0 / cold, place());
  vec3 adaptation = conesOfWhite(kelvin) / conesOfWhite(NEUTRAL_K);
  vec3 adapted = LINEAR_FROM_CONES * (adaptation * (CONES_FROM_LINEAR * linearFromDisplay(color.rgb)));
  gl_FragColor = vec4(displayFromLinear(clamp(adapted, 0.0, 1.0)), color.a);
}
