/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Blurs what is nearer or farther than the focus, as a camera lens does. It uses the depth of the layer, or of the room where the layer has none.",
  "CREDIT": "Scrim. Circle of confusion: thin lens, as in M. Potmesil and I. Chakravarty 1981, SIGGRAPH 15, 297. Gathering after D. Gustafsson 2018, Bokeh depth of field in a single pass",
  "CATEGORIES": ["Depth", "Blur", "Lens", "Bokeh", "Focus", "Defocus", "DoF"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "same",
  "SCRIM_ENCODING": "either",
  "SCRIM_OPAQUE": ["inputImage"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to blur, with depth." },
    { "NAME": "room", "TYPE": "depth", "LABEL": "Room depth", "DOC": "Distance to real surfaces, for layers without depth, such as the camera video.", "OPTIONAL": true },
    { "NAME": "focus", "TYPE": "float", "LABEL": "Focus", "DOC": "Distance at which the image is sharp.", "MIN": 0.1, "MAX": 50.0, "DEFAULT": 1.5, "UNIT": "m" },
    { "NAME": "fStop", "TYPE": "float", "LABEL": "F-stop", "DOC": "Focal length divided by the aperture diameter: a lower number blurs more.", "MIN": 0.7, "MAX": 32.0, "DEFAULT": 1.8 },
    { "NAME": "focalLength", "TYPE": "float", "LABEL": "Focal length", "DOC": "Focal length of the lens: 0.05 m is a 50 mm lens.", "MIN": 0.001, "MAX": 0.3, "DEFAULT": 0.05, "STEP": 0.001, "UNIT": "m" },
    { "NAME": "sensor", "TYPE": "float", "LABEL": "Sensor height", "DOC": "Height of the sensor: 0.024 m for full frame, about 0.006 m for phones.", "MIN": 0.002, "MAX": 0.06, "DEFAULT": 0.024, "STEP": 0.001, "UNIT": "m" },
    { "NAME": "most", "TYPE": "float", "LABEL": "Maximum blur", "DOC": "Largest radius of the blur circle, in pixels of the layer.", "MIN": 0.0, "MAX": 24.0, "DEFAULT": 16.0, "IDENTITY": 0.0, "UNIT": "px" }
  ]
}*/

const int SAMPLES = 96;
const float PI = 3.14159265;
const float GOLDEN_ANGLE = 2.39996323;

// Areas without depth count as infinitely far.
const float SKY_M = 10000.0;

// The layer at `uv`, premultiplied. Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
vec4 readLayer(vec2 uv) {
  vec4 color = IMG_NORM_PIXEL(inputImage, uv);
#ifndef SCRIM
  color.rgb *= color.a;
#endif
  return color;
}

float metersAt(vec2 uv) {
#ifdef SCRIM
  float layer = LAYER_DEPTH(inputImage, uv);
  float m = layer > 0.0 ? layer : ROOM_DEPTH(room, uv);
  return m > 0.0 ? m : SKY_M;
#else
  return focus;
#endif
}

// Radius of the circle of confusion of a point at m meters, in pixels. Its diameter on the sensor is A f |m - s| / (m (s - f)), with the
// aperture A = f / N and the focus distance s.
float circlePx(float m) {
  float opening = focalLength / fStop;
  float width = opening * focalLength * abs(m - focus) / (m * max(focus - focalLength, 0.001));
  return min(0.5 * width / sensor * RENDERSIZE.y, most);
}

// The light of a point is spread evenly over its circle, whose area is at least one pixel.
float sharePerPixel(float circle) {
  return 1.0 / max(PI * circle * circle, 1.0);
}

void main() {
  float here = metersAt(isf_FragNormCoord);
  float own = circlePx(here);
  float weights = sharePerPixel(own);
  vec4 sum = readLayer(isf_FragNormCoord) * weights;
  float ring = most / float(SAMPLES);
  for (int i = 0; i < SAMPLES; i++) {
    // Samples are dense at the center, where small circles end; each is weighted by the area that it covers.
    float away = (float(i) + 0.5) * ring;
    float turned = float(i) * GOLDEN_ANGLE;
    vec2 uv = isf_FragNormCoord + vec2(cos(turned), sin(turned)) * away / RENDERSIZE;
    float m = metersAt(uv);
    float circle = circlePx(m);
    // A blurred background does not spread over a sharper foreground.
    if (m > here) circle = min(circle, own);
    // A circle below one pixel is sharp.
    if (circle < 0.5) continue;
    float weight = clamp(circle - away + 0.5, 0.0, 1.0) * sharePerPixel(circle) * 2.0 * PI * away * ring;
    sum += readLayer(uv) * weight;
    weights += weight;
  }
  vec4 result = sum / weights;
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
