/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Fades the image into fog with distance. It uses the depth of the layer, or of the room where the layer has none.",
  "CREDIT": "Scrim. Formulas: those of OpenGL 1.0 §3.10, set by the distance at which 95 % is hidden",
  "CATEGORIES": ["Depth", "Fog", "Mist", "Haze", "Atmosphere"],
  "SCRIM_DEPTH": "same",
  "SCRIM_ENCODING": "either",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to add fog to, with depth." },
    { "NAME": "room", "TYPE": "depth", "LABEL": "Room depth", "DOC": "Distance to real surfaces, for layers without depth, such as the camera video.", "OPTIONAL": true },
    { "NAME": "color", "TYPE": "color", "LABEL": "Color", "DOC": "Color of the fog; its alpha is the opacity of the densest fog.", "DEFAULT": [0.75, 0.79, 0.84, 1.0] },
    { "NAME": "near", "TYPE": "float", "LABEL": "From", "DOC": "Distance at which the fog begins.", "MIN": 0.0, "MAX": 50.0, "DEFAULT": 0.5, "UNIT": "m" },
    { "NAME": "far", "TYPE": "float", "LABEL": "Hidden at", "DOC": "Distance at which the fog hides 95 %, or everything with “Even”.", "MIN": 0.1, "MAX": 100.0, "DEFAULT": 6.0, "UNIT": "m" },
    { "NAME": "falloff", "TYPE": "long", "LABEL": "Growth", "DOC": "How the fog increases with distance: exponential as real fog, squared for a clear foreground and a dense background, even for a linear ramp.", "VALUES": [0, 1, 2], "LABELS": ["Exponential", "Exponential squared", "Even"], "DEFAULT": 0 },
    { "NAME": "empty", "TYPE": "float", "LABEL": "Fog on unknown depth", "DOC": "Amount of fog where the depth is unknown, such as the sky.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" }
  ]
}*/

// -ln(0.05): at "far" 5 % remain visible.
const float HIDDEN = 2.9957323;
const float LEAST_M = 0.001;

// The distance in meters; 0 where it is unknown.
float distanceHere() {
#ifdef SCRIM
  float layer = LAYER_DEPTH(inputImage, isf_FragNormCoord);
  return layer > 0.0 ? layer : ROOM_DEPTH(room, isf_FragNormCoord);
#else
  return 0.0;
#endif
}

#ifdef SCRIM_SCENE
// Linear light from display-referred sRGB (IEC 61966-2-1), per channel.
vec3 linearFromDisplay(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, vec3(lessThanEqual(color, vec3(0.04045))));
}
#endif

void main() {
  vec4 picture = IMG_THIS_PIXEL(inputImage);
  float m = distanceHere();
  float x = max(m - near, 0.0) / max(far - near, LEAST_M);
  float grown = falloff == 0 ? 1.0 - exp(-HIDDEN * x) : falloff == 1 ? 1.0 - exp(-HIDDEN * x * x) : min(x, 1.0);
  float fog = m > 0.0 ? grown : empty;
#ifdef SCRIM_SCENE
  gl_FragColor = vec4(mix(picture.rgb, linearFromDisplay(color.rgb), fog * color.a), picture.a);
#else
  gl_FragColor = vec4(mix(picture.rgb, color.rgb, fog * color.a), picture.a);
#endif
}
