import type { SessionFrame, ViewFrame } from '../../../nodes/kit/session.ts';
import type { LinkedShader } from '../../program/program.ts';
import { clearRectangle } from '../gl/clear.ts';
import { COPY_SAMPLER, COPY_SHADER, COPY_UV } from '../gl/copy-shader.ts';
import type { GlObjects } from '../gl/gl-objects.ts';
import type { PassDrawer } from '../gl/pass-drawer.ts';
import type { ProgramCache } from '../gl/program-cache.ts';
import type { PanoramaCapture } from './capture.ts';

/** Draws a ring and a disc around a direction, with the given `radius` at a distance of 1. Output is premultiplied. */
const MARKER_SHADER: LinkedShader = {
  id: 'scrim:panorama-marker',
  vertex: /* glsl */ `#version 300 es
uniform mat4 clipFromView;
uniform mat4 viewFromWorld;
uniform vec3 direction;
uniform float radius;
out vec2 place;
void main() {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec3 center = mat3(viewFromWorld) * direction;
  vec3 right = normalize(cross(center, abs(center.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0)));
  vec3 up = cross(right, center);
  gl_Position = clipFromView * vec4((center + (right * place.x + up * place.y) * radius) * 2.0, 1.0);
}
`,
  fragment: /* glsl */ `#version 300 es
precision highp float;
uniform vec4 disc;
uniform vec4 ring;
uniform float held;
in vec2 place;
out vec4 color;
vec4 over(vec4 above, vec4 below) { return above + below * (1.0 - above.a); }
void main() {
  float r = length(place);
  float soft = fwidth(r);
  float angle = atan(place.x, place.y) / 6.2831853;
  bool isHeld = (angle < 0.0 ? angle + 1.0 : angle) < held;
  vec4 around = smoothstep(0.74 - soft, 0.74, r) * smoothstep(1.0, 1.0 - soft, r) * vec4(0.05, 0.05, 0.06, 1.0) * 0.55;
  vec4 line = smoothstep(0.8 - soft, 0.8, r) * smoothstep(0.95, 0.95 - soft, r) * (isHeld ? vec4(0.25, 0.85, 0.35, 1.0) : ring);
  vec4 middle = smoothstep(0.8, 0.8 - soft, r) * disc;
  color = over(over(line, around), middle);
}
`,
};

/** Radius of the marker of a target, at a distance of 1: a quarter of the distance to the next target. */
const TARGET_RADIUS = 0.085;
const AIM_RADIUS = 0.03;

type Color = readonly [number, number, number, number];

const NOTHING: Color = [0, 0, 0, 0];
const WHITE: Color = [0.96, 0.95, 0.92, 1];
const FAINT: Color = [0.55, 0.55, 0.54, 0.6];
const GOLD: Color = [1, 0.81, 0.36, 1];
const GREEN: Color = [0.25, 0.85, 0.35, 1];
const GREEN_VEIL: Color = [0.13, 0.43, 0.18, 0.5];

/**
 * Draws the screen of the capture: the camera image, if the session shows the world by it; a marker for each target; and one where the
 * camera points.
 */
export interface MarkerDrawer {
  draw(frame: SessionFrame, world: 'device' | 'image' | 'none', capture: PanoramaCapture): void;
}

export function createMarkerDrawer(objects: GlObjects, programs: ProgramCache, drawer: PassDrawer): MarkerDrawer {
  const { gl } = objects;
  const marker = programs.acquire(MARKER_SHADER);
  const copy = programs.acquire(COPY_SHADER);
  programs.finish(marker);
  programs.finish(copy);
  const clear = new Float32Array(4);

  function drawBackground({ framebuffer }: SessionFrame, { viewport, cameraImage }: ViewFrame, world: string): void {
    const { x, y, widthPx, heightPx } = viewport;
    clearRectangle(gl, framebuffer, x, y, widthPx, heightPx, clear);
    const sampler = copy.uniform(COPY_SAMPLER);
    if (world !== 'image' || !cameraImage || !sampler) return;
    drawer.begin(framebuffer, x, y, widthPx, heightPx, 'replace');
    drawer.use(copy);
    drawer.texture(0, sampler, cameraImage.texture, 'linear');
    gl.uniformMatrix3fv(copy.uniform(COPY_UV), false, cameraImage.uvFromViewUv);
    drawer.draw();
    drawer.end();
  }

  function drawMarker(x: number, y: number, z: number, radius: number, ring: Color, disc: Color, held: number): void {
    gl.uniform3f(marker.uniform('direction'), x, y, z);
    gl.uniform1f(marker.uniform('radius'), radius);
    gl.uniform1f(marker.uniform('held'), held);
    gl.uniform4fv(marker.uniform('ring'), ring);
    gl.uniform4fv(marker.uniform('disc'), disc);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  function drawView(frame: SessionFrame, view: ViewFrame, capture: PanoramaCapture): void {
    const { x, y, widthPx, heightPx } = view.viewport;
    drawer.begin(frame.framebuffer, x, y, widthPx, heightPx, 'over');
    drawer.use(marker);
    gl.uniformMatrix4fv(marker.uniform('clipFromView'), false, view.clipFromView);
    gl.uniformMatrix4fv(marker.uniform('viewFromWorld'), false, view.viewFromWorld);
    const m = view.worldFromView;
    for (const target of capture.targets) {
      const [dx, dy, dz] = target.direction;
      // Behind the camera, the projection would mirror it.
      if ((m[8] ?? 0) * dx + (m[9] ?? 0) * dy + (m[10] ?? 0) * dz > -0.15) continue;
      const isNext = target === capture.next;
      if (target.taken) drawMarker(dx, dy, dz, TARGET_RADIUS, GREEN, GREEN_VEIL, 0);
      else drawMarker(dx, dy, dz, TARGET_RADIUS, isNext ? GOLD : FAINT, NOTHING, isNext ? capture.held : 0);
    }
    drawMarker(-(m[8] ?? 0), -(m[9] ?? 0), -(m[10] ?? 0), AIM_RADIUS, WHITE, NOTHING, 0);
    drawer.end();
  }

  return {
    draw: (frame, world, capture) => {
      for (let i = 0; i < frame.viewCount; i++) {
        const view = frame.views[i];
        if (!view) continue;
        drawBackground(frame, view, world);
        if (marker.state === 'linked') drawView(frame, view, capture);
      }
    },
  };
}
