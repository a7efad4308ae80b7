import { DoubleSide, type IUniform, type Matrix4, ShaderMaterial, type Texture, type Vector3 } from 'three';
import { WINDOW } from './furniture.ts';
import type { SurfaceStyle } from './surfaces.ts';

/** What all surfaces of the room share. */
export interface StudioUniforms {
  readonly sunDirection: IUniform<Vector3>;
  /** Irradiance divided by π. */
  readonly sun: IUniform<Vector3>;
  /** 1: sunlight enters through the window only; 0: it ignores the walls. */
  readonly throughWindow: IUniform<number>;
  readonly sky: IUniform<Vector3>;
  readonly windowX: IUniform<number>;
  readonly sunMap: IUniform<Texture | null>;
  readonly sunMapFromWorld: IUniform<Matrix4>;
}

const VERTEX = `
attribute vec3 tint;
attribute vec3 irradiance;
uniform mat4 sunMapFromWorld;
varying vec2 textureUv;
varying vec3 albedoTint;
varying vec3 baked;
varying vec3 normalWorld;
varying vec3 positionWorld;
varying vec3 inSunMap;
void main() {
  textureUv = uv;
  albedoTint = tint;
  baked = irradiance;
  normalWorld = normal;
  positionWorld = position;
  inSunMap = (sunMapFromWorld * vec4(position + normal * 0.012, 1.0)).xyz * 0.5 + 0.5;
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}`;

const FRAGMENT = `
uniform sampler2D picture;
uniform highp sampler2DShadow sunMap;
uniform vec3 sunDirection;
uniform vec3 sun;
uniform float throughWindow;
uniform vec3 sky;
uniform float windowX;
uniform float gloss;
uniform float glow;
varying vec2 textureUv;
varying vec3 albedoTint;
varying vec3 baked;
varying vec3 normalWorld;
varying vec3 positionWorld;
varying vec3 inSunMap;

// Where a ray hits the plane of the window, relative to its center, in half sizes.
vec2 inWindow(vec3 direction) {
  float distanceM = (windowX - positionWorld.x) / direction.x;
  return ((positionWorld + direction * distanceM).yz - WINDOW_CENTER) / WINDOW_HALF;
}

// Four samples of the hardware's 2 × 2 comparison, a texel apart, soften the edge to about 3 cm.
float sunlight() {
  vec2 through = abs(inWindow(sunDirection)) * throughWindow;
  if (max(through.x, through.y) > 1.05) return 0.0;
  float lit = 0.0;
  for (int i = 0; i < 4; i++) {
    vec2 offset = (vec2(i & 1, i >> 1) - 0.5) * SUN_TEXEL;
    lit += texture(sunMap, vec3(inSunMap.xy + offset, inSunMap.z));
  }
  return lit * 0.25;
}

// Blurred reflection of the window's rectangle; the blur increases with distance.
float windowMirrored(vec3 direction) {
  if (direction.x > -0.02) return 0.0;
  float blur = 0.08 + 0.2 * (windowX - positionWorld.x) / direction.x;
  vec2 inside = 1.0 - smoothstep(1.0 - blur, 1.0 + blur, abs(inWindow(direction)));
  return inside.x * inside.y;
}

// A light that was moved is a lamp on the wall or the ceiling, or on what is before them: a disk of 10 degrees seen from the middle.
bool isMovedLamp() {
  return throughWindow < 0.5 && dot(normalize(positionWorld - vec3(0.0, LAMP_CENTER_Y, 0.0)), sunDirection) > LAMP_COSINE;
}

void main() {
  if (isMovedLamp()) {
    gl_FragColor = vec4(1.0);
    return;
  }
  vec3 albedo = texture(picture, textureUv).rgb * albedoTint;
  if (glow > 0.0) {
    gl_FragColor = vec4(albedo * glow, 1.0);
  } else {
    vec3 normal = normalize(normalWorld);
    vec3 towardsEye = normalize(cameraPosition - positionWorld);
    float facing = max(dot(normal, sunDirection), 0.0);
    vec3 light = baked + (facing > 0.0 ? sun * facing * sunlight() : vec3(0.0));
    // Schlick's approximation for an index of refraction of 1.5.
    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(normal, towardsEye), 0.0), 5.0);
    vec3 mirrored = gloss > 0.0 ? gloss * sky * windowMirrored(reflect(-towardsEye, normal)) : vec3(0.0);
    gl_FragColor = vec4(albedo * light + fresnel * mirrored, 1.0);
  }
  #include <colorspace_fragment>
}`;

/** The lamp of a moved light: the height of the place from which it stands in the direction of the light, and its angular radius there. */
const MOVED_LAMP = { fromM: 1.2, radiusRad: Math.PI / 36 } as const;

export function createStudioMaterial(style: SurfaceStyle, picture: Texture, sunMapPx: number, shared: StudioUniforms): ShaderMaterial {
  const vec2 = (x: number, y: number): string => `vec2(${x.toFixed(4)}, ${y.toFixed(4)})`;
  return new ShaderMaterial({
    // Leaves and curtains have no thickness.
    side: DoubleSide,
    defines: {
      LAMP_CENTER_Y: MOVED_LAMP.fromM.toFixed(2),
      LAMP_COSINE: Math.cos(MOVED_LAMP.radiusRad).toFixed(6),
      SUN_TEXEL: (1 / sunMapPx).toFixed(8),
      WINDOW_CENTER: vec2(WINDOW.centerY, WINDOW.centerZ),
      WINDOW_HALF: vec2(WINDOW.heightM / 2, WINDOW.widthM / 2),
    },
    uniforms: { ...shared, picture: { value: picture }, gloss: { value: style.gloss ?? 0 }, glow: { value: style.glow ?? 0 } },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
  });
}
