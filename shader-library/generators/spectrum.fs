/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Spectrum",
  "DESCRIPTION": "Draws the spectrum of a sound as bars, low frequencies on the left, on a transparent background. The frequency scale is logarithmic; the height of a bar is its level in decibels.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Audio", "Sound", "Equalizer", "Visualizer", "FFT"],
  "INPUTS": [
    { "NAME": "sound", "TYPE": "audioFFT", "MAX": 1024, "LABEL": "Sound", "DOC": "The sound to draw. Not connected: nothing is drawn." },
    { "NAME": "bars", "TYPE": "long", "DEFAULT": 32, "MIN": 1, "MAX": 64, "LABEL": "Bars", "DOC": "Number of bars." },
    { "NAME": "barColor", "TYPE": "color", "DEFAULT": [0.2, 0.8, 1.0, 1.0], "LABEL": "Bars' color", "DOC": "Color of the bars." },
    { "NAME": "gap", "TYPE": "float", "DEFAULT": 0.2, "MIN": 0.0, "MAX": 0.9, "UNIT": "ratio", "LABEL": "Gap", "DOC": "Fraction of a bar's width that is left empty." },
    { "NAME": "quietest", "TYPE": "float", "DEFAULT": -60.0, "MIN": -96.0, "MAX": -12.0, "LABEL": "Minimum level", "DOC": "Level in decibels at which a bar has no height; 0 is full level." }
  ]
}*/

void main() {
  float count = float(bars);
  float bar = min(floor(isf_FragNormCoord.x * count), count - 1.0);
  // A logarithmic scale from the second of 1024 frequency bins to the last.
  float from = pow(1024.0, bar / count);
  float to = max(pow(1024.0, (bar + 1.0) / count), from + 1.0);
  float loudest = 0.0;
  for (int i = 0; i < 8; i++) {
    float bin = mix(from, to, (float(i) + 0.5) / 8.0);
    loudest = max(loudest, IMG_NORM_PIXEL(sound, vec2(min(bin / 1024.0, 1.0), 0.25)).r);
  }
  float decibels = 20.0 * log(max(loudest, 0.00001)) / log(10.0);
  float top = clamp(1.0 - decibels / quietest, 0.0, 1.0);
  float across = fract(isf_FragNormCoord.x * count);
  bool isBar = isf_FragNormCoord.y < top && abs(across - 0.5) < 0.5 - 0.5 * gap;
  gl_FragColor = isBar ? barColor : vec4(0.0);
}
