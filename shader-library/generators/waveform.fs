/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Waveform",
  "DESCRIPTION": "Draws a sound as the line of an oscilloscope, the first channel alone; transparent beside it.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Audio", "Sound", "Oscilloscope", "Visualizer"],
  "INPUTS": [
    { "NAME": "sound", "TYPE": "audio", "MAX": 1024, "LABEL": "Sound", "DOC": "What to draw; a flat line where no wire is." },
    { "NAME": "lineColor", "TYPE": "color", "DEFAULT": [1.0, 1.0, 1.0, 1.0], "LABEL": "Line", "DOC": "Color of the line." },
    { "NAME": "thickness", "TYPE": "float", "DEFAULT": 0.01, "MIN": 0.001, "MAX": 0.1, "UNIT": "ratio", "LABEL": "Thickness", "DOC": "Half the width of the line, as part of the view's height." },
    { "NAME": "height", "TYPE": "float", "DEFAULT": 0.8, "MIN": 0.0, "MAX": 4.0, "UNIT": "ratio", "LABEL": "Height", "DOC": "How far the loudest sound reaches, as part of the view's height." }
  ]
}*/

float lineAt(float x) {
  return 0.5 + height * (IMG_NORM_PIXEL(sound, vec2(clamp(x, 0.0, 1.0), 0.25)).r - 0.5);
}

void main() {
  vec2 uv = isf_FragNormCoord;
  float pixel = 1.0 / RENDERSIZE.x;
  // Between the neighbors the line is drawn upright, so that it has no gaps where it is steep.
  float here = lineAt(uv.x);
  float left = 0.5 * (here + lineAt(uv.x - pixel));
  float right = 0.5 * (here + lineAt(uv.x + pixel));
  float below = min(here, min(left, right));
  float above = max(here, max(left, right));
  float away = max(below - uv.y, uv.y - above);
  float soft = 1.0 / RENDERSIZE.y;
  gl_FragColor = vec4(lineColor.rgb, lineColor.a * (1.0 - smoothstep(thickness - soft, thickness + soft, away)));
}
