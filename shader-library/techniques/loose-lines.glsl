/*{
  "DESCRIPTION": "Draws objects as a quick sketch: three loose strokes follow the silhouettes, creases and borders of the mesh and its suggestive contours, which are where a silhouette would appear if the eye moved a little, and are redrawn a few times a second. The first is close to the edge, the others wander. Strokes are thicker where an object is near or dark, and taper at their ends. Between the lines is a thin wash of the object's color. Where an object is small on screen or has many small parts, strokes are fewer, thinner and closer to their edge.",
  "CREDIT": "Scrim. After Curtis, Loose and Sketchy Animation, SIGGRAPH 1998; edges by McGuire and Hughes, Hardware-Determined Feature Edges, NPAR 2004; DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape, SIGGRAPH 2003",
  "SCRIM_RENAMED": [{ "suggestive": { "TO": "suggestive", "WAS": 0 }, "grain": { "TO": "grain", "WAS": 0 } }],
  "SCRIM_UNREAD": [{ "NAME": "radial", "INPUT": "suggestive", "VALUES": [0] }],
  "CATEGORIES": ["Sketch", "Sketchy", "Lines", "Pencil", "Drawing", "Silhouette", "Crease", "Contour", "Jitter", "Boil", "Wobble", "NPR"],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "edges" }, { "SIDE": "edges" }, { "SIDE": "edges" }],
  "INPUTS": [
    { "NAME": "strokePx", "TYPE": "float", "LABEL": "Stroke", "DOC": "Width of a stroke on screen.", "MIN": 0.5, "MAX": 8.0, "DEFAULT": 2.0, "STEP": 0.5, "UNIT": "px" },
    { "NAME": "loosePx", "TYPE": "float", "LABEL": "Looseness", "DOC": "How far strokes deviate from the edge.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 5.0, "UNIT": "px" },
    { "NAME": "waveM", "TYPE": "float", "LABEL": "Wavelength", "DOC": "Length of the waves of a stroke.", "MIN": 0.005, "MAX": 1.0, "DEFAULT": 0.06, "UNIT": "m" },
    { "NAME": "creaseRad", "TYPE": "float", "LABEL": "Creases from", "DOC": "Angle between two faces from which on their edge is a crease that gets a line.", "MIN": 0.1, "MAX": 3.2, "DEFAULT": 0.7, "UNIT": "rad" },
    { "NAME": "suggestive", "TYPE": "float", "LABEL": "Suggestive contours", "DOC": "How many lines there are where a round surface nearly turns away from the eye, as beside a nose or between muscles: 0 draws none, 1 also the faintest. Meshes with more than 200,000 triangles have none.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.6, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "overshootPx", "TYPE": "float", "LABEL": "Overshoot", "DOC": "How far strokes of creases and borders go beyond their corners.", "MIN": 0.0, "MAX": 40.0, "DEFAULT": 6.0, "IDENTITY": 0.0, "UNIT": "px" },
    { "NAME": "taper", "TYPE": "float", "LABEL": "Taper", "DOC": "How much thinner strokes get towards their ends and where the pressure of the pen is low.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.7, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "grain", "TYPE": "float", "LABEL": "Texture", "DOC": "How much the grain of the paper shows in the strokes, first at their edges.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "depthWeight", "TYPE": "float", "LABEL": "Weight by depth", "DOC": "How much thicker strokes are nearer than 1 m, and thinner farther away.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "lightWeight", "TYPE": "float", "LABEL": "Weight by light", "DOC": "How much thinner strokes are in the light than in the dark.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "rate", "TYPE": "float", "LABEL": "Redraw rate", "DOC": "How many times a second the strokes are redrawn. 0 leaves them as they are.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 4.0, "IDENTITY": 0.0, "UNIT": "Hz" },
    { "NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DOC": "Another seed gives other strokes.", "MIN": 0.0, "MAX": 100.0, "DEFAULT": 1.0, "STEP": 1.0 },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the strokes.", "DEFAULT": [0.12, 0.1, 0.14, 1.0] },
    { "NAME": "washColor", "TYPE": "color", "LABEL": "Wash", "DOC": "Color between the lines. With alpha below 1, what is behind the object shows through.", "DEFAULT": [1.0, 0.98, 0.94, 1.0] },
    { "NAME": "ownColor", "TYPE": "float", "LABEL": "Own color", "DOC": "How much of the object's own color the wash has.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.45, "UNIT": "ratio" },
    { "NAME": "shade", "TYPE": "float", "LABEL": "Shade", "DOC": "How much darker the wash is where there is little light.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.4, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/
#include <light/received>
#include <light/white>
#include <noise/value-3d>

// Strokes of silhouettes have no ends of their own; the pressure of the pen lifts it every few waves.
const float LIFT_WAVES = 2.5;

// A point of the noise that is unique to a stroke and a redraw.
vec3 momentOf(const in int stroke) {
  float drawing = floor(TIME * rate + 0.0001) + seed * 61.0;
  return hash3d(vec3(float(stroke), drawing, 5.0)) * 512.0;
}

// How far a stroke goes beyond its corner: each by another part of the overshoot.
float endPxOf(const in int stroke) {
  return overshootPx * (0.4 + 0.3 * float(stroke));
}

// A stroke is thinner where lines are closer than this many of its widths, down to this part of its width.
const float CLEAR_WIDTHS = 3.0;
const float THINNEST = 0.4;

float depthFactor(const in vec3 position) {
  return mix(1.0, clamp(inversesqrt(max(VIEW_DEPTH(position), 0.01)), 0.4, 2.0), depthWeight);
}

void vertex(inout Vertex v) {
  if (PASSINDEX == 0) return;
  int stroke = PASSINDEX - 1;
  float pixelM = PIXEL_M(v.position);
  float widthPx = strokePx * depthFactor(v.position);
  float roomPx = v.roomM / pixelM;
  // Where lines are closer than a bundle of strokes is wide, the bundle gets narrower: else it would cover the object.
  float room = clamp(roomPx / (loosePx + widthPx), 0.0, 1.0);
  widthPx *= clamp(roomPx / (CLEAR_WIDTHS * widthPx), THINNEST, 1.0);
  // There, one stroke stands for all, and valleys have none.
  bool isSpare = stroke > 0 || (v.crease < 0.0 && !v.contour);
  if (isSpare) widthPx *= smoothstep(0.4, 0.8, room);
  vec3 wander = 2.0 * valueNoise3d(v.rest / waveM + momentOf(stroke)) - 1.0;
  float amplePx = loosePx * room * (stroke == 0 ? 0.2 : 0.6);
  // The first stroke is on the edge; the others deviate from it, away from a silhouette, where the object does not hide them.
  float awayPx = v.contour && stroke > 0 ? 0.4 * loosePx * room * float(stroke) : 0.0;
  v.position += (wander * amplePx + v.outward * awayPx) * pixelM;
  v.widthPx = v.contour || abs(v.crease) >= creaseRad ? widthPx * (1.0 - 0.15 * float(stroke)) : 0.0;
  v.endPx = endPxOf(stroke) * room;
  // Edges have no texture coordinates.
  v.uv.x = room;
}

// Half the width of a stroke at a point, as a part of its full half width.
float widthAt(const in Surface s, const in int stroke) {
  float pressed = valueNoise3d(s.rest / (LIFT_WAVES * waveM) + momentOf(stroke).yzx).x;
  // The first stroke never lifts, so that no silhouette is lost.
  float low = stroke == 0 ? 0.55 : 0.0;
  float pressure = mix(1.0, max(low, smoothstep(0.2, 0.6, pressed)), taper);
  if (s.line.z > 0.0) {
    float beyondM = endPxOf(stroke) * s.uv.x * PIXEL_M(s.position);
    float fromEndM = min(s.line.x, s.line.z - s.line.x) + beyondM;
    float lengthM = min(0.25 * s.line.z, 4.0 * beyondM + waveM) + beyondM;
    pressure *= mix(1.0, clamp(fromEndM / max(lengthM, 0.0001), 0.0, 1.0), taper * 0.8);
  }
  float light = lightReceived(s) / max(min(lightOnWhite(), 1.0), 0.00001);
  return pressure * mix(1.0, 1.0 - 0.5 * smoothstep(0.2, 1.0, light), lightWeight);
}

// Size of the grain of the paper on screen. A pencil rides on its heights.
const float GRAIN_PX = 2.0;

// How much a stroke covers at a distance across it, from -1 to 1: the grain keeps its place on the object and its size on screen.
float grainAt(const in Surface s, const in float across) {
  float octave = -log2(max(PIXEL_M(s.position) * GRAIN_PX, 0.000001));
  float fine = exp2(floor(octave));
  float height = mix(valueNoise3d(s.rest * fine).x, valueNoise3d(s.rest * (2.0 * fine)).y, octave - floor(octave));
  return mix(1.0, smoothstep(0.25, 0.55, height + 0.35 * (1.0 - abs(across))), grain);
}

// Suggestive contours with a smaller derivative, in units of the radius of the mesh, are left out at the full amount; and how much
// larger it must be at a small amount.
const float FAINTEST = 2.0;
const float RANGE = 40.0;

// The ink of suggestive contours: several strokes that deviate from the line like those of edges, by distances in the picture.
float suggestiveInk(const in Surface s) {
  float change = length(vec2(dFdx(s.radial.x), dFdy(s.radial.x)));
  float facing = max(dot(s.normal, s.towardsEye), 0.05);
  float least = FAINTEST * pow(RANGE, 1.0 - suggestive);
  // Strokes get thinner and end where the derivative falls to the threshold.
  float strength = smoothstep(least, 1.8 * least, s.radial.y / facing);
  float fromLinePx = s.radial.x / max(change, 0.000001);
  float ink = 0.0;
  for (int stroke = 0; stroke < 3; stroke++) {
    vec3 wander = 2.0 * valueNoise3d(s.rest / waveM + momentOf(stroke)) - 1.0;
    float acrossPx = fromLinePx + wander.x * loosePx * (stroke == 0 ? 0.2 : 0.6);
    float halfPx = 0.5 * strokePx * depthFactor(s.position) * (1.0 - 0.15 * float(stroke)) * widthAt(s, stroke) * mix(1.0, strength, taper);
    float covered = clamp(halfPx - abs(acrossPx) + 0.5, 0.0, 1.0) * min(2.0 * halfPx, 1.0);
    ink = max(ink, covered * (1.0 - 0.2 * float(stroke)) * grainAt(s, acrossPx / max(halfPx, 0.5)));
  }
  return suggestive > 0.0 ? ink * min(2.0 * strength, 1.0) : 0.0;
}

vec4 surface(const in Surface s) {
  if (PASSINDEX == 0) {
    float brightest = max(min(lightOnWhite(), 1.0), 0.00001);
    float light = smoothstep(0.05, 0.75, lightReceived(s) / brightest);
    vec3 wash = mix(vec3(1.0), s.color.rgb, ownColor) * washColor.rgb * mix(1.0 - shade, 1.0, light) * brightest;
    float ink = suggestiveInk(s);
    return vec4(mix(wash, inkColor.rgb, ink * inkColor.a), mix(washColor.a, 1.0, ink * inkColor.a) * s.color.a);
  }
  int stroke = PASSINDEX - 1;
  if (abs(s.line.y) > widthAt(s, stroke)) discard;
  return vec4(inkColor.rgb, inkColor.a * s.color.a * (1.0 - 0.2 * float(stroke)) * grainAt(s, s.line.y));
}
