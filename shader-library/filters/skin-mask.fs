/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes a mask of skin of any shade: white on skin, black elsewhere. Wood, sand and orange cloth can be mistaken for skin.",
  "CREDIT": "Scrim. Rule: D. Chai and K. N. Ngan 1999, IEEE Trans. Circuits and Systems for Video Technology 9, 551. YCbCr: Rec. ITU-R BT.601",
  "CATEGORIES": ["Mask", "Key", "Skin", "Face", "Hand"],
  "INPUTS": [
    { "NAME": "inputImage", "TYPE": "image", "LABEL": "Layer", "DOC": "The layer to read, such as the camera video." },
    { "NAME": "show", "TYPE": "long", "LABEL": "Show", "DOC": "Mask: white skin on black, for a Mask node. Cut out: the image, transparent where there is no skin.", "VALUES": [0, 1], "LABELS": ["Mask", "Cut out"], "DEFAULT": 0 },
    { "NAME": "widen", "TYPE": "float", "LABEL": "Widen", "DOC": "Accepts more colors, or fewer below 0, in 8-bit steps of Cb and Cr.", "MIN": -15.0, "MAX": 30.0, "DEFAULT": 0.0 },
    { "NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DOC": "Range outside the accepted colors over which the mask fades out, in the same steps. 0 is the published rule.", "MIN": 0.0, "MAX": 30.0, "DEFAULT": 4.0 }
  ]
}*/

// Cb and Cr of BT.601 as 8-bit code values, the units of the rule: 128 is neutral.
const vec3 CB_601 = vec3(-37.7965, -74.2035, 112.0);
const vec3 CR_601 = vec3(112.0, -93.7860, -18.2140);
const float NO_COLOR = 128.0;

// The rule: Cb from 77 to 127 and Cr from 133 to 173 is skin.
const vec2 SKIN_LOW = vec2(77.0, 133.0);
const vec2 SKIN_HIGH = vec2(127.0, 173.0);

// A hard edge; values on it are skin.
const float LEAST = 0.001;

void main() {
  vec4 color = IMG_THIS_PIXEL(inputImage);
  vec2 chroma = NO_COLOR + vec2(dot(color.rgb, CB_601), dot(color.rgb, CR_601));
  vec2 outside = max(SKIN_LOW - widen - chroma, chroma - SKIN_HIGH - widen);
  float skin = clamp(1.0 - (max(outside.x, outside.y) - LEAST) / max(softness, LEAST), 0.0, 1.0);
  gl_FragColor = show == 1 ? vec4(color.rgb, color.a * skin) : vec4(vec3(skin), color.a);
}
