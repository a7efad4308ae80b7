/*{
  "DESCRIPTION": "Draws objects as brick walls: rows of bricks in half bond with mortar joints and rounded edges. The bricks follow the local axes of the object and stay in place as it moves. On round objects, the walls and the top meet in a joint.",
  "CREDIT": "Scrim. After the brick shader of Rost, OpenGL Shading Language, 2004, chapter 6; bump: Mikkelsen, Bump Mapping Unparametrized Surfaces on the GPU, 2010",
  "CATEGORIES": ["Wall", "Stone", "Masonry", "Mortar", "Procedural", "Texture", "Building"],
  "INPUTS": [
    { "NAME": "brickM", "TYPE": "point2D", "LABEL": "Brick", "DOC": "Length and height of a brick including its mortar, in meters.", "MIN": [0.002, 0.002], "MAX": [2.0, 1.0], "DEFAULT": [0.064, 0.024], "UNIT": "m" },
    { "NAME": "mortarM", "TYPE": "float", "LABEL": "Mortar", "DOC": "Width of the joints between bricks.", "MIN": 0.0, "MAX": 0.1, "DEFAULT": 0.004, "STEP": 0.001, "UNIT": "m" },
    { "NAME": "brickColor", "TYPE": "color", "LABEL": "Brick color", "DOC": "Color of the bricks.", "DEFAULT": [0.58, 0.28, 0.21, 1.0] },
    { "NAME": "mortarColor", "TYPE": "color", "LABEL": "Mortar color", "DOC": "Color of the joints.", "DEFAULT": [0.78, 0.74, 0.68, 1.0] },
    { "NAME": "ownColor", "TYPE": "float", "LABEL": "Own color", "DOC": "How much of the object's own color the bricks have.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "variation", "TYPE": "float", "LABEL": "Variation", "DOC": "How much the bricks differ from each other, and how rough they are.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "bump", "TYPE": "float", "LABEL": "Depth", "DOC": "How far the bricks stand out from the mortar, as a fraction of its width.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.5, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/
#include <light/diffuse>
#include <noise/value-3d>
#include <bump/perturb-normal>

// The position of a point within its row of the wall, in meters: x along the row, y up.
vec2 inBrick(const in vec2 wall) {
  float row = floor(wall.y / brickM.y);
  float shift = mod(row, 2.0) * 0.5 * brickM.x;
  return vec2(wall.x + shift, wall.y) - vec2(floor((wall.x + shift) / brickM.x), row) * brickM;
}

// 1 on a brick, 0 in the mortar, with a transition over `edgeM` at its border.
float onBrick(const in vec2 wall, const in float edgeM) {
  vec2 at = inBrick(wall);
  vec2 toBorder = min(at, brickM - at) - 0.5 * mortarM;
  vec2 inside = clamp(toBorder / edgeM + 0.5, 0.0, 1.0);
  return inside.x * inside.y;
}

// 0 in the joint between a wall and the top, where the surface faces both sides of the bounding box equally, 1 beside it. `faces` is the
// absolute normal.
float besideTop(const in vec3 faces, const in float pixelM) {
  // The rows of the other two sides are at the same heights.
  vec2 apart = faces.xz - faces.y;
  vec2 change = sqrt(dFdx(apart) * dFdx(apart) + dFdy(apart) * dFdy(apart));
  // A flat face has no joint.
  vec2 awayM = abs(apart) / max(change, 0.00001) * pixelM;
  vec2 beside = clamp((awayM - 0.5 * mortarM) / pixelM + 0.5, 0.0, 1.0);
  return faces.x > faces.z ? beside.x : beside.y;
}

vec4 surface(const in Surface s) {
  // The wall is the side of the bounding box that the surface faces most. Slopes belong to the walls up to 52 degrees from the vertical:
  // rows that are 1.6 times as high there disturb less than small patches of the top.
  vec3 faces = abs(s.restNormal) * vec3(1.0, 0.78, 1.0);
  bool isTop = faces.y > max(faces.x, faces.z);
  bool isEnd = !isTop && faces.x > faces.z;
  vec3 along = isEnd ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 up = isTop ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
  vec2 wall = vec2(dot(s.rest, along), dot(s.rest, up));
  float pixelM = max(length(fwidth(s.rest)), 0.000001);

  // The rows of a wall and of the top have different directions.
  float brick = onBrick(wall, pixelM) * besideTop(faces, pixelM);
  // From far away, joints and roughness are below a pixel, and their mean remains.
  float near = clamp(0.5 * mortarM / pixelM, 0.0, 1.0);
  vec2 id = vec2(floor((wall.x + mod(floor(wall.y / brickM.y), 2.0) * 0.5 * brickM.x) / brickM.x), floor(wall.y / brickM.y));
  vec3 random = hash3d(vec3(id, isTop ? 11.0 : isEnd ? 7.0 : 3.0));
  float grain = valueNoise3d(s.rest * (6.0 / brickM.y)).x * 0.6 + valueNoise3d(s.rest * (19.0 / brickM.y)).y * 0.4;

  vec3 clay = mix(brickColor.rgb, s.color.rgb, ownColor) * (1.0 + variation * (0.9 * random.x - 0.5));
  clay *= vec3(1.0, 1.0 + variation * 0.3 * (random.y - 0.5), 1.0 + variation * 0.5 * (random.z - 0.5));
  clay *= 1.0 - variation * 0.5 * near * (grain - 0.4);
  vec3 joint = mortarColor.rgb * (1.0 - 0.3 * variation * near * grain);
  vec3 color = mix(joint, clay, brick);

  float heightM = bump * mortarM;
  float roundM = max(0.6 * mortarM, 0.000001);
  float apartM = 0.1 * roundM;
  vec2 slope = vec2(
    onBrick(wall + vec2(apartM, 0.0), roundM) - onBrick(wall - vec2(apartM, 0.0), roundM),
    onBrick(wall + vec2(0.0, apartM), roundM) - onBrick(wall - vec2(0.0, apartM), roundM)) * (heightM / (2.0 * apartM));
  vec3 rough = (valueNoise3d(s.rest * (9.0 / brickM.y)) - 0.5) * (0.7 * variation * bump);
  vec3 normal = perturbNormal(s, near * (along * slope.x + up * slope.y + rough));
  // Joints are deeper and get less light.
  float sunk = mix(1.0 - 0.4 * bump, 1.0, brick);
  return vec4(color * diffuseLight(normal) * sunk, s.color.a);
}
