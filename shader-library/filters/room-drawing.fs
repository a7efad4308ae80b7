/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Room drawing",
  "DESCRIPTION": "Draws the camera video as hatching or charcoal whose strokes lie on the real surfaces: they stay on the table as the visitor walks around it, and keep their width on screen. Shadows and virtual objects in the layer get strokes, too. Needs room depth.",
  "CREDIT": "Scrim. Strokes of all sizes: E. Praun, H. Hoppe, M. Webb and A. Finkelstein 2001, Real-Time Hatching. Charcoal: A. Majumder and M. Gopi 2002, Hardware Accelerated Real Time Charcoal Rendering",
  "CATEGORIES": ["Style", "Drawing", "Hatching", "Charcoal", "Sketch", "NPR", "World space", "Coherent", "Anchored"],
  "SCRIM_ALPHA": "premultiplied",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to draw, such as the camera video." },
    { "NAME": "room", "TYPE": "depth", "LABEL": "Room depth", "DOC": "Distance to the real surfaces that carry the strokes. Where it is unknown, the tone is a wash without strokes." },
    { "NAME": "medium", "TYPE": "long", "LABEL": "Medium", "DOC": "Hatching: thin strokes of ink. Charcoal: broad strokes with grain.", "VALUES": [0, 1], "LABELS": ["Hatching", "Charcoal"], "DEFAULT": 0 },
    { "NAME": "spacingPx", "TYPE": "float", "LABEL": "Stroke distance", "DOC": "Distance between strokes on screen, in pixels of the layer.", "MIN": 3.0, "MAX": 40.0, "DEFAULT": 8.0, "UNIT": "px" },
    { "NAME": "turn", "TYPE": "float", "LABEL": "Direction", "DOC": "Angle of the first strokes on each surface.", "MIN": -3.1415927, "MAX": 3.1415927, "DEFAULT": 0.7, "UNIT": "rad" },
    { "NAME": "brightness", "TYPE": "float", "LABEL": "Brightness", "DOC": "Lightens or darkens the drawing.", "MIN": -1.0, "MAX": 1.0, "DEFAULT": 0.2, "UNIT": "ratio" },
    { "NAME": "lines", "TYPE": "float", "LABEL": "Outlines", "DOC": "Strength of lines along edges of the room. 0 draws none.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.8, "UNIT": "ratio" },
    { "NAME": "smoothPx", "TYPE": "float", "LABEL": "Smoothing", "DOC": "Distance over which the directions of surfaces are smoothed, in pixels of the layer. Noisy depth needs more.", "MIN": 2.0, "MAX": 24.0, "DEFAULT": 6.0, "UNIT": "px" },
    { "NAME": "ownColor", "TYPE": "float", "LABEL": "Own color", "DOC": "How much of the layer's own color the paper has.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "inkColor", "TYPE": "color", "LABEL": "Ink", "DOC": "Color of the strokes.", "DEFAULT": [0.09, 0.08, 0.12, 1.0] },
    { "NAME": "paperColor", "TYPE": "color", "LABEL": "Paper", "DOC": "Color between the strokes.", "DEFAULT": [0.97, 0.95, 0.9, 1.0] }
  ],
  "PASSES": [
    { "TARGET": "facets", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Gradient of the inverse depth of each surface, at half size." },
    { "TARGET": "surfaces", "FLOAT": true, "WIDTH": "ceil($WIDTH / 2)", "HEIGHT": "ceil($HEIGHT / 2)", "DESCRIPTION": "Smooths it within each surface." },
    { "DESCRIPTION": "Draws strokes on the surfaces, and lines along their edges." }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);
const int CHARCOAL = 1;

// The smallest distance between strokes, meters. All others are it times a power of two.
const float FINEST_M = 0.0009765625;

// Length of a stroke and offset from its place, in distances between strokes.
const float LENGTH = 14.0;
const float OFFSET = 0.22;

// How gradually strokes end, as a share of their noise.
const float TAPER = 0.1;

// Size of the finest grain of charcoal, in distances between strokes.
const float GRAIN = 0.22;

// Angle between the strokes of light and of dark tones, radians.
const float CROSSING = 1.1;

// Neighbors on either side that are smoothed, in steps of half the smoothing distance.
const int REACH = 2;

// Neighbors whose inverse depth differs from the plane by this share belong to another surface.
const float SAME_SURFACE = 0.02;

// Change of slope, relative to the slope, at which lines begin and are full. A corner of a cube seen from the front has about 2.
const vec2 EDGE = vec2(0.4, 0.7);

// Above this, a change of slope is the far side of a jump in depth.
const float JUMP = 8.0;

// A prime p for which 3 does not divide p - 1, so that cubes permute the integers below it. Squares of numbers below 2 p are exact.
const float PERIOD = 509.0;

// The steepest surface that strokes follow, as the cosine of its angle to the ray.
const float LEAST_COSINE = 0.12;

// Power of the normal that is the share of a side, and what is taken off it: within 35° of an axis, a surface has one side. None has no side.
const float SIDE_POWER = 8.0;
const float SIDE_LEAST = 0.012;

// Of a share of the strokes, those remain whose cover is above this power of it: strokes of two sides cover as much together as those of one.
const float SHARE_POWER = 0.5;

// How far a normal leans from the vertical, as a sine, where the strokes of a level surface begin to turn to those of the wall that it leans to,
// and have done so. They turn in this many steps.
const vec2 LEANING = vec2(0.25, 0.65);
const float DIRECTIONS = 8.0;

const float PI = 3.14159265;

#ifdef SCRIM
float metersAt(vec2 uv) { return ROOM_DEPTH(room, uv); }
mat4 projection() { return SCRIM_CLIP_FROM_VIEW; }
mat4 pose() { return SCRIM_WORLD_FROM_VIEW; }
#else
float metersAt(vec2 uv) { return 0.0; }
mat4 projection() { return mat4(1.0); }
mat4 pose() { return mat4(1.0); }
#endif

// 1 / m; 0 where the depth is unknown, and outside of the view.
float inverseAt(vec2 uv) {
  if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return 0.0;
  float m = metersAt(uv);
  return m > 0.0 ? 1.0 / m : 0.0;
}

// The point at 1 m along the view axis, view space: the ray through a pixel is (x, y, -1).
vec2 rayAt(vec2 uv) {
  mat4 p = projection();
  return (uv * 2.0 - 1.0 + p[2].xy) / vec2(p[0].x, p[1].y);
}

// Over a plane the inverse depth is an affine function of the ray, so its differences are exact there. Of the differences to both sides the
// smaller one is taken: the larger one crosses an edge.
float slope(float here, float before, float after, float stepRay) {
  float left = before > 0.0 ? here - before : 1e6;
  float right = after > 0.0 ? after - here : 1e6;
  float smaller = abs(left) < abs(right) ? left : right;
  return abs(smaller) < 1e5 ? smaller / stepRay : 0.0;
}

// (gradient by the ray, inverse depth, 1), or 0 where the depth is unknown.
vec4 facetAt(vec2 uv) {
  vec2 stepUv = smoothPx / (2.0 * RENDERSIZE);
  float here = inverseAt(uv);
  if (here == 0.0) return vec4(0.0);
  vec2 stepRay = rayAt(uv + stepUv) - rayAt(uv);
  float x = slope(here, inverseAt(uv - vec2(stepUv.x, 0.0)), inverseAt(uv + vec2(stepUv.x, 0.0)), stepRay.x);
  float y = slope(here, inverseAt(uv - vec2(0.0, stepUv.y)), inverseAt(uv + vec2(0.0, stepUv.y)), stepRay.y);
  return vec4(x, y, here, 1.0);
}

// The mean over the neighbors that lie on the plane of this pixel.
vec4 smoothedAt(vec2 uv) {
  vec4 here = IMG_NORM_PIXEL(facets, uv);
  if (here.w == 0.0) return here;
  vec2 ray = rayAt(uv);
  vec4 sum = vec4(0.0);
  for (int y = -REACH; y <= REACH; y++) {
    for (int x = -REACH; x <= REACH; x++) {
      vec2 at = uv + vec2(float(x), float(y)) * smoothPx / (4.0 * RENDERSIZE);
      vec4 there = IMG_NORM_PIXEL(facets, at);
      if (there.w < 1.0) continue;
      vec2 toHere = ray - rayAt(at);
      // What the neighbor's plane and this one say of each other.
      float byThere = there.z + dot(there.xy, toHere);
      float byHere = here.z - dot(here.xy, toHere);
      float apart = max(abs(byThere - here.z), abs(byHere - there.z)) / here.z;
      float weight = exp(-apart * apart / (2.0 * SAME_SURFACE * SAME_SURFACE));
      sum += weight * vec4(there.xy, byThere, 1.0);
    }
  }
  return sum.w > 0.0 ? sum / sum.w : here;
}

// An integer modulo PERIOD. Adding one half compensates for rounding of the quotient.
float wrap(float whole) {
  return whole - PERIOD * floor((whole + 0.5) / PERIOD);
}

// A permutation of the integers below PERIOD, for noise. Nested, the quadratic ones modulo 289 of McEwan et al. 2012 and of Gustavson and
// McEwan 2022 repeat after 24 and 38 pixels along a line, because they are linear modulo 17.
float permute(float x) {
  return wrap(wrap(x * x) * x);
}

// A number from 0 to 1 for two whole numbers.
float randomOf(float at, float seed) {
  return permute(permute(wrap(seed)) + wrap(at)) / PERIOD;
}

// Smooth noise from 0 to 1 along a line.
float noiseAlong(float at, float line) {
  float first = floor(at);
  float part = at - first;
  part *= part * (3.0 - 2.0 * part);
  return mix(randomOf(first, line), randomOf(first + 1.0, line), part);
}

// Smooth noise from 0 to 1 over a plane.
float noiseOver(vec2 at, float seed) {
  float first = floor(at.y);
  float part = at.y - first;
  part *= part * (3.0 - 2.0 * part);
  return mix(noiseAlong(at.x, first + seed), noiseAlong(at.x, first + 1.0 + seed), part);
}

// Ink of parallel strokes at a point of a plane, meters, whose strokes run along y. A pixel covers `pixelM` across the strokes. Every second
// stroke fades out before the distance between strokes doubles, so that strokes keep their place at all distances. `part` of the cover is drawn.
float strokesAt(vec2 at, float pixelM, float cover, float part, float width, float seed) {
  float level = max(log2(max(spacingPx * pixelM, FINEST_M) / FINEST_M), 0.0);
  float octave = floor(level);
  float fading = level - octave;
  float spacing = FINEST_M * exp2(octave);
  float grainM = spacing * GRAIN;
  float ink = 0.0;
  float nearest = floor(at.x / spacing + 0.5);
  for (int i = -1; i <= 1; i++) {
    float index = nearest + float(i);
    bool stays = mod(index, 2.0) < 0.5;
    // The same stroke has the same number at all distances.
    float line = index * exp2(octave);
    float grown = stays ? 1.0 + fading : 1.0;
    float center = (index + OFFSET * grown * (2.0 * randomOf(line, seed) - 1.0)) * spacing;
    float along = at.y / (spacing * LENGTH) + randomOf(line, seed + 7.0);
    float gap = noiseAlong(along, line + seed);
    if (stays) gap = mix(gap, noiseAlong(at.y / (2.0 * spacing * LENGTH) + randomOf(line, seed + 7.0), line + seed), fading);
    // A stroke becomes thin toward its ends.
    float pressure = smoothstep(gap - TAPER, gap + TAPER, cover * part * (1.0 + 2.0 * TAPER) - TAPER);
    float presence = min(1.0, 3.0 * pressure) * (stays ? 1.0 : 1.0 - fading);
    float halfWidth = 0.5 * width * spacing * (1.0 + fading) * sqrt(pressure);
    float soft = max(0.75 * pixelM, medium == CHARCOAL ? 0.3 * spacing * (1.0 + fading) : 0.0);
    float away = abs(at.x - center);
    ink = max(ink, presence * (1.0 - smoothstep(halfWidth - soft, halfWidth + soft, away)) * min(1.0, halfWidth / (0.5 * pixelM)));
  }
  if (medium != CHARCOAL) return ink;
  float fine = 0.5 * (noiseOver(at / grainM, seed) + noiseOver(at / (2.0 * grainM), seed));
  float coarse = 0.5 * (noiseOver(at / (2.0 * grainM), seed) + noiseOver(at / (4.0 * grainM), seed));
  float grain = mix(fine, coarse, fading);
  return ink * smoothstep(grain - 0.35, grain + 0.35, cover * 1.2);
}

// What strokes for a darkness from 0 to 1, and strokes that cross them, leave of the paper on a side. `right` and `up` are its axes; the columns of
// `spot` are a place and what one pixel covers to the right and upward, meters. Of a `share` of the strokes each has its full contrast: they come
// and go one by one where the share changes.
float clearOf(mat3 spot, vec3 right, vec3 up, float angle, float share, float darkness, float seed) {
  float clear = 1.0;
  float part = pow(share, SHARE_POWER);
  for (int i = 0; i < 2; i++) {
    vec3 across = right * cos(angle) + up * sin(angle);
    vec3 along = up * cos(angle) - right * sin(angle);
    vec3 on = across * spot;
    float cover = i == 0 ? darkness * 1.7 : (darkness - 0.35) * 1.7;
    float width = medium == CHARCOAL ? mix(0.4, 1.1, darkness) : mix(0.3, 0.75, darkness);
    vec2 at = vec2(on.x, dot(along, spot[0]));
    if (part * cover > 0.0) clear *= 1.0 - strokesAt(at, length(on.yz), min(cover, 1.0), part, width, seed + 101.0 * float(i));
    angle += CROSSING;
  }
  return clear;
}

// Where the ray through `ray` meets the plane through a point with a normal, relative to the point, view space.
vec3 onPlane(vec3 point, vec3 normal, vec2 ray) {
  vec3 direction = vec3(ray, -1.0);
  float cosine = dot(normal, direction);
  float least = LEAST_COSINE * length(direction);
  return direction * (dot(normal, point) / (abs(cosine) < least ? (cosine < 0.0 ? -least : least) : cosine)) - point;
}

// How much the slope of the inverse depth changes here, in any of four directions, from 0 to 1. Where one surface hides another, only the
// nearer one has the line.
float edgeAt(vec2 uv, float here) {
  float most = 0.0;
  float stepPx = max(1.25, 0.2 * smoothPx);
  // At 45° to the view axis, the inverse depth changes by 1 / m per unit of the ray.
  float unit = here * 2.0 * stepPx / (projection()[1].y * RENDERSIZE.y);
  for (int i = 0; i < 4; i++) {
    float angle = float(i) * 0.78539816;
    vec2 away = vec2(cos(angle), sin(angle)) * stepPx / RENDERSIZE;
    float before = inverseAt(uv - away);
    float after = inverseAt(uv + away);
    if (before == 0.0 || after == 0.0) continue;
    float change = (before + after - 2.0 * here) / unit;
    // Relative to the slope: steep surfaces have more error of the sampling.
    if (change < JUMP) most = max(most, abs(change) / (1.0 + abs(after - before) / unit));
  }
  return smoothstep(EDGE.x, EDGE.y, most);
}

// Ink of the strokes on the surface at this pixel.
float surfaceInk(vec2 uv, vec4 surface, float darkness) {
  vec2 ray = rayAt(uv);
  // The plane is gradient · ray + constant = 1 / m.
  vec3 normal = normalize(vec3(surface.xy, -(surface.z - dot(surface.xy, ray))));
  vec3 point = vec3(ray, -1.0) / surface.z;
  vec2 pixelRay = rayAt(uv + 1.0 / RENDERSIZE) - ray;
  mat3 toWorld = mat3(pose());
  vec3 pixelX = onPlane(point, normal, ray + vec2(pixelRay.x, 0.0));
  vec3 pixelY = onPlane(point, normal, ray + vec2(0.0, pixelRay.y));
  mat3 spot = mat3((pose() * vec4(point, 1.0)).xyz, toWorld * pixelX, toWorld * pixelY);
  vec3 outward = -(toWorld * normal);
  vec3 shares = max(pow(abs(outward), vec3(SIDE_POWER)) - SIDE_LEAST, 0.0);
  shares /= shares.x + shares.y + shares.z;
  // Each side is seen from outside, with right and up as they are there. So two walls agree about the direction where they meet.
  vec3 facing = vec3(outward.x < 0.0 ? -1.0 : 1.0, outward.y < 0.0 ? -1.0 : 1.0, outward.z < 0.0 ? -1.0 : 1.0);
  vec3 up = vec3(0.0, 1.0, 0.0);
  float clear = clearOf(spot, vec3(0.0, 0.0, -facing.x), up, turn, shares.x, darkness, 11.0);
  clear *= clearOf(spot, vec3(facing.z, 0.0, 0.0), up, turn, shares.z, darkness, 37.0);
  // A stroke and its opposite are the same, so the mean of the directions of a level surface and of the wall is that of doubled angles.
  vec2 lean = outward.xz;
  vec2 wall = vec2(lean.y * lean.y - lean.x * lean.x, 2.0 * lean.x * lean.y * facing.y) / max(dot(lean, lean), 1e-6);
  vec2 mean = mix(vec2(1.0, 0.0), wall, smoothstep(LEANING.x, LEANING.y, length(lean)));
  float direction = 0.5 * DIRECTIONS / PI * atan(mean.y, mean.x);
  float later = smoothstep(0.0, 1.0, fract(direction));
  for (int i = 0; i < 2; i++) {
    float index = mod(floor(direction) + float(i), DIRECTIONS);
    float share = shares.y * (i == 0 ? 1.0 - later : later);
    clear *= clearOf(spot, vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, -facing.y), turn + index * PI / DIRECTIONS, share, darkness, 23.0 + index);
  }
  return 1.0 - clear;
}

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

void main() {
  vec2 uv = isf_FragNormCoord;
  if (PASSINDEX == 0) {
    gl_FragColor = facetAt(uv);
  } else if (PASSINDEX == 1) {
    gl_FragColor = smoothedAt(uv);
  } else {
    vec4 color = readLayer(uv);
    // Without the noise of single pixels.
    vec2 px = 1.5 / RENDERSIZE;
    vec4 around = readLayer(uv + px) + readLayer(uv - px) + readLayer(uv + vec2(px.x, -px.y)) + readLayer(uv - vec2(px.x, -px.y));
    vec4 mean = 0.2 * (color + around);
    float luma = dot(mean.rgb, LUMA_709) / max(mean.a, 0.001);
    float darkness = clamp(1.0 - pow(clamp(luma, 0.0, 1.0), (1.0 - brightness) / max(1.0 + brightness, 0.001)), 0.0, 1.0);
    vec4 surface = IMG_NORM_PIXEL(surfaces, uv);
    float here = inverseAt(uv);
    // Without depth: the mean tone.
    float ink = surface.w >= 1.0 && here > 0.0 ? surfaceInk(uv, surface, darkness) : 0.8 * darkness;
    if (lines > 0.0 && here > 0.0) ink = max(ink, lines * edgeAt(uv, here));
    vec3 paper = mix(paperColor.rgb, color.rgb / max(color.a, 0.001), ownColor);
    vec4 drawn = mix(vec4(paper, paperColor.a), inkColor, clamp(ink, 0.0, 1.0));
    vec4 result = vec4(drawn.rgb * drawn.a, drawn.a) * color.a;
#ifndef SCRIM
    if (result.a > 0.0) result.rgb /= result.a;
#endif
    gl_FragColor = result;
  }
}
