/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Exposure",
  "DESCRIPTION": "Changes the exposure of an image: each stop doubles or halves the light. Use “Keep highlights” to compress bright areas instead of clipping them.",
  "CREDIT": "Scrim. Highlights: E. Reinhard et al. 2002, Photographic Tone Reproduction for Digital Images, equation 4. Transfer function: IEC 61966-2-1",
  "CATEGORIES": ["Light", "HDR exposure", "HDR", "Brightness", "Photograph"],
  "SCRIM_ENCODING": "either",
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to expose." },
    { "NAME": "stops", "TYPE": "float", "LABEL": "Exposure", "DOC": "Exposure in stops: 1 doubles the light, -1 halves it.", "MIN": -5.0, "MAX": 5.0, "DEFAULT": 1.5, "IDENTITY": 0.0, "STEP": 0.1 },
    { "NAME": "highlights", "TYPE": "float", "LABEL": "Keep highlights", "DOC": "0 clips bright areas to white, as a sensor does; 1 compresses them so that they keep their detail.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "UNIT": "ratio" }
  ]
}*/

// Linear light from display-referred sRGB (IEC 61966-2-1), per channel.
vec3 linearFromDisplay(vec3 color) {
  return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, vec3(lessThanEqual(color, vec3(0.04045))));
}

// Display-referred sRGB from linear light (IEC 61966-2-1), per channel.
vec3 displayFromLinear(vec3 color) {
  return mix(1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, color * 12.92, vec3(lessThanEqual(color, vec3(0.0031308))));
}

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  float gain = exp2(stops);
#ifdef SCRIM_SCENE
  // A scene layer clips nothing; a Tone map compresses its highlights.
  vec3 scene = color.rgb * gain;
  gl_FragColor = vec4(mix(scene, scene / (1.0 + max(scene, 0.0)), highlights), color.a);
#else
  vec3 exposed = linearFromDisplay(color.rgb) * gain;
  // The brightest possible value stays white.
  float white = max(gain, 1.0);
  vec3 compressed = exposed * (1.0 + exposed / (white * white)) / (1.0 + exposed);
  vec3 result = mix(min(exposed, 1.0), compressed, highlights);
  gl_FragColor = vec4(displayFromLinear(clamp(result, 0.0, 1.0)), color.a);
#endif
}
