/**
 * GLSL function that reads room depth. It is shared by the linker, which adds it to passes, and the runtime, which adds it to materials of
 * objects, so that both forms of an occlusion look the same.
 *
 * It returns meters at a texture coordinate of the room depth, 0 where unknown. With interpolation it is bilinear over the known samples;
 * unknown samples are ignored instead of counting as 0. The sampler cannot do this, because many phones cannot filter 32-bit floats and
 * none ignores unknown samples.
 */
export const ROOM_DEPTH_TEXT = `float scrim_roomM(sampler2D room, bool interpolate, vec2 at) {
  ivec2 last = textureSize(room, 0) - 1;
  if (!interpolate) return texelFetch(room, clamp(ivec2(floor(at * vec2(last + 1))), ivec2(0), last), 0).r;
  vec2 texel = at * vec2(last + 1) - 0.5;
  ivec2 low = ivec2(floor(texel));
  vec2 part = texel - vec2(low);
  ivec2 a = clamp(low, ivec2(0), last);
  ivec2 b = clamp(low + 1, ivec2(0), last);
  vec4 m = vec4(
    texelFetch(room, a, 0).r, texelFetch(room, ivec2(b.x, a.y), 0).r,
    texelFetch(room, ivec2(a.x, b.y), 0).r, texelFetch(room, b, 0).r);
  vec4 weight = vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y, part.x * part.y);
  weight *= vec4(greaterThan(m, vec4(0.0)));
  float total = dot(weight, vec4(1.0));
  return total > 0.0 ? dot(weight, m) / total : 0.0;
}`;
