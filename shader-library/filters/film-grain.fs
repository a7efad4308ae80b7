/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Adds film grain or sensor noise. Use it on rendered layers so that they match the camera image.",
  "CREDIT": "Scrim. Idea: J. Fischer et al. 2006, Enhanced Visual Realism by Incorporating Camera Image Effects, ISMAR. Random numbers: I. McEwan et al. 2012, J. Graphics Tools 16, 85",
  "CATEGORIES": ["Style", "Noise", "Film", "Camera", "Vintage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to add grain to." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Standard deviation of the grain; full brightness is 1. Phone cameras indoors have about 0.02.", "MIN": 0.0, "MAX": 0.5, "DEFAULT": 0.08, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "size", "TYPE": "float", "LABEL": "Grain size", "DOC": "Size of a grain, in pixels of the layer.", "MIN": 1.0, "MAX": 16.0, "DEFAULT": 1.0, "STEP": 1.0, "UNIT": "px" },
    { "NAME": "color", "TYPE": "float", "LABEL": "Color", "DOC": "0 gives gray grain, as film has; 1 gives colored grain, as sensors have.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "midtones", "TYPE": "float", "LABEL": "Only midtones", "DOC": "0 adds the same grain everywhere, 1 adds none to black and white.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "rate", "TYPE": "float", "LABEL": "Rate", "DOC": "How often the grain changes, in hertz. 0 keeps it still.", "MIN": 0.0, "MAX": 60.0, "DEFAULT": 24.0, "UNIT": "Hz" }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// The sum of four random numbers from 0 to 1 has a variance of 4 / 12.
const float SPREAD = 1.7320508;

// An integer modulo PERIOD. Adding one half compensates for rounding of the quotient.
float wrap(float whole) {
  return whole - PERIOD * floor((whole + 0.5) / PERIOD);
}

// A permutation of the integers below PERIOD, for noise. Nested, the quadratic ones modulo 289 of McEwan et al. 2012 and of Gustavson and
// McEwan 2022 repeat after 24 and 38 pixels along a line, because they are linear modulo 17.
float permute(float x) {
  return wrap(wrap(x * x) * x);
}

// A pseudorandom integer below PERIOD for a cell of a grid in a frame.
float seedOf(vec2 cell, float frame) {
  return permute(wrap(permute(wrap(permute(wrap(cell.x)) + cell.y)) + wrap(frame)));
}

// Approximately a normal distribution with standard deviation 1: two numbers from each of two seeds.
float grain(vec2 cell, float channel, float frame) {
  vec2 seeds = vec2(seedOf(cell, frame), seedOf(cell.yx + 11.0, frame));
  float sum = 0.0;
  for (int i = 0; i < 2; i++) {
    seeds.x = permute(wrap(seeds.x + 4.0 * channel + float(i) + 1.0));
    seeds.y = permute(wrap(seeds.y + 4.0 * channel + float(i) + 1.0));
    sum += (seeds.x + seeds.y + 1.0) / PERIOD;
  }
  return (sum - 2.0) * SPREAD;
}

void main() {
  vec4 picture = IMG_THIS_PIXEL(inputImage);
  vec2 cell = floor(isf_FragNormCoord * RENDERSIZE / max(size, 1.0));
  // An offset for each period, so that the pattern does not repeat across a wide image.
  cell += floor(cell.yx / PERIOD) * vec2(37.0, 101.0);
  float frame = floor(TIME * rate);
  vec3 colored = vec3(grain(cell, 0.0, frame), grain(cell, 1.0, frame), grain(cell, 2.0, frame));
  vec3 noise = mix(vec3(grain(cell, 3.0, frame)), colored, color);
  float luma = dot(picture.rgb, LUMA_709);
  float strength = amount * mix(1.0, 4.0 * luma * (1.0 - luma), midtones);
  gl_FragColor = vec4(picture.rgb + strength * noise, picture.a);
}
