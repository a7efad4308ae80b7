/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Shape mask",
  "DESCRIPTION": "Draws a rectangle, an ellipse or a polygon as a mask: white inside, transparent outside. Connect it to a Mask or Matte node to show a layer, or to apply a filter, in this region only. Lengths are fractions of the height of the layer, so circles are round in images of every shape. In headsets, the shape is at the same place in the image of each eye.",
  "CREDIT": "Scrim. Distances to a box and to a polygon: I. Quilez, 2D distance functions. Distance to an ellipse: 0xfaded 2017, Simple method for distance to ellipse",
  "CATEGORIES": ["Mask", "Matte", "Rectangle", "Rounded rectangle", "Box", "Square", "Ellipse", "Circle", "Oval", "Polygon", "Triangle", "Hexagon", "Garbage matte", "Region", "Crop", "Feather", "Spotlight"],
  "INPUTS": [
    { "NAME": "shape", "TYPE": "long", "LABEL": "Shape", "DOC": "The shape to draw. A rectangle with a corner radius is a rounded rectangle.", "VALUES": [0, 1, 2], "LABELS": ["Rectangle", "Ellipse", "Polygon"], "DEFAULT": 0 },
    { "NAME": "center", "TYPE": "point2D", "LABEL": "Center", "DOC": "Middle of the shape: (0, 0) is the bottom left of the image, (1, 1) the top right.", "MIN": [-1.0, -1.0], "MAX": [2.0, 2.0], "DEFAULT": [0.5, 0.5], "HANDLE": "center" },
    { "NAME": "size", "TYPE": "point2D", "LABEL": "Size", "DOC": "Width and height before the rotation, as fractions of the height of the layer. Of a polygon: those of the ellipse through its corners.", "MIN": [0.0, 0.0], "MAX": [4.0, 4.0], "DEFAULT": [0.5, 0.5], "UNIT": "ratio", "HANDLE": "size" },
    { "NAME": "rotation", "TYPE": "float", "LABEL": "Rotation", "DOC": "Rotation about the center, counterclockwise.", "MIN": -6.2831853, "MAX": 6.2831853, "DEFAULT": 0.0, "UNIT": "rad", "HANDLE": "angle" },
    { "NAME": "corner", "TYPE": "float", "LABEL": "Corner radius", "DOC": "Radius of the corners of a rectangle, as a fraction of the height of the layer; at most half of the shorter side.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" },
    { "NAME": "sides", "TYPE": "long", "LABEL": "Sides", "DOC": "Number of sides of a polygon. One corner is at the top.", "MIN": 3, "MAX": 12, "DEFAULT": 6 },
    { "NAME": "feather", "TYPE": "float", "LABEL": "Feather", "DOC": "Width of the soft edge, as a fraction of the height of the layer; half of it is outside the shape. At 0 the edge is one pixel wide.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio", "HANDLE": "feather" },
    { "NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DOC": "White outside and transparent inside.", "DEFAULT": false }
  ]
}*/

const float TAU = 6.283185307;
const int MAX_SIDES = 12;

// Half of the least size: safe to divide by.
const float LEAST = 0.0001;

// The distances are signed, negative inside, for half of the width and height.

float distanceToBox(vec2 p, vec2 extent, float radius) {
  float r = min(radius, min(extent.x, extent.y));
  vec2 q = abs(p) - extent + r;
  return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - r;
}

// Three steps towards the nearest point, along circles that fit the ellipse where it is approached.
float distanceToEllipse(vec2 p, vec2 extent) {
  vec2 q = abs(p);
  vec2 squares = extent * extent;
  vec2 toward = vec2(sqrt(0.5));
  for (int i = 0; i < 3; i++) {
    vec2 middle = vec2(squares.x - squares.y, squares.y - squares.x) * toward * toward * toward / extent;
    vec2 away = q - middle;
    float far = max(length(away), LEAST * LEAST);
    vec2 nearest = middle + away / far * length(extent * toward - middle);
    toward = clamp(nearest / extent, 0.0, 1.0) + vec2(LEAST * LEAST);
    toward /= length(toward);
  }
  return distance(q, extent * toward) * (dot(q / extent, q / extent) < 1.0 ? -1.0 : 1.0);
}

// Clockwise from the corner at the top.
vec2 cornerAt(int i, vec2 extent) {
  float turn = TAU * float(i) / float(sides);
  return extent * vec2(sin(turn), cos(turn));
}

float distanceToPolygon(vec2 p, vec2 extent) {
  float nearest = dot(p, p) + 64.0;
  bool inside = true;
  vec2 from = cornerAt(0, extent);
  for (int i = 1; i <= MAX_SIDES; i++) {
    if (i > sides) break;
    vec2 to = cornerAt(i, extent);
    vec2 side = to - from;
    vec2 away = p - from;
    vec2 apart = away - side * clamp(dot(away, side) / dot(side, side), 0.0, 1.0);
    nearest = min(nearest, dot(apart, apart));
    inside = inside && side.x * away.y < side.y * away.x;
    from = to;
  }
  return sqrt(nearest) * (inside ? -1.0 : 1.0);
}

void main() {
  vec2 fromCenter = (isf_FragNormCoord - center) * RENDERSIZE / RENDERSIZE.y;
  float c = cos(rotation);
  float s = sin(rotation);
  vec2 p = vec2(c * fromCenter.x + s * fromCenter.y, c * fromCenter.y - s * fromCenter.x);
  vec2 extent = max(0.5 * size, vec2(LEAST));
  float away = 0.0;
  if (shape == 0) away = distanceToBox(p, extent, corner);
  else if (shape == 1) away = distanceToEllipse(p, extent);
  else away = distanceToPolygon(p, extent);
  float soft = max(feather, 1.0 / RENDERSIZE.y);
  // A shape that is thinner than its edge fades, and is gone at size 0.
  float shown = smoothstep(0.5, -0.5, away / soft) * min(min(size.x, size.y) / soft, 1.0);
  gl_FragColor = vec4(vec3(1.0), invert ? 1.0 - shown : shown);
}
