/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "LUT",
  "DESCRIPTION": "Grades a layer with a color lookup table (LUT). Drop a .cube file on the canvas to import its table as an image. Table images of other programs work too: one row of squares, or eight rows of eight.",
  "CREDIT": "Scrim. Tables: Adobe, Cube LUT Specification 1.0",
  "CATEGORIES": ["Color", "Grading", "Color correction", "Color table", "Look", "Film", "Cube"],
  "SCRIM_FIT": "stretch",
  "SCRIM_DEPTH": "same",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to grade." },
    { "NAME": "table", "TYPE": "image", "LABEL": "Table", "DOC": "The table as an image of squares: red to the right, green downwards, blue from square to square." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "Strength of the effect: 0 leaves the layer unchanged.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "size", "TYPE": "float", "LABEL": "Steps", "DOC": "Side of a square, in pixels.", "MIN": 2.0, "MAX": 64.0, "DEFAULT": 33.0, "STEP": 1.0 },
    { "NAME": "columns", "TYPE": "float", "LABEL": "Squares in a row", "DOC": "Number of squares per row: the same as “Steps” for a table in one row; 8 for a table of 512 × 512 pixels.", "MIN": 1.0, "MAX": 64.0, "DEFAULT": 33.0, "STEP": 1.0 }
  ]
}*/

// Within a square, texture filtering interpolates. The rows of the table start at the top; texture coordinates start at the bottom.
vec3 square(float blue, vec2 redGreen, vec2 sizePx) {
  vec2 corner = vec2(mod(blue, columns), floor((blue + 0.5) / columns)) * size;
  vec2 px = corner + redGreen * (size - 1.0) + 0.5;
  return IMG_NORM_PIXEL(table, vec2(px.x / sizePx.x, 1.0 - px.y / sizePx.y)).rgb;
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec2 sizePx = vec2(columns, ceil(size / columns)) * size;
  float blue = clamp(color.b, 0.0, 1.0) * (size - 1.0);
  float below = min(floor(blue), size - 2.0);
  vec2 redGreen = clamp(color.rg, 0.0, 1.0);
  vec3 graded = mix(square(below, redGreen, sizePx), square(below + 1.0, redGreen, sizePx), blue - below);
  gl_FragColor = vec4(mix(color.rgb, graded, amount), color.a);
}
