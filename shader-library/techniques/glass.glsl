/*{
  "DESCRIPTION": "Draws objects as glass: it refracts the objects behind it and the layer behind the scene at both surfaces, reflects the environment, most at the edges, and shows highlights of the lights. Connect the layer behind the objects, such as the camera video; without it, glass that no object is behind is transparent and does not refract, unless the scene has a layer for glass.",
  "CREDIT": "Scrim. Refraction: Snell's law at the near and the far side, taking the object for a ball or a pane; Fresnel's equations for glass; color: Beer's law",
  "CATEGORIES": ["Glass", "Refraction", "Fresnel", "Lens", "Crystal", "Water", "Transparent", "Ice"],
  "PASSES": [{ "SIDE": "front" }],
  "INPUTS": [
    { "NAME": "behind", "TYPE": "image", "LABEL": "Behind", "DOC": "The layer that is visible through the glass where no object is behind it. Not connected: that of the scene.", "OPTIONAL": true },
    { "NAME": "ior", "TYPE": "float", "LABEL": "Index", "DOC": "Index of refraction: 1 is air, 1.33 water, 1.5 glass, 2.4 diamond.", "MIN": 1.0, "MAX": 2.5, "DEFAULT": 1.5, "IDENTITY": 1.0 },
    { "NAME": "shape", "TYPE": "long", "LABEL": "Shape", "DOC": "Assumed shape of the object: a ball shows the background upside down, a pane shifts it.", "VALUES": [0, 1], "LABELS": ["Ball", "Pane"], "DEFAULT": 0 },
    { "NAME": "thicknessM", "TYPE": "float", "LABEL": "Thickness", "DOC": "Distance from the front to the back surface where the object is thickest.", "MIN": 0.0, "MAX": 2.0, "DEFAULT": 0.1, "UNIT": "m" },
    { "NAME": "behindM", "TYPE": "float", "LABEL": "Distance behind", "DOC": "Distance from the camera to what is visible through the glass.", "MIN": 0.1, "MAX": 100.0, "DEFAULT": 2.5, "UNIT": "m" },
    { "NAME": "tint", "TYPE": "color", "LABEL": "Tint", "DOC": "Color of white light after it has passed through the full thickness.", "DEFAULT": [0.93, 0.985, 0.97, 1.0] },
    { "NAME": "dispersion", "TYPE": "float", "LABEL": "Dispersion", "DOC": "Difference of the index between red and blue. It adds color fringes at edges.", "MIN": 0.0, "MAX": 0.2, "DEFAULT": 0.01, "IDENTITY": 0.0 },
    { "NAME": "shine", "TYPE": "float", "LABEL": "Shine", "DOC": "Brightness of the lights' reflections.", "MIN": 0.0, "MAX": 2.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "mirror", "TYPE": "float", "LABEL": "Mirror", "DOC": "Brightness of the reflected environment.", "MIN": 0.0, "MAX": 2.0, "DEFAULT": 1.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "roughness", "TYPE": "float", "LABEL": "Roughness", "DOC": "How much the surface blurs what is visible through it and what it reflects.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.0, "IDENTITY": 0.0, "UNIT": "ratio" },
    { "NAME": "haze", "TYPE": "float", "LABEL": "Haze", "DOC": "How milky the glass is. Milky glass receives shadows.", "MIN": 0.0, "MAX": 1.0, "DEFAULT": 0.03, "IDENTITY": 0.0, "UNIT": "ratio" }
  ]
}*/
#include <light/diffuse>
#include <light/fresnel>

// The point where the ray leaves the glass, and its direction.
struct Way { vec3 end; vec3 direction; float lengthM; };

