/*{
  "DESCRIPTION": "Draws objects as a charcoal drawing: smudged dark areas, paper grain in the halftones, and thick rough outlines. The grain stays on the object and keeps its size on screen at any distance.",
  "CREDIT": "Scrim. After Majumder and Gopi, Hardware Accelerated Real Time Charcoal Rendering, NPAR 2002: contrast, smudging and grain; grain of constant size: Bénard, Bousseau, Thollot, Dynamic Solid Textures for Real-Time Coherent Stylization, I3D 2009",
  "CATEGORIES": ["Charcoal", "Drawing", "Sketch", "Paper", "Pencil", "NPR", "Smudge"],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "back" }],
  "INPUTS": [
    { "NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DOC": "Contrast between dark and bright areas.", "MIN": 0.5, "MAX": 4.0, "DEFAULT": 1.8 },
    { "NAME": "darkness", "TYPE": "float", "LABEL": "Pressure", "DOC": "Amount of charcoal.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "UNIT": "ratio" },
    { "NAME": "grain", "TYPE": "float", "LABEL": "Grain", "DOC": "Roughness of the paper.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.7, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "grainPx", "TYPE": "float", "LABEL": "Grain size", "DOC": "Size of the grain on screen.", "MIN": 1.0, "MAX": 12.0, "DEFAULT": 2.5, "UNIT": "px" },
    { "NAME": "smudge", "TYPE": "float", "LABEL": "Smudge", "DOC": "How much the charcoal is smudged, in uneven strokes.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "charcoalColor", "TYPE": "color", "LABEL": "Charcoal", "DOC": "Color of the charcoal.", "DEFAULT": [0.1, 0.09, 0.09, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color of the paper. With alpha below 1, what is behind the object shows through.", "DEFAULT": [0.95, 0.93, 0.88, 1.0] },
    { "NAME": "ownTone", "TYPE": "float", "LABEL": "Own tone", "DOC": "How much darker the dark colors of the object are drawn.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "linePx", "TYPE": "float", "LABEL": "Outline", "DOC": "Width of the outline on screen. 0 turns it off.", "MIN": 0.0, "MAX": 16.0, "DEFAULT": 4.0, "IDENTITY": 0.0, "STEP": 0.5, "UNIT": "px" }
  ]
}*/
#include <light/received>
#include <noise/value-3d>

void vertex(inout Vertex v) {
  if (PASSINDEX != 1) return;
  // An uneven line: between half and the full width.
  float pressed = 0.5 + 0.5 * valueNoise3d(v.rest * (0.04 / max(PIXEL_M(v.position), 0.000001))).x;
  v.position += v.outward * (pressed * linePx * PIXEL_M(v.position));
}

// The part of the paper that is lower than a point, from 0 to 1: a blend of two noises on the object whose sizes are nearest to
// the given size on screen, so that the grain keeps its place and its size.
float paperAt(const in Surface s) {
  float octave = -log2(max(PIXEL_M(s.position) * grainPx, 0.000001));
  float whole = floor(octave);
  float fine = exp2(whole);
  vec3 a = valueNoise3d(s.rest * fine);
  vec3 b = valueNoise3d(s.rest * (fine * 2.0));
  float between = octave - whole;
  vec3 weights = vec3(0.65 * (1.0 - between), 0.35 + 0.3 * between, 0.35 * between);
  float height = dot(weights, vec3(a.x, b.y, a.z) - 0.5);
  // The noise has a standard deviation of 0.2, and the sum of such noises nearly a normal distribution. A logistic curve, with the
  // factor that fits these best, makes all heights equally frequent.
  return 1.0 / (1.0 + exp(-1.63 * height / (0.2 * length(weights))));
}

// Half the range of heights over which the charcoal gets thinner.
const float EDGE = 0.25;

// How much charcoal is at a height of the paper, so that the mean over all heights is `dark`.
float depositedAt(const in float height, const in float dark) {
  float least = min(dark, 1.0 - dark);
  // Near white and black the range is cut off, and the mean is a square.
  float from = least < EDGE ? 2.0 * sqrt(least * EDGE) - EDGE : least;
  float above = dark < 0.5 ? 1.0 - from : from;
  return clamp((height - above) / (2.0 * EDGE) + 0.5, 0.0, 1.0);
}

vec4 surface(const in Surface s) {
  float paper = paperAt(s);
  if (PASSINDEX == 1) {
    if (linePx <= 0.0) discard;
    float line = mix(1.0, smoothstep(0.15, 0.45, 1.0 - paper), grain);
    return vec4(charcoalColor.rgb, charcoalColor.a * s.color.a * line);
  }
  float own = pow(dot(s.color.rgb, vec3(0.2126, 0.7152, 0.0722)), 0.45);
  float lit = lightReceived(s) * mix(1.0, own, ownTone);
  // Smudging leaves broad uneven strokes, longer than they are wide.
  vec3 strokes = s.rest * (0.012 / max(PIXEL_M(s.position), 0.000001)) * vec3(1.0, 3.0, 1.0);
  float rubbed = (valueNoise3d(strokes + s.rest.yzx * 3.0).x - 0.5) * 0.36 * smudge;
  // A contrast about the middle gray that leaves black and white where they are.
  float pressed = clamp(lit + 0.5 - darkness, 0.0, 1.0);
  float bright = pow(pressed, contrast);
  bright /= bright + pow(1.0 - pressed, contrast);
  // Edges that face away from the view are darker, as in hand drawings.
  bright *= 1.0 - 0.25 * (1.0 - smoothstep(0.0, 0.45, dot(s.normal, s.towardsEye)));
  float dark = 1.0 - bright;
  // Smudged strokes are as often darker as they are brighter, and faint where there is little paper left.
  dark = clamp(dark + 6.75 * dark * (1.0 - dark) * (1.0 - dark) * rubbed, 0.0, 1.0);
  // Charcoal covers the heights of the paper first; smudging fills its valleys with a soft tone, and so does pressing hard.
  float rough = grain * (1.0 - 0.5 * smudge) * min((1.0 - dark) / 0.3, 1.0);
  float covered = mix(dark, depositedAt(paper, dark), rough);
  vec4 drawn = mix(paperColor, charcoalColor, covered);
  return vec4(drawn.rgb, drawn.a * s.color.a);
}
