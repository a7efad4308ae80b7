/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes a mask of skin: white on skin, black elsewhere. By color alone, wood, fur, curtains and orange cloth can be mistaken for skin: by default it finds 77 to 100 % of the skin in photographs, and takes up to a third of the rest for skin beside such colors, most of the images of a cat and of a cup on a wooden table, and two fifths of a living room. Pick the color of the skin where they are in view: that finds 90 to 100 % and takes at most 5 % of the rest. “Clean mask” fills the holes that are left.",
  "CREDIT": "Scrim. Range: D. Chai and K. N. Ngan 1999, IEEE Trans. Circuits and Systems for Video Technology 9, 551. Likelihood: M. J. Jones and J. M. Rehg 2002, Statistical Color Models with Application to Skin Detection, Int. J. Computer Vision 46, 81, Table 2. YCbCr: Rec. ITU-R BT.601",
  "CATEGORIES": ["Mask", "Key", "Skin", "Face", "Hand"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to read, such as the camera video." },
    { "NAME": "show", "TYPE": "long", "LABEL": "Show", "DOC": "Mask: white skin on black, for a Mask node. Cut out: the image, transparent where there is no skin.", "VALUES": [0, 1], "LABELS": ["Mask", "Cut out"], "DEFAULT": 0 },
    { "NAME": "rule", "TYPE": "long", "LABEL": "Find by", "DOC": "Range: a fixed range of Cb and Cr; finds most skin and much else. Likelihood: colors that are likelier skin than not in photographs; finds less of both, and little skin in bluish light. Picked color: colors near “Skin color”; the most exact.", "VALUES": [0, 1, 2], "LABELS": ["Range", "Likelihood", "Picked color"], "DEFAULT": 0 },
    { "NAME": "skinColor", "TYPE": "color", "LABEL": "Skin color", "DOC": "The color of the skin, for “Picked color”. Its brightness does not matter.", "DEFAULT": [0.78, 0.58, 0.48, 1.0] },
    { "NAME": "widen", "TYPE": "float", "LABEL": "Widen", "DOC": "Accepts more colors, or fewer below 0: in 8-bit steps of Cb and Cr, or tenths of the natural logarithm of the likelihood ratio.", "MIN": -15.0, "MAX": 30.0, "DEFAULT": 0.0 },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Range outside the accepted colors over which the mask fades out, in the same steps. 0 gives a hard edge.", "MIN": 0.0, "MAX": 30.0, "DEFAULT": 4.0 }
  ]
}*/

// Values of “Find by”.
const int BY_LIKELIHOOD = 1;
const int BY_PICKED_COLOR = 2;

// Cb and Cr of BT.601 as 8-bit code values, the units of the rules: 128 is neutral.
const vec3 CB_601 = vec3(-37.7965, -74.2035, 112.0);
const vec3 CR_601 = vec3(112.0, -93.7860, -18.2140);
const float NO_COLOR = 128.0;

// Range: Cb from 77 to 127 and Cr from 133 to 173 is skin.
const vec2 SKIN_LOW = vec2(77.0, 133.0);
const vec2 SKIN_HIGH = vec2(127.0, 173.0);

// Picked color: Cb and Cr up to this far from those of the picked color are skin.
const float NEAR = 7.5;

// Likelihood: mixtures of 16 Gaussians over 8-bit RGB, of skin and of everything else, without covariances. Colors are skin where
// its density is the higher one.
const float STEPS_PER_LOG = 10.0;
// Densities where no kernel is near: such a color is not skin.
const float LEAST_SKIN_DENSITY = 1e-30;
const float LEAST_OTHER_DENSITY = 1e-24;

// A hard edge; values on it are skin.
const float LEAST = 0.001;

vec2 chromaOf(vec3 color) {
  return NO_COLOR + vec2(dot(color, CB_601), dot(color, CR_601));
}

// A Gaussian over 8-bit RGB without covariances, up to a factor that all share.
float kernel(vec3 rgb, vec3 mean, vec3 variance, float weight) {
  vec3 apart = rgb - mean;
  return weight * inversesqrt(variance.r * variance.g * variance.b) * exp(-0.5 * dot(apart, apart / variance));
}

