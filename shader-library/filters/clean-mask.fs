/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Clean mask",
  "DESCRIPTION": "Fills small holes of a mask and removes small specks, as a morphological closing and opening. Use it after masks by color, such as “Skin mask” and “Chroma key”.",
  "CREDIT": "Scrim. Closing and opening: J. Serra 1982, Image Analysis and Mathematical Morphology",
  "CATEGORIES": ["Mask", "Matte", "Morphology", "Close", "Open", "Dilate", "Erode", "Grow", "Shrink", "Choke", "Despeckle", "Denoise"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The mask: white on black, or opaque on transparent." },
    { "NAME": "holesPx", "TYPE": "float", "LABEL": "Fill holes", "DOC": "Fills holes and gaps narrower than twice this, in pixels of the layer.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 3.0, "IDENTITY": 0.0, "UNIT": "px" },
    { "NAME": "specksPx", "TYPE": "float", "LABEL": "Remove specks", "DOC": "Removes specks and strips narrower than twice this, in pixels of the layer.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 2.0, "IDENTITY": 0.0, "UNIT": "px" },
    { "NAME": "growPx", "TYPE": "float", "LABEL": "Grow", "DOC": "Moves the border of the mask outward, or inward below 0, in pixels of the layer.", "MIN": -24.0, "MAX": 24.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "px" }
  ],
  "PASSES": [
    { "TARGET": "grownAcross", "DESCRIPTION": "Closing: grows the mask along x." },
    { "TARGET": "grown", "DESCRIPTION": "Closing: grows it along y." },
    { "TARGET": "shrunkAcross", "DESCRIPTION": "Shrinks it along x, back and by the size of specks." },
    { "TARGET": "shrunk", "DESCRIPTION": "Shrinks it along y." },
    { "TARGET": "openedAcross", "DESCRIPTION": "Opening: grows the rest back along x, and moves the border." },
    { "DESCRIPTION": "Grows the rest back along y, and moves the border." }
  ]
}*/

// The largest radius: both sliders at their end.
const int MAX_REACH = 48;

vec4 tap(vec2 uv) {
  if (PASSINDEX == 0) return IMG_NORM_PIXEL(inputImage, uv);
  if (PASSINDEX == 1) return IMG_NORM_PIXEL(grownAcross, uv);
  if (PASSINDEX == 2) return IMG_NORM_PIXEL(grown, uv);
  if (PASSINDEX == 3) return IMG_NORM_PIXEL(shrunkAcross, uv);
  if (PASSINDEX == 4) return IMG_NORM_PIXEL(shrunk, uv);
  return IMG_NORM_PIXEL(openedAcross, uv);
}

// Largest value of each channel up to a distance, for a positive radius; the smallest one for a negative radius.
vec4 extreme(float radiusPx, vec2 stepUv) {
  float side = radiusPx < 0.0 ? -1.0 : 1.0;
  int reach = int(floor(abs(radiusPx) + 0.5));
  vec4 most = side * tap(isf_FragNormCoord);
  for (int i = 1; i <= MAX_REACH; i++) {
    if (i > reach) break;
    vec2 offset = stepUv * float(i);
    most = max(most, max(side * tap(isf_FragNormCoord - offset), side * tap(isf_FragNormCoord + offset)));
  }
  return side * most;
}

void main() {
  // Whole pixels, so that what grows by both radii shrinks by the same.
  float holes = floor(holesPx + 0.5);
  float specks = floor(specksPx + 0.5);
  float radiusPx = PASSINDEX < 2 ? holes : PASSINDEX < 4 ? -(holes + specks) : specks + floor(growPx + 0.5);
  bool across = PASSINDEX == 0 || PASSINDEX == 2 || PASSINDEX == 4;
  gl_FragColor = extreme(radiusPx, across ? vec2(1.0 / RENDERSIZE.x, 0.0) : vec2(0.0, 1.0 / RENDERSIZE.y));
}
