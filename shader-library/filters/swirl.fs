/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Twists an image around a point: most at the center, less with distance.",
  "CREDIT": "Scrim. Falloff: as swirl() in scikit-image",
  "CATEGORIES": ["Distort", "Twirl", "Twist", "Warp"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to twist." },
    { "NAME": "center", "TYPE": "point2D", "LABEL": "Center", "DOC": "Center of the twist: (0, 0) is the bottom left of the image, (1, 1) the top right.", "MIN": [0.0, 0.0], "MAX": [1.0, 1.0], "DEFAULT": [0.5, 0.5], "HANDLE": "center" },
    { "NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DOC": "Rotation at the center. Positive is counter-clockwise.", "MIN": -18.849556, "MAX": 18.849556, "DEFAULT": 4.712389, "IDENTITY": 0.0, "UNIT": "rad", "HANDLE": "angle" },
    { "NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DOC": "Distance from the center, in pixels of the layer, at which the rotation has dropped to a thousandth of the angle.", "MIN": 1.0, "MAX": 2000.0, "DEFAULT": 400.0, "UNIT": "px", "HANDLE": "extent" }
  ]
}*/

// From the center to the radius the angle is halved ten times.
const float HALVINGS = 10.0;

void main() {
  vec2 middle = center * RENDERSIZE;
  vec2 from = isf_FragNormCoord * RENDERSIZE - middle;
  float turn = -angle * exp2(-HALVINGS * length(from) / max(radius, 1.0));
  float c = cos(turn);
  float s = sin(turn);
  vec2 source = middle + vec2(c * from.x - s * from.y, s * from.x + c * from.y);
  gl_FragColor = IMG_NORM_PIXEL(inputImage, source / RENDERSIZE);
}
