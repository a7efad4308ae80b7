/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Depth merge",
  "DESCRIPTION": "Puts two layers together by their depth: each pixel shows the nearer one in front, so two captured places, or a place and objects, go through one another. What has no depth is behind what has it; where neither has, the first is in front. Objects of one “Scene” need no merge.",
  "CREDIT": "Scrim. Duff, “Compositing 3-D rendered images”, SIGGRAPH 1985",
  "CATEGORIES": ["Merge", "Depth", "Z combine", "Z merge", "Z-buffer", "Nearer", "Layer"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "nearer",
  "SCRIM_ENCODING": "either",
  "SCRIM_OPAQUE": ["second"],
  "INPUTS": [
    { "NAME": "first", "TYPE": "image", "LABEL": "First", "DOC": "A layer with depth." },
    { "NAME": "second", "TYPE": "image", "LABEL": "Second", "DOC": "Another layer with depth." }
  ]
}*/

void main() {
  vec4 a = IMG_THIS_PIXEL(first);
  vec4 b = IMG_THIS_PIXEL(second);
  bool isFirst = true;
  // Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha, and know no depth.
#ifdef SCRIM
  float depthA = LAYER_DEPTH(first, isf_FragNormCoord);
  float depthB = LAYER_DEPTH(second, isf_FragNormCoord);
  isFirst = depthB <= 0.0 || (depthA > 0.0 && depthA <= depthB);
#else
  a.rgb *= a.a;
  b.rgb *= b.a;
#endif
  vec4 near = isFirst ? a : b;
  vec4 far = isFirst ? b : a;
  vec4 result = near + far * (1.0 - near.a);
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
