import { DoubleSide, ShaderMaterial, Vector3 } from 'three';
import type { MovableLight } from './movable-light.ts';

const VERTEX = `
varying vec3 positionWorld;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  positionWorld = world.xyz;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

/** Flat shading from screen-space derivatives, for scans without normals, and a faint grid every 25 cm that makes motion visible. */
const FRAGMENT = `
uniform vec3 albedo;
uniform vec3 towardsLightWorld;
uniform vec3 lightIntensity;
varying vec3 positionWorld;

float gridLine(float meters) {
  float cells = meters * 4.0;
  float width = fwidth(cells);
  return (1.0 - smoothstep(0.0, max(1.5 * width, 0.02), abs(fract(cells + 0.5) - 0.5))) * smoothstep(0.5, 0.1, width);
}

void main() {
  vec3 normal = normalize(cross(dFdx(positionWorld), dFdy(positionWorld)));
  if (dot(normal, cameraPosition - positionWorld) < 0.0) normal = -normal;
  vec3 across = 1.0 - smoothstep(0.6, 0.9, abs(normal));
  float grid = max(max(gridLine(positionWorld.x) * across.x, gridLine(positionWorld.y) * across.y), gridLine(positionWorld.z) * across.z);
  vec3 ambient = mix(vec3(0.20, 0.19, 0.18), vec3(0.42, 0.44, 0.47), normal.y * 0.5 + 0.5);
  vec3 light = ambient + lightIntensity / PI * max(dot(normal, towardsLightWorld), 0.0);
  gl_FragColor = vec4(albedo * light * (1.0 - 0.1 * grid), 1.0);
  #include <colorspace_fragment>
}`;

/** Material for rooms without textures. `albedo` is linear-sRGB. */
export function createScanMaterial(albedo: readonly [number, number, number], { light, towardsWorld }: MovableLight): ShaderMaterial {
  return new ShaderMaterial({
    side: DoubleSide,
    defines: { PI: Math.PI },
    uniforms: {
      albedo: { value: new Vector3(...albedo) },
      towardsLightWorld: { value: towardsWorld },
      lightIntensity: { value: new Vector3(...light.intensity) },
    },
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
  });
}
