/*{
  "ISFVSN": "2",
  "SCRIM_TITLE": "Matte",
  "DESCRIPTION": "Mixes two layers by a mask: one where the mask is bright, the other one elsewhere. Use it to apply an effect to a region only.",
  "CREDIT": "Scrim. Mask values: W3C CSS Masking Module Level 1, section 6.10",
  "CATEGORIES": ["Composite", "Choose by mask", "Mask", "Local", "Region", "Switch", "Select"],
  "SCRIM_ALPHA": "premultiplied",
  "SCRIM_DEPTH": "same",
  "SCRIM_OPAQUE": ["inside", "outside"],
  "INPUTS": [
    { "NAME": "inside", "TYPE": "image", "LABEL": "Inside", "DOC": "The layer to show where the mask is bright. The depth of the result is from this layer." },
    { "NAME": "outside", "TYPE": "image", "LABEL": "Outside", "DOC": "The layer to show elsewhere." },
    { "NAME": "mask", "TYPE": "image", "LABEL": "Mask", "DOC": "The mask: any layer, such as an Object mask, an image, a color key or a shadow." },
    { "NAME": "source", "TYPE": "long", "LABEL": "Mask by", "DOC": "Brightness: white shows “Inside” and black shows “Outside” (Rec. 709 luma times alpha). Alpha: opaque shows “Inside” and transparent shows “Outside”.", "VALUES": [0, 1], "LABELS": ["Brightness", "Alpha"], "DEFAULT": 0 },
    { "NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DOC": "Swap “Inside” and “Outside”.", "DEFAULT": false }
  ]
}*/

const vec3 LUMA_709 = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec4 within = IMG_THIS_PIXEL(inside);
  vec4 around = IMG_THIS_PIXEL(outside);
  vec4 stencil = IMG_THIS_PIXEL(mask);
  // Scrim passes premultiplied colors (SCRIM_ALPHA); other hosts pass straight alpha.
#ifndef SCRIM
  within.rgb *= within.a;
  around.rgb *= around.a;
  stencil.rgb *= stencil.a;
#endif
  float shown = source == 1 ? stencil.a : dot(stencil.rgb, LUMA_709);
  vec4 result = mix(around, within, invert ? 1.0 - shown : shown);
#ifndef SCRIM
  if (result.a > 0.0) result.rgb /= result.a;
#endif
  gl_FragColor = result;
}
