/**
 * How the depth of the room is read, an agreement between the linker, which prints it into passes, and the runtime, which puts it
 * into the materials of objects: both forms of an occlusion show the same picture because they read alike.
 *
 * Meters at a place of the room's texture, 0 where unknown. Blended, it is bilinear over the samples that are known: an unknown
 * one says nothing, and is no zero to be drawn towards. Blending is done here rather than by the sampler because many phones
 * cannot filter 32-bit floats, and none leaves out what is unknown.
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
