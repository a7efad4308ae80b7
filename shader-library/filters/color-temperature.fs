/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Color temperature",
  "DESCRIPTION": "Changes the color temperature of an image: warm as candlelight or cool as shade. The image is assumed to be lit with 6500 K, so 6500 K changes nothing; a lower temperature is warmer. White keeps its brightness.",
  "CREDIT": "Scrim. Planckian locus: Kang et al. 2002, J. Korean Physical Society 41, 865. Adaptation: Bradford, as in ICC.1:2022 annex E",
  "CATEGORIES": ["Color", "White balance", "Warm", "Cool", "Color correction"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to recolor." },
    { "NAME": "temperature", "TYPE": "float", "LABEL": "Temperature", "DOC": "Color temperature of the light: candle 1900 K, bulb 2700 K, noon 5500 K, shade 8000 K.", "MIN": 1700.0, "MAX": 15000.0, "DEFAULT": 6500.0, "IDENTITY": 6500.0, "STEP": 50.0, "UNIT": "K" }
  ]
}*/

const float NEUTRAL_K = 6500.0;

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

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec3 adaptation = conesOfWhite(temperature) / conesOfWhite(NEUTRAL_K);
  vec3 adapted = LINEAR_FROM_CONES * (adaptation * (CONES_FROM_LINEAR * linearFromDisplay(color.rgb)));
  gl_FragColor = vec4(displayFromLinear(clamp(adapted, 0.0, 1.0)), color.a);
}
