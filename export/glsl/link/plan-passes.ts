import type { IsfPass, IsfShader } from '../isf/isf-shader.ts';
import type { PassTarget } from './linked-pass.ts';

/** A pass to draw, and the version of each buffer that it reads. */
export interface PlannedPass {
  /** `copy` copies the buffer `copyFrom` to the output; `author` runs the author's `main`. */
  readonly kind: 'author' | 'copy';
  readonly passIndex: number;
  readonly target: PassTarget;
  /** TARGET name → buffer to read. A missing name was not drawn yet and reads as transparent black. */
  readonly readable: ReadonlyMap<string, string>;
  readonly copyFrom: string | null;
}

/**
 * Plans the targets of passes. A buffer that is not persistent gets a new version with each pass that draws to it, so that no pass reads
 * its own target; a name refers to the version that an earlier pass of the frame drew. A pass without target that is not the last has no
 * effect and is left out. If the last pass draws to a buffer that others can read (it is persistent or has its own size), a copy of it is
 * the output.
 */
export function planPasses(shader: IsfShader): PlannedPass[] {
  const planned: PlannedPass[] = [];
  const last = shader.passes.length - 1;
  const readable = new Map<string, string>();
  const versions = new Map<string, number>();
  for (const pass of shader.passes) if (pass.target !== null && pass.persistent) readable.set(pass.target, pass.target);

  shader.passes.forEach((written, passIndex) => {
    const pass = withBufferSettings(written, shader);
    const sized = pass.width !== null || pass.height !== null;
    if (pass.target === null && passIndex < last) return;
    const seen = new Map(readable);
    if (passIndex === last && !pass.persistent && !sized) {
      planned.push({
        kind: 'author',
        passIndex,
        target: { kind: 'output', format: outputFormat(pass, shader) },
        readable: seen,
        copyFrom: null,
      });
      return;
    }
    const target = pass.target ?? freeName(shader, 'result');
    const version = versions.get(target) ?? 0;
    versions.set(target, version + 1);
    // Authors' names cannot contain “#”.
    const buffer = pass.persistent || version === 0 ? target : `${target}#${version}`;
    planned.push({ kind: 'author', passIndex, target: bufferTarget(pass, buffer, shader), readable: seen, copyFrom: null });
    readable.set(target, buffer);
    if (passIndex === last) {
      planned.push({
        kind: 'copy',
        passIndex,
        target: { kind: 'output', format: outputFormat(pass, shader) },
        readable: new Map(readable),
        copyFrom: target,
      });
    }
  });
  return planned;
}

/**
 * Returns a pass with the settings of its persistent buffer. The buffer is one texture, so it has the settings of whichever of its passes
 * declares them.
 */
function withBufferSettings(pass: IsfPass, shader: IsfShader): IsfPass {
  if (!pass.persistent) return pass;
  const same = shader.passes.filter((other) => other.target === pass.target);
  return {
    ...pass,
    float: same.some((other) => other.float),
    half: same.every((other) => !other.float || other.half),
    width: same.find((other) => other.width !== null)?.width ?? null,
    height: same.find((other) => other.height !== null)?.height ?? null,
  };
}

function bufferTarget(pass: IsfPass, name: string, shader: IsfShader): PassTarget {
  return { kind: 'buffer', name, format: bufferFormat(pass, shader), persistent: pass.persistent, width: pass.width, height: pass.height };
}

/** Format of a buffer. In a shader that reads scene layers, buffers contain colors of those, which 8 bits would clamp. */
function bufferFormat({ float, half }: IsfPass, { readsScene }: IsfShader): PassTarget['format'] {
  if (float && !half) return 'rgba32f';
  return float || readsScene ? 'rgba16f' : 'rgba8';
}

/** Format of the output. It contains colors, possibly above 1, for which 16 bits suffice. */
function outputFormat({ float }: IsfPass, { writesScene }: IsfShader): PassTarget['format'] {
  if (writesScene) return 'scene16f';
  return float ? 'rgba16f' : 'rgba8';
}

function freeName(shader: IsfShader, wanted: string): string {
  const taken = new Set([...shader.inputs, ...shader.imported].map((item) => item.name));
  for (const pass of shader.passes) if (pass.target !== null) taken.add(pass.target);
  let name = wanted;
  while (taken.has(name)) name += '_';
  return name;
}
