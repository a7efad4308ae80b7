/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Waveform",
  "DESCRIPTION": "Draws the waveform of a sound as a line, as an oscilloscope does, on a transparent background. It shows the first channel.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Audio", "Sound", "Oscilloscope", "Visualizer"],
  "INPUTS": [
    { "NAME": "sound", "TYPE": "audio", "MAX": 1024, "LABEL": "Sound", "DOC": "The sound to draw. Not connected: a flat line." },
    { "NAME": "lineColor", "TYPE": "color", "DEFAULT": [1.0, 1.0, 1.0, 1.0], "LABEL": "Line", "DOC": "Color of the line." },
    { "NAME": "thickness", "TYPE": "float", "DEFAULT": 0.01, "MIN": 0.001, "MAX": 0.1, "UNIT": "ratio", "LABEL": "Thickness", "DOC": "Half the width of the line, as a fraction of the view height." },
    { "NAME": "height", "TYPE": "float", "DEFAULT": 0.8, "MIN": 0.0, "MAX": 4.0, "UNIT": "ratio", "LABEL": "Height", "DOC": "Amplitude of the loudest sound, as a fraction of the view height." }
  ]
}*/

float lineAt(float x) {
  return 0.5 + height * (IMG_NORM_PIXEL(sound, vec2(clamp(x, 0.0, 1.0), 0.25)).r - 0.5);
}

void main() {
  vec2 uv = isf_FragNormCoord;
  float pixel = 1.0 / RENDERSIZE.x;
  // The line covers the range between neighboring samples, so that it has no gaps where it is steep.
  float here = lineAt(uv.x);
  float left = 0.5 * (here + lineAt(uv.x - pixel));
  float right = 0.5 * (here + lineAt(uv.x + pixel));
  float below = min(here, min(left, right));
  float above = max(here, max(left, right));
  float away = max(below - uv.y, uv.y - above);
  float soft = 1.0 / RENDERSIZE.y;
  gl_FragColor = vec4(lineColor.rgb, lineColor.a * (1.0 - smoothstep(thickness - soft, thickness + soft, away)));
}