Way wayThrough(const in Surface s, const in float index) {
  vec3 inside = refract(-s.towardsEye, s.normal, 1.0 / index);
  float down = max(dot(-s.normal, inside), 0.0);
  // In a pane, the path is longer at grazing angles, and the direction does not change.
  if (shape == 1) {
    float through = thicknessM / max(down, 0.05);
    return Way(s.position + inside * through, -s.towardsEye, through);
  }
  float chord = thicknessM * down;
  vec3 end = s.position + inside * chord;
  vec3 outside = normalize(end - (s.position - s.normal * (0.5 * thicknessM)) + inside * 0.000001);
  return Way(end, refract(inside, -outside, index), chord);
}

// Glass of index 1 does not blur.
float blur() {
  return roughness * clamp(ior * 2.0 - 2.0, 0.0, 1.0);
}

// Objects over the layer, premultiplied. Beyond the edge of the image, mirror it: this looks better than repeating the last pixel.
vec4 layerAt(const in vec2 viewUv) {
  vec2 uv = 1.0 - abs(1.0 - mod(viewUv, 2.0));
  vec4 objects = BEHIND(uv, blur());
  vec4 layer = IMG_NORM_PIXEL(behind, uv);
  // What is behind often contains the layer already.
  float rest = max(layer.a - objects.a, 0.0);
  return vec4(objects.rgb + layer.rgb * rest, objects.a + rest);
}

vec4 seenBehind(const in Way way) {
  float depth = VIEW_DEPTH(way.end);
  // Rays that turn away from the view continue to its edge.
  float perMeter = max(VIEW_DEPTH(way.end + way.direction) - depth, 0.05);
  vec2 uv = VIEW_UV(way.end + way.direction * (max(behindM - depth, 0.0) / perMeter));
  // Where the glass minifies the background, one pixel covers many pixels of the layer.
  vec2 apartX = clamp(0.25 * dFdx(uv), -0.02, 0.02);
  vec2 apartY = clamp(0.25 * dFdy(uv), -0.02, 0.02);
  return 0.25 * (layerAt(uv + apartX + apartY) + layerAt(uv + apartX - apartY) + layerAt(uv - apartX + apartY) + layerAt(uv - apartX - apartY));
}

vec4 surface(const in Surface s) {
  float facing = max(dot(s.normal, s.towardsEye), 0.0);
  Way way = wayThrough(s, ior);
  vec4 seen = seenBehind(way);
  if (dispersion > 0.0) {
    seen.r = seenBehind(wayThrough(s, max(ior - 0.5 * dispersion, 1.0))).r;
    seen.b = seenBehind(wayThrough(s, ior + 0.5 * dispersion)).b;
  }
  float reflected = fresnelAir(facing, ior);
  vec3 passed = pow(max(tint.rgb, 0.001), vec3(thicknessM > 0.0 ? way.lengthM / thicknessM : 0.0)) * (1.0 - reflected);

  vec3 mirrored = reflect(-s.towardsEye, s.normal);
  vec3 around = mirror * REFLECTION(mirrored, roughness);
  vec3 lights = vec3(0.0);
  float sharpness = min(900.0, 2.0 / max(roughness * roughness * roughness * roughness, 0.0001));
  for (int i = 0; i < LIGHT_COUNT; i++) {
    Light light = LIGHT(i);
    // A highlight of the size of a lamp in a room, with a halo.
    float towards = max(dot(mirrored, light.towards), 0.0);
    lights += light.radiance * light.lit * (pow(towards, sharpness) * sharpness / 900.0 + 0.05 * pow(towards, min(60.0, sharpness)));
  }
  vec3 milk = haze * diffuseLight(s.normal);
  float clear = (1.0 - seen.a) * dot(passed, vec3(0.2126, 0.7152, 0.0722)) * (1.0 - haze);
  vec3 color = passed * (1.0 - haze) * seen.rgb + reflected * around + max(reflected, 0.04) * shine * 4.0 * lights + milk;
  // Added light needs no alpha, but a premultiplied layer can contain only as much light as its alpha.
  float alpha = clamp(max(1.0 - clear, max(color.r, max(color.g, color.b))), 0.0, 1.0);
  return vec4(color / max(alpha, 0.001), alpha);
}
