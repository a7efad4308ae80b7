/*{
  "DESCRIPTION": "Draws objects as pen hatching: darker areas get more strokes. The strokes follow the curvature of the surface, stay on the object and keep their width on screen at any distance.",
  "CREDIT": "Scrim. Praun, Hoppe, Webb, Finkelstein: Real-Time Hatching, SIGGRAPH 2001; directions: Rusinkiewicz, Estimating Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004; Knöppel, Crane, Pinkall, Schröder, Globally Optimal Direction Fields, SIGGRAPH 2013",
  "CATEGORIES": ["Hatch", "Pen", "Ink", "Drawing", "Sketch", "Engraving", "NPR", "Tonal art map"],
  "SCRIM_RENAMED": [{ "mapping": { "TO": "mapping", "WAS": 0 }, "turn": { "TO": "turn", "WAS": 0.6 } }],
  "SCRIM_UNREAD": [{ "NAME": "along", "INPUT": "mapping", "VALUES": [0, 1] }],
  "PASSES": [{ "SIDE": "object" }, { "SIDE": "back" }],
  "IMPORTED": { "lightTones": { "PATH": "pictures/hatching-light.png" }, "darkTones": { "PATH": "pictures/hatching-dark.png" } },
  "INPUTS": [
    { "NAME": "sizeM", "TYPE": "float", "LABEL": "Size", "DOC": "Size of the stroke pattern on the object before it repeats. A larger pattern has longer, wider strokes close up.", "MIN": 0.005, "MAX": 2.0, "DEFAULT": 0.16, "UNIT": "m" },
    { "NAME": "turn", "TYPE": "float", "LABEL": "Angle", "DOC": "Angle of the first strokes to their direction.", "MIN": -3.14159, "MAX": 3.14159, "DEFAULT": 0.0, "UNIT": "rad" },
    { "NAME": "mapping", "TYPE": "long", "LABEL": "Mapping", "DOC": "The direction of strokes. Curvature: that in which the surface bends most, smoothed over the model at rest; level where nothing bends and on meshes with more than 200,000 triangles. Level: along cuts of the object nearly parallel to its floor. Picture coordinates: as the texture coordinates (UV) of the model.", "VALUES": [2, 0, 1], "LABELS": ["Curvature", "Level", "Picture coordinates"], "DEFAULT": 2 },
    { "NAME": "brightness", "TYPE": "float", "LABEL": "Brightness", "DOC": "Lightens or darkens the drawing.", "MIN": -1.0, "MAX": 1.0, "DEFAULT": 0.05, "UNIT": "ratio" },
    { "NAME": "ownTone", "TYPE": "float", "LABEL": "Own tone", "DOC": "How much dark colors of the object add strokes.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the strokes.", "DEFAULT": [0.09, 0.08, 0.12, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the strokes. With less opacity what is behind the object shows through.", "DEFAULT": [0.97, 0.95, 0.9, 1.0] },
    { "NAME": "ownColor", "TYPE": "float", "LABEL": "Own color", "DOC": "How much of the object's own color the ink has.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "linePx", "TYPE": "float", "LABEL": "Outline", "DOC": "Width of the outline on screen. 0 turns it off.", "MIN": 0.0, "MAX": 12.0, "DEFAULT": 1.5, "IDENTITY": 0.0, "STEP": 0.5, "UNIT": "px" }
  ]
}*/
#include <light/received>

void vertex(inout Vertex v) {
  if (PASSINDEX == 1) v.position += v.outward * (linePx * PIXEL_M(v.position));
}

// The level direction of the direction field, too.
const vec3 LEVEL_AXIS = vec3(0.12, 1.0, 0.16);

// The part of the paper that the darkest tone of the map covers. Several layers of strokes together cover no more.
const float DARKEST = 0.8;

// Strokes have this many directions, and between two of them both.
const int DIRECTIONS = 8;

vec2 turned(const in vec2 place, const in float angle) {
  return mat2(cos(angle), -sin(angle), sin(angle), cos(angle)) * place;
}

// The ink of the tonal art map at a point, for a darkness from 0 (white) to 6: a blend of the two nearest tones. `level` is the
// mip level, which is the size of the map on screen.
float inkAt(const in vec2 place, const in float darkness, const in float level) {
  vec3 light = 1.0 - textureLod(lightTones, place, level).rgb;
  vec3 dark = 1.0 - textureLod(darkTones, place, level).rgb;
  vec3 lightWeights = max(1.0 - abs(darkness - vec3(1.0, 2.0, 3.0)), 0.0);
  vec3 darkWeights = max(1.0 - abs(darkness - vec3(4.0, 5.0, 6.0)), 0.0);
  return dot(light, lightWeights) + dot(dark, darkWeights);
}

// The mip level of the map at a point that all pixels compute: the point may jump where strokes have another direction.
float levelOf(const in vec2 place) {
  vec2 dx = dFdx(place);
  vec2 dy = dFdy(place);
  return 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1e-12)) + log2(float(textureSize(lightTones, 0).x));
}

