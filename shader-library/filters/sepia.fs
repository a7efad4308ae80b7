/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Tints an image brown, like an old photograph. Full strength equals the sepia filter of CSS and SVG.",
  "CREDIT": "Scrim. Matrix: W3C Filter Effects Module Level 1, sepia()",
  "CATEGORIES": ["Color", "Style", "Vintage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to tint." },
    { "NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DOC": "0 leaves the image unchanged, 1 is full sepia.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/

// Rows for red, green and blue, at full strength, for display-referred colors, as W3C defines the filter.
const vec3 RED = vec3(0.393, 0.769, 0.189);
const vec3 GREEN = vec3(0.349, 0.686, 0.168);
const vec3 BLUE = vec3(0.272, 0.534, 0.131);

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec3 sepia = vec3(dot(color.rgb, RED), dot(color.rgb, GREEN), dot(color.rgb, BLUE));
  gl_FragColor = vec4(mix(color.rgb, sepia, amount), color.a);
}
