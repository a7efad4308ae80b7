/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Depth mask",
  "DESCRIPTION": "Makes a mask: white where the distance is within a range.",
  "CREDIT": "Scrim",
  "CATEGORIES": ["Mask", "Depth"],
  "SCRIM_DEPTH": "none",
  "INPUTS": [
    { "NAME": "layer", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer whose depth is read.", "OPTIONAL": true },
    { "NAME": "depth", "TYPE": "depth", "LABEL": "Room depth", "DOC": "Distance to real surfaces.", "OPTIONAL": true },
    { "NAME": "nearM", "TYPE": "float", "MIN": 0.0, "MAX": 20.0, "DEFAULT": 0.5, "UNIT": "m" },
    { "NAME": "farM", "TYPE": "float", "MIN": 0.0, "MAX": 20.0, "DEFAULT": 1.5, "UNIT": "m" },
    { "NAME": "softnessM", "TYPE": "float", "MIN": 0.0, "MAX": 5.0, "DEFAULT": 0.1, "UNIT": "m" },
    { "NAME": "invert", "TYPE": "bool", "DEFAULT": false }
  ]
}*/

// A tenth of a millimeter: a hard edge.
const float LEAST_M = 0.0001;

// The smaller of layer depth and room depth, meters along the view axis; the known one if the other is unknown; 0 if both are.
float seenM() {
  float layerM = LAYER_DEPTH(layer, isf_FragNormCoord);
  float roomM = ROOM_DEPTH(depth, isf_FragNormCoord);
  if (layerM <= 0.0) return roomM;
  return roomM > 0.0 ? min(layerM, roomM) : layerM;
}

void main() {
  float m = seenM();
  float outside = max(nearM - m, m - farM);
  float shown = m > 0.0 ? 1.0 - clamp(outside / max(softnessM, LEAST_M), 0.0, 1.0) : 0.0;
  gl_FragColor = vec4(vec3(invert ? 1.0 - shown : shown), 1.0);
}
