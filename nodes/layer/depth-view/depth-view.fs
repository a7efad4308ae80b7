/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Depth view",
  "DESCRIPTION": "Shows room depth as colors, with a scale in meters.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Utility", "Depth"],
  "SCRIM_DEPTH": "none",
  "INPUTS": [
    { "NAME": "depth", "TYPE": "depth", "LABEL": "Room depth", "DOC": "The depth to show." },
    { "NAME": "nearM", "TYPE": "float", "MIN": 0.0, "MAX": 20.0, "DEFAULT": 0.5, "UNIT": "m" },
    { "NAME": "farM", "TYPE": "float", "MIN": 0.1, "MAX": 20.0, "DEFAULT": 4.0, "UNIT": "m" },
    { "NAME": "opacity", "TYPE": "float", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "UNIT": "ratio" },
    { "NAME": "legend", "TYPE": "bool", "DEFAULT": true }
  ]
}*/

const vec3 INK = vec3(1.0);
const vec3 PAPER = vec3(0.08);
// The scale, as fractions of the view height: left edge, width, bottom and top.
const float LEFT = 0.05;
const float WIDE = 0.03;
const float FOOT = 0.2;
const float TOP = 0.8;
const float STEPS = 5.0;
// The size of a dot of a digit (3 by 5 dots), as a fraction of the view height.
const float DOT = 0.006;

// The color of a value from 0 (red) over yellow, green and cyan to 1 (blue), with a linear hue.
vec3 colorOf(float part) {
  float hue = clamp(part, 0.0, 1.0) * 4.0;
  return clamp(vec3(2.0 - hue, min(hue, 4.0 - hue), hue - 2.0), 0.0, 1.0);
}

// The glyphs: rows of three dots from the top, as bits.
float glyphOf(float digit) {
  if (digit < 1.0) return 31599.0;
  if (digit < 2.0) return 11415.0;
  if (digit < 3.0) return 29671.0;
  if (digit < 4.0) return 29647.0;
  if (digit < 5.0) return 23497.0;
  if (digit < 6.0) return 31183.0;
  if (digit < 7.0) return 31215.0;
  if (digit < 8.0) return 29257.0;
  if (digit < 9.0) return 31727.0;
  return 31695.0;
}

// Whether a point, in dots from the bottom left of the first digit, is part of the text "12.3 m".
bool isText(vec2 at, float meters) {
  vec2 cell = floor(at / vec2(4.0, 5.0));
  vec2 place = floor(at - cell * vec2(4.0, 5.0));
  if (cell.y != 0.0 || cell.x < 0.0 || place.x > 2.0) return false;
  float tenths = floor(meters * 10.0 + 0.5);
  float glyph = 0.0;
  if (cell.x == 0.0 && tenths >= 100.0) glyph = glyphOf(mod(floor(tenths / 100.0), 10.0));
  if (cell.x == 1.0) glyph = glyphOf(mod(floor(tenths / 10.0), 10.0));
  if (cell.x == 2.0) glyph = 2.0;
  if (cell.x == 3.0) glyph = glyphOf(mod(tenths, 10.0));
  if (cell.x == 5.0) glyph = 509.0;
  float bit = place.y * 3.0 + 2.0 - place.x;
  return mod(floor(glyph / exp2(bit)), 2.0) > 0.5;
}

// Draws the scale over a color: a bar with labels in meters, on a dark background.
vec3 withLegend(vec3 color, vec2 at) {
  vec2 onBar = vec2((at.x - LEFT) / WIDE, (at.y - FOOT) / (TOP - FOOT));
  if (all(greaterThanEqual(onBar, vec2(0.0))) && all(lessThanEqual(onBar, vec2(1.0)))) return colorOf(onBar.y);
  vec2 corner = vec2(LEFT - 0.02, FOOT - 0.04);
  vec2 opposite = vec2(LEFT + WIDE + 0.03 + 24.0 * DOT, TOP + 0.04);
  if (any(lessThan(at, corner)) || any(greaterThan(at, opposite))) return color;
  float nearest = clamp(floor(onBar.y * STEPS + 0.5), 0.0, STEPS);
  float heightOfIt = mix(FOOT, TOP, nearest / STEPS);
  vec2 inDots = (at - vec2(LEFT + WIDE + 0.015, heightOfIt)) / DOT + vec2(0.0, 2.5);
  return isText(inDots, mix(nearM, farM, nearest / STEPS)) ? INK : PAPER;
}

void main() {
  // Both coordinates as fractions of the view height, so that digits keep their aspect ratio.
  vec2 at = isf_FragNormCoord * vec2(RENDERSIZE.x / RENDERSIZE.y, 1.0);
  float m = ROOM_DEPTH(depth, isf_FragNormCoord);
  bool isStripe = fract((at.x + at.y) * 24.0) < 0.5;
  vec3 color = m > 0.0 ? colorOf((m - nearM) / max(farM - nearM, 0.001)) : vec3(isStripe ? 0.12 : 0.22);
  gl_FragColor = vec4(legend ? withLegend(color, at) : color, opacity);
}
