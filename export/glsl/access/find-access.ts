import type { Access } from '../../../nodes/kit/definition.ts';
import type { IsfShader } from '../isf/isf-shader.ts';

export function findAccess(_shader: IsfShader): Access {
  return 'neighbourhood';
}