// The darkness at which the mean ink of the map is `covered`; the tones of its pictures are those of `make-tonal-art-maps`.
float darknessOf(const in float covered) {
  vec3 light = clamp((covered - vec3(0.0, 0.1, 0.22)) / vec3(0.1, 0.12, 0.14), 0.0, 1.0);
  vec3 dark = clamp((covered - vec3(0.36, 0.5, 0.65)) / vec3(0.14, 0.15, 0.15), 0.0, 1.0);
  return dot(light + dark, vec3(1.0));
}

// What a share of the strokes leaves of the paper, on one side of the bounding box, so that all shares together cover `wanted`. Strokes
// of a map nest, so they come and go one by one where the share changes.
float clearAt(const in vec2 place, const in vec2 along, const in float share, const in float wanted, const in float level) {
  float sector = atan(along.y, along.x) * (float(DIRECTIONS) / 3.14159265);
  // Each of the two changes its direction where it has no strokes.
  vec2 nearest = vec2(2.0 * floor(0.5 * sector + 0.5), 2.0 * floor(0.5 * sector) + 1.0);
  float odd = smoothstep(0.25, 0.75, abs(sector - nearest.x));
  float clear = 1.0;
  for (int i = 0; i < 2; i++) {
    float part = share * (i == 0 ? 1.0 - odd : odd);
    // A stroke and its opposite are the same.
    float index = mod(i == 0 ? nearest.x : nearest.y, float(DIRECTIONS));
    float angle = index * (3.14159265 / float(DIRECTIONS));
    float darkness = darknessOf(1.0 - pow(1.0 - wanted, part));
    clear *= 1.0 - inkAt(turned(place, angle) + index * vec2(0.37, 0.61), darkness, level);
  }
  return clear;
}

// The ink of strokes along a direction of the surface. They are projected from the sides of the bounding box, and each side turns them so
// that they have the same direction on the surface.
float inkAlong(const in Surface s, const in vec3 along, const in float wanted) {
  vec3 place = s.rest / sizeM;
  vec3 levels = vec3(levelOf(place.zy), levelOf(place.xz), levelOf(place.xy));
  // The smooth normal hides the triangles; the true one leaves out sides on which strokes would be long smears.
  vec3 shares = (pow(abs(s.smoothNormal), vec3(6.0)) + 0.001) * smoothstep(0.2, 0.5, abs(s.restNormal));
  // A face whose normal is that of a corner of the box belongs to one side more than to another, not to none.
  shares += vec3(2e-4, 1e-4, 0.0);
  // The third side has no share left.
  shares -= min(shares.x, min(shares.y, shares.z));
  float all = shares.x + shares.y + shares.z;
  shares = all > 0.0 ? shares / all : vec3(0.0, 1.0, 0.0);
  bool hasX = shares.x > 0.0;
  bool hasZ = shares.z > 0.0;
  float first = clearAt(hasX ? place.zy : place.xz, hasX ? along.zy : along.xz, hasX ? shares.x : shares.y, wanted, hasX ? levels.x : levels.y);
  float second = clearAt(hasZ ? place.xy : place.xz, hasZ ? along.xy : along.xz, hasZ ? shares.z : hasX ? shares.y : 0.0, wanted, hasZ ? levels.z : levels.y);
  return 1.0 - first * second;
}

vec4 surface(const in Surface s) {
  vec3 ink = mix(inkColor.rgb, s.color.rgb * 0.5, ownColor);
  if (PASSINDEX == 1) {
    if (linePx <= 0.0) discard;
    return vec4(ink, inkColor.a * s.color.a);
  }
  float own = dot(s.color.rgb, vec3(0.2126, 0.7152, 0.0722));
  // The eye averages strokes and paper in linear light, so the part of paper is the luminance that a white surface has in this light.
  float lit = lightReceived(s) * mix(1.0, pow(own, 0.45), ownTone);
  float tone = pow(lit, (1.0 - brightness) / max(1.0 + brightness, 0.001));

  float covered;
  if (mapping == 1) {
    covered = inkAt(turned(s.uv * 3.0, turn), darknessOf(1.0 - tone), levelOf(s.uv * 3.0));
  } else {
    // Without a curvature, strokes run along level cuts of the object; the axis is that of no face of most models.
    vec3 along = mapping == 2 ? s.along : cross(LEVEL_AXIS, s.smoothNormal);
    along -= s.restNormal * dot(along, s.restNormal);
    vec3 across = cross(s.restNormal, along);
    covered = inkAlong(s, along * cos(turn) + across * sin(turn), min(1.0 - tone, DARKEST));
  }
  // The darkest tone of the map leaves a fifth of the paper, which closes in still darker ones.
  covered = mix(covered, 1.0, clamp(1.0 - tone / 0.2, 0.0, 1.0));
  vec4 drawn = mix(paperColor, vec4(ink, inkColor.a), clamp(covered, 0.0, 1.0));
  return vec4(drawn.rgb, drawn.a * s.color.a);
}