// How often a color is one of skin.
float skinDensity(vec3 rgb) {
  return kernel(rgb, vec3(73.53, 29.94, 17.76), vec3(765.40, 121.44, 112.80), 0.0294)
    + kernel(rgb, vec3(249.71, 233.94, 217.49), vec3(39.94, 154.44, 396.05), 0.0331)
    + kernel(rgb, vec3(161.68, 116.25, 96.95), vec3(291.03, 60.48, 162.85), 0.0654)
    + kernel(rgb, vec3(186.07, 136.62, 114.40), vec3(274.95, 64.60, 198.27), 0.0756)
    + kernel(rgb, vec3(189.26, 98.37, 51.18), vec3(633.18, 222.40, 250.69), 0.0554)
    + kernel(rgb, vec3(247.00, 152.20, 90.84), vec3(65.23, 691.53, 609.92), 0.0314)
    + kernel(rgb, vec3(150.10, 72.66, 37.76), vec3(408.63, 200.77, 257.57), 0.0454)
    + kernel(rgb, vec3(206.85, 171.09, 156.34), vec3(530.08, 155.08, 572.79), 0.0469)
    + kernel(rgb, vec3(212.78, 152.82, 120.04), vec3(160.57, 84.52, 243.90), 0.0956)
    + kernel(rgb, vec3(234.87, 175.43, 138.94), vec3(163.80, 121.57, 279.22), 0.0763)
    + kernel(rgb, vec3(151.19, 97.74, 74.59), vec3(425.40, 73.56, 175.11), 0.1100)
    + kernel(rgb, vec3(120.52, 77.55, 59.82), vec3(330.45, 70.34, 151.82), 0.0676)
    + kernel(rgb, vec3(192.20, 119.62, 82.32), vec3(152.76, 92.14, 259.15), 0.0755)
    + kernel(rgb, vec3(214.29, 136.08, 87.24), vec3(204.90, 140.17, 270.19), 0.0500)
    + kernel(rgb, vec3(99.57, 54.33, 38.06), vec3(448.13, 90.18, 151.29), 0.0667)
    + kernel(rgb, vec3(238.88, 203.08, 176.91), vec3(178.38, 156.27, 404.99), 0.0749);
}

// How often it is one of anything else.
float otherDensity(vec3 rgb) {
  return kernel(rgb, vec3(254.37, 254.41, 253.82), vec3(2.77, 2.81, 5.46), 0.0637)
    + kernel(rgb, vec3(9.39, 8.09, 8.52), vec3(46.84, 33.59, 32.48), 0.0516)
    + kernel(rgb, vec3(96.57, 96.95, 91.53), vec3(280.69, 156.79, 436.58), 0.0864)
    + kernel(rgb, vec3(160.44, 162.49, 159.06), vec3(355.98, 115.89, 591.24), 0.0636)
    + kernel(rgb, vec3(74.98, 63.23, 46.33), vec3(414.84, 245.95, 361.27), 0.0747)
    + kernel(rgb, vec3(121.83, 60.88, 18.31), vec3(2502.24, 1383.53, 237.18), 0.0365)
    + kernel(rgb, vec3(202.18, 154.88, 91.04), vec3(957.42, 1766.94, 1582.52), 0.0349)
    + kernel(rgb, vec3(193.06, 201.93, 206.55), vec3(562.88, 190.23, 447.28), 0.0649)
    + kernel(rgb, vec3(51.88, 57.14, 61.55), vec3(344.11, 191.77, 433.40), 0.0656)
    + kernel(rgb, vec3(30.88, 26.84, 25.32), vec3(222.07, 118.65, 182.41), 0.1189)
    + kernel(rgb, vec3(44.97, 85.96, 131.95), vec3(651.32, 840.52, 963.67), 0.0362)
    + kernel(rgb, vec3(236.02, 236.27, 230.70), vec3(225.03, 117.29, 331.95), 0.0849)
    + kernel(rgb, vec3(207.86, 191.20, 164.12), vec3(494.04, 237.69, 533.52), 0.0368)
    + kernel(rgb, vec3(99.83, 148.11, 188.17), vec3(955.88, 654.95, 916.70), 0.0389)
    + kernel(rgb, vec3(135.06, 131.92, 123.10), vec3(350.35, 130.30, 388.43), 0.0943)
    + kernel(rgb, vec3(135.96, 103.89, 66.88), vec3(806.44, 642.20, 350.36), 0.0477);
}

// The natural logarithm of the ratio of densities, skin over the rest.
float logRatio(vec3 color) {
  vec3 rgb = color * 255.0;
  return log((LEAST_SKIN_DENSITY + skinDensity(rgb)) / (LEAST_OTHER_DENSITY + otherDensity(rgb)));
}

// How far a color is outside of those that the rule accepts, in the steps of the rule. Negative inside.
float outsideBy(vec3 color) {
  if (rule == BY_LIKELIHOOD) return -logRatio(color) * STEPS_PER_LOG;
  vec2 chroma = chromaOf(color);
  if (rule == BY_PICKED_COLOR) return distance(chroma, chromaOf(skinColor.rgb)) - NEAR;
  vec2 outside = max(SKIN_LOW - chroma, chroma - SKIN_HIGH);
  return max(outside.x, outside.y);
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float skin = clamp(1.0 - (outsideBy(color.rgb) - widen - LEAST) / max(softness, LEAST), 0.0, 1.0);
  gl_FragColor = show == 1 ? vec4(color.rgb, color.a * skin) : vec4(vec3(skin), color.a);
}
