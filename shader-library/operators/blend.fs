/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Blends one layer with another by a blend mode. Where one of them is transparent, the other shows unchanged.",
  "CREDIT": "Scrim. Modes: W3C Compositing and Blending Level 1, sections 9.1.13 and 10",
  "CATEGORIES": ["Composite", "Mix", "Blend mode", "Layer", "Multiply", "Screen", "Overlay", "Add"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "over",
  "SCRIM_OPAQUE": ["bottom"],
  "INPUTS": [
    { "NAME": "top", "TYPE": "image", "LABEL": "Top", "DOC": "The layer in front: the source." },
    { "NAME": "bottom", "TYPE": "image", "LABEL": "Bottom", "DOC": "The layer behind: the backdrop." },
    { "NAME": "mode", "TYPE": "long", "LABEL": "Mode", "DOC": "How the top layer changes the colors below it. Multiply and the burn modes darken, screen and the dodge modes lighten, overlay and the light modes do both, difference and exclusion invert, plus lighter adds. Hue, saturation, color and luminosity take only that property from the top layer.", "VALUES": [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16], "LABELS": ["Normal", "Multiply", "Screen", "Overlay", "Darken", "Lighten", "Color dodge", "Color burn", "Hard light", "Soft light", "Difference", "Exclusion", "Hue", "Saturation", "Color", "Luminosity", "Plus lighter"], "DEFAULT": 1 },
    { "NAME": "opacity", "TYPE": "float", "LABEL": "Opacity", "DOC": "Opacity of the top layer: 0 hides it, 1 applies it fully.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

// Names as in section 10 of the specification: cs is the color of the source, cb that of the backdrop, both with straight alpha.

// Half an 8-bit step: a channel of 1 remains full after the rounding of a division by alpha.
const float FULL = 1.0 - 0.5 / 255.0;

float hardLight(float cb, float cs) {
  return cs <= 0.5 ? 2.0 * cb * cs : cb + (2.0 * cs - 1.0) - cb * (2.0 * cs - 1.0);
}

float colorDodge(float cb, float cs) {
  if (cb <= 0.0) return 0.0;
  return cs >= FULL ? 1.0 : min(1.0, cb / (1.0 - cs));
}

float colorBurn(float cb, float cs) {
  if (cb >= FULL) return 1.0;
  return cs <= 0.0 ? 0.0 : 1.0 - min(1.0, (1.0 - cb) / cs);
}

float softLight(float cb, float cs) {
  if (cs <= 0.5) return cb - (1.0 - 2.0 * cs) * cb * (1.0 - cb);
  float d = cb <= 0.25 ? ((16.0 * cb - 12.0) * cb + 4.0) * cb : sqrt(cb);
  return cb + (2.0 * cs - 1.0) * (d - cb);
}

float separable(float cb, float cs) {
  if (mode == 1) return cb * cs;
  if (mode == 2) return cb + cs - cb * cs;
  if (mode == 3) return hardLight(cs, cb);
  if (mode == 4) return min(cb, cs);
  if (mode == 5) return max(cb, cs);
  if (mode == 6) return colorDodge(cb, cs);
  if (mode == 7) return colorBurn(cb, cs);
  if (mode == 8) return hardLight(cb, cs);
  if (mode == 9) return softLight(cb, cs);
  if (mode == 10) return abs(cb - cs);
  if (mode == 11) return cb + cs - 2.0 * cb * cs;
  return cs;
}

float lum(vec3 c) {
  return dot(c, vec3(0.3, 0.59, 0.11));
}

float lowest(vec3 c) {
  return min(min(c.r, c.g), c.b);
}

float highest(vec3 c) {
  return max(max(c.r, c.g), c.b);
}

float sat(vec3 c) {
  return highest(c) - lowest(c);
}

vec3 clipColor(vec3 c) {
  float l = lum(c);
  float n = lowest(c);
  float x = highest(c);
  if (n < 0.0) c = l + (c - l) * l / (l - n);
  if (x > 1.0) c = l + (c - l) * (1.0 - l) / (x - l);
  return c;
}

vec3 setLum(vec3 c, float l) {
  return clipColor(c + (l - lum(c)));
}

// The specification sorts the channels; the line below is equivalent.
vec3 setSat(vec3 c, float s) {
  float range = sat(c);
  return range > 0.0 ? (c - lowest(c)) * s / range : vec3(0.0);
}

vec3 nonSeparable(vec3 cb, vec3 cs) {
  if (mode == 12) return setLum(setSat(cs, sat(cb)), lum(cb));
  if (mode == 13) return setLum(setSat(cb, sat(cs)), lum(cb));
  if (mode == 14) return setLum(cs, lum(cb));
  return setLum(cb, lum(cs));
}

vec3 straight(vec4 premultiplied) {
  return premultiplied.a > 0.0 ? premultiplied.rgb / premultiplied.a : vec3(0.0);
}

vec3 blended(vec3 cb, vec3 cs) {
  if (mode >= 12) return nonSeparable(cb, cs);
  return vec3(separable(cb.r, cs.r), separable(cb.g, cs.g), separable(cb.b, cs.b));
}

void main() {
  vec4 source = IMG_THIS_PIXEL(top);
  vec4 backdrop = IMG_THIS_PIXEL(bottom);
  // Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
#ifndef SCRIM
  source.rgb *= source.a;
  backdrop.rgb *= backdrop.a;
#endif
  vec3 mixed = blended(straight(backdrop), straight(source));
  source *= opacity;
  vec4 result;
  if (mode == 16) {
    result = min(source + backdrop, 1.0);
  } else {
    result.rgb = source.rgb * (1.0 - backdrop.a) + backdrop.rgb * (1.0 - source.a) + source.a * backdrop.a * mixed;
    result.a = source.a + backdrop.a * (1.0 - source.a);
  }
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
